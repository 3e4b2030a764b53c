// Products for processors with AVX-512; CMakeLists.txt gives this file the compiler's options.
#define TREAD_ISA avx512
#include "inference/wide/product_by_packs.h"

namespace tread::inference {

void addProductByAvx512(const Product& product, double* room) {
    avx512::Packs<8>::add(product, room);
}

}  // namespace tread::inference
