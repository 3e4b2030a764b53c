// The step of four tyres for processors with AVX2; CMakeLists.txt gives this file the compiler's option.
#define TREAD_ISA avx2
#include "tyre/four_tyres_step.h"

namespace tread {

PerWheel<TyreForces> takeWithAvx2(const FourTyresStep& step);

PerWheel<TyreForces> takeWithAvx2(const FourTyresStep& step) {
    return take(step);
}

}  // namespace tread
