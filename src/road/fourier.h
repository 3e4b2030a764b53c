// Sum of waves at evenly spaced points, with the same bits on every machine.
#pragma once

#include <vector>

namespace tread {

// Real and imaginary parts apart: where they alternate, g++ 12 fuses products and sums (vfmaddsub) even when it is told
// not to (-ffp-contract=off).
struct ComplexNumbers {
    std::vector<double> real;
    std::vector<double> imaginary;
};

// The sums over k of waves[k] e^(2 pi i j k / N), j = 0 ... N - 1, in place of the N waves; N is a power of 2.
void sumWaves(ComplexNumbers& waves);

}  // namespace tread
