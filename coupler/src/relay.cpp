#include "relay.hpp"

#include <algorithm>
#include <utility>

#include "tags.hpp"

namespace slidewave {

void Relay::send(long window, DemSums sums, std::vector<Quantity> const& columns) {
  channel_.finish("the last row");
  if (!std::exchange(named_, true)) {  // names travel once
    for (Quantity const& column : columns) {
      names_ += column.name + "\n";
    }
    session_.agreement.send_text(names_, "names of the dem columns");
  }
  buffer_ = {stamp(window, tag::row), static_cast<double>(columns.size())};
  buffer_.insert(buffer_.end(), numbers_of(sums), numbers_of(sums) + count_of<DemSums>());
  for (Quantity const& column : columns) {
    buffer_.push_back(column.value);
  }
  channel_.send(0, buffer_, tag::row);
}

void Relay::receive(long window, DemSums& sums, std::vector<Quantity>& columns) {
  if (!std::exchange(named_, true)) {
    columns.clear();
    std::string const names = session_.agreement.receive_text("names of the dem columns");
    for (std::size_t begin = 0; begin < names.size();) {
      std::size_t const end = names.find('\n', begin);
      columns.push_back({names.substr(begin, end - begin), 0});
      begin = end + 1;
    }
  }
  channel_.receive(0, tag::row, window, buffer_, "the row for history.csv");
  double const* in = buffer_.data() + header_size;
  std::copy_n(in, count_of<DemSums>(), numbers_of(sums));
  in += count_of<DemSums>();
  if (static_cast<std::size_t>(buffer_[1]) != columns.size()) {
    throw std::runtime_error("the particle engine changed its quantities during the run");
  }
  for (Quantity& column : columns) {
    column.value = *in++;
  }
}

}  // namespace slidewave
