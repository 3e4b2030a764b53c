// The product of two matrices by packs of doubles. A file of its own per set of instructions includes this in a
// namespace of its own (TREAD_ISA), as base/math/lanes.h explains.
//
// Both operands are copied into panels that lie in memory as they are read, then each tile of C is computed in
// registers: three packs high, as wide as registers are left (K. Goto & R. van de Geijn, Anatomy of high-performance
// matrix multiplication, 2008). The order of the sums depends on the sizes alone.
#pragma once

#include <cstddef>

#include "inference/wide/product.h"

namespace tread::inference::TREAD_ISA {
namespace {

using Index = std::ptrdiff_t;

// Not std::min: the linker might take what is compiled here for other processors.
Index least(Index a, Index b) {
    return a < b ? a : b;
}

template <int N>
struct Packs {
    typedef double Pack __attribute__((vector_size(8 * N)));
    typedef double Unaligned __attribute__((vector_size(8 * N), aligned(8), may_alias));
    static constexpr Index kHigh = 3;                  // packs
    static constexpr Index kRows = kHigh * N;          // of a tile
    static constexpr Index kColumns = N == 8 ? 8 : 4;  // of a tile: 24 of 32 registers, or 12 of 16, hold it
    static constexpr Index kInner = 256;               // of the panels
    static constexpr Index kRowsAtOnce = 96;           // panels of A together stay in the cache of the second level
    static constexpr Index kColumnsAtOnce = 256;

    // Copies a block into panels of `width`: what lies beside its edge is 0. `along`: direction of the sum.
    template <Index width>
    static void arrange(const double* from, Index across, Index along, Index count, Index inner, double* to) {
        for (Index first = 0; first < count; first += width) {
            const Index here = least(width, count - first);
            for (Index p = 0; p < inner; ++p, to += width) {
                const double* source = from + first * across + p * along;
                for (Index i = 0; i < here; ++i) to[i] = source[i * across];
                for (Index i = here; i < width; ++i) to[i] = 0;
            }
        }
    }

    // A whole tile, rows and columns as far as C has them.
    static void tile(const double* a, const double* b, Index inner, double factor, double* c, Index stride, Index rows,
                     Index columns) {
        Pack sum[kColumns][kHigh] = {};
        for (Index p = 0; p < inner; ++p, a += kRows, b += kColumns) {
            Pack column[kHigh];
#pragma GCC unroll 3
            for (Index i = 0; i < kHigh; ++i) column[i] = *reinterpret_cast<const Unaligned*>(a + i * N);
#pragma GCC unroll 8
            for (Index k = 0; k < kColumns; ++k) {
                const Pack all = b[k] - Pack{};
#pragma GCC unroll 3
                for (Index i = 0; i < kHigh; ++i) sum[k][i] += column[i] * all;
            }
        }
        if (rows == kRows && columns == kColumns) {
#pragma GCC unroll 8
            for (Index k = 0; k < kColumns; ++k) {
#pragma GCC unroll 3
                for (Index i = 0; i < kHigh; ++i) {
                    Unaligned* place = reinterpret_cast<Unaligned*>(c + k * stride + i * N);
                    *place = *place + factor * sum[k][i];
                }
            }
            return;
        }
        alignas(8 * N) double whole[kColumns][kRows];
        __builtin_memcpy(whole, sum, sizeof whole);
        for (Index k = 0; k < columns; ++k)
            for (Index i = 0; i < rows; ++i) c[k * stride + i] += factor * whole[k][i];
    }

    static void add(const Product& product, double* room) {
        double* const panels_of_a = room;
        double* const panels_of_b = room + kRowsAtOnce * kInner;
        static_assert(kInner * (kRowsAtOnce + kColumnsAtOnce) <= static_cast<Index>(kRoomOfProduct));
        const auto& [a, b, c, stride, rows, columns, inner, factor, lower_only] = product;
        for (Index j = 0; j < columns; j += kColumnsAtOnce) {
            const Index wide = least(kColumnsAtOnce, columns - j);
            for (Index p = 0; p < inner; p += kInner) {
                const Index deep = least(kInner, inner - p);
                arrange<kColumns>(b.data + p * b.down + j * b.across, b.across, b.down, wide, deep, panels_of_b);
                for (Index i = lower_only ? j / kRowsAtOnce * kRowsAtOnce : 0; i < rows; i += kRowsAtOnce) {
                    const Index high = least(kRowsAtOnce, rows - i);
                    arrange<kRows>(a.data + i * a.down + p * a.across, a.down, a.across, high, deep, panels_of_a);
                    for (Index k = 0; k < wide; k += kColumns) {
                        for (Index r = 0; r < high; r += kRows) {
                            if (lower_only && i + r + kRows <= j + k) continue;
                            tile(panels_of_a + r * deep, panels_of_b + k * deep, deep, factor,
                                 c + i + r + (j + k) * stride, stride, least(kRows, high - r),
                                 least(kColumns, wide - k));
                        }
                    }
                }
            }
        }
    }
};

}  // namespace
}  // namespace tread::inference::TREAD_ISA
