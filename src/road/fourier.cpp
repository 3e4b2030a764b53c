// The fast Fourier transform of J.W. Cooley and J.W. Tukey, An algorithm for the machine calculation of complex Fourier
// series, Mathematics of Computation 19, 1965.
#include "road/fourier.h"

#include <numbers>
#include <utility>

#include "base/elementary.h"

namespace tread {
namespace {

// Each to the place whose binary digits are those of its own in reverse.
void reverseOrder(std::vector<ComplexNumber>& waves) {
    for (std::size_t i = 1, reversed = 0; i < waves.size(); ++i) {
        std::size_t bit = waves.size() >> 1;
        for (; reversed & bit; bit >>= 1) reversed ^= bit;
        reversed ^= bit;
        if (i < reversed) std::swap(waves[i], waves[reversed]);
    }
}

}  // namespace

void sumWaves(std::vector<ComplexNumber>& waves) {
    const std::size_t size = waves.size();
    std::vector<SineCosine<double>> turns(size / 2);
    for (std::size_t k = 0; k < turns.size(); ++k)
        turns[k] = sineCosine(2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(size));

    reverseOrder(waves);
    for (std::size_t half = 1; half < size; half *= 2) {
        const std::size_t stride = size / (2 * half);
        for (std::size_t begin = 0; begin < size; begin += 2 * half) {
            for (std::size_t k = 0; k < half; ++k) {
                const SineCosine<double>& turn = turns[k * stride];
                ComplexNumber &a = waves[begin + k], &b = waves[begin + k + half];
                const ComplexNumber turned{turn.cosine * b.real - turn.sine * b.imaginary,
                                           turn.cosine * b.imaginary + turn.sine * b.real};
                b = {a.real - turned.real, a.imaginary - turned.imaginary};
                a = {a.real + turned.real, a.imaginary + turned.imaginary};
            }
        }
    }
}

}  // namespace tread
