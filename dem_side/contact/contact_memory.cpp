#include "contact_memory.h"

namespace slidewave::dem {

double const* ContactMemory::find(std::size_t particle, int partner,
                                  std::array<double, 3> const& branch, double reach_m) const {
  Place const& place = places_[particle];
  double const* one = pool_.data() + place.start;
  for (std::size_t n = 0; n < place.count; ++n, one += record()) {
    if (static_cast<int>(one[0]) != partner) {
      continue;
    }
    double square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      square += (one[k + 1] - branch[k]) * (one[k + 1] - branch[k]);
    }
    if (square < reach_m * reach_m) {
      return one + head;
    }
  }
  return nullptr;
}

}  // namespace slidewave::dem
