// Products of matrices by wide instructions. A set of instructions brings its own function, compiled apart; nothing but
// plain numbers and pointers passes between.
#pragma once

#include <cstddef>

namespace tread::inference {

// A matrix in memory: element (i, k) is data[i * down + k * across].
struct Operand {
    const double* data;
    std::ptrdiff_t down, across;
};

// C += factor * A * B with C of `rows` x `columns`, the columns of which are `stride` apart.
struct Product {
    Operand a, b;
    double* c;
    std::ptrdiff_t stride, rows, columns, inner;
    double factor;
    bool lower_only;  // C above the diagonal need not be computed
};

// `room`: for this many numbers, at the beginning of a line of the cache.
using AddProduct = void (*)(const Product& product, double* room);
inline constexpr std::size_t kRoomOfProduct = 3 << 15;

void addProductByAvx2(const Product& product, double* room);
void addProductByAvx512(const Product& product, double* room);

// The widest that the processor knows; nullptr: none.
AddProduct widestProduct();

}  // namespace tread::inference
