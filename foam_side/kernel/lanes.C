#include "lanes.H"

namespace slidewave::foam {

namespace any_machine {
extern LaneLoops const loops;
}
#ifdef SLIDEWAVE_HAS_AVX2
namespace avx2 {
extern LaneLoops const loops;
}
#endif

LaneLoops const& plainLoops() {
  return any_machine::loops;
}

LaneLoops const& laneLoops() {
#ifdef SLIDEWAVE_HAS_AVX2
  static bool const fast = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (fast) return avx2::loops;
#endif
  return any_machine::loops;
}

}  // namespace slidewave::foam
