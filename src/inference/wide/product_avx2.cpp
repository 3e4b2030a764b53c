// Products for processors with AVX2 and FMA; CMakeLists.txt gives this file the compiler's options.
#define TREAD_ISA avx2
#include "inference/wide/product_by_packs.h"

namespace tread::inference {

void addProductByAvx2(const Product& product, double* room) {
    avx2::Packs<4>::add(product, room);
}

}  // namespace tread::inference
