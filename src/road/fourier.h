// Sum of waves at evenly spaced points, with the same bits on every machine.
#pragma once

#include <vector>

namespace tread {

struct ComplexNumber {
    double real = 0;
    double imaginary = 0;
};

// The sums over k of waves[k] e^(2 pi i j k / N), j = 0 ... N - 1, in place of the N waves; N is a power of 2.
void sumWaves(std::vector<ComplexNumber>& waves);

}  // namespace tread
