// Eight cars at once, for processors with AVX-512; CMakeLists.txt gives this file the compiler's options.
#define TREAD_ISA avx512
// Eigen's vectors are only named here; they have to lie in memory as they do elsewhere.
#define EIGEN_DONT_VECTORIZE
#define EIGEN_MAX_STATIC_ALIGN_BYTES 16
#include "vehicle/fleet/lane_cars.h"

namespace tread {

extern const LaneKind kEightLanes;
constinit const LaneKind kEightLanes = kKindOf<LanesOf<8>>;

}  // namespace tread
