// What a rank may ask for at the end of a window: where one asks, all do it.
#pragma once

namespace slidewave {

struct Wishes {
  bool stop = false;
  bool checkpoint = false;
};

}  // namespace slidewave
