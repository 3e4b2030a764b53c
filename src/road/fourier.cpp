// The fast Fourier transform of J.W. Cooley and J.W. Tukey, An algorithm for the machine calculation of complex Fourier
// series, Mathematics of Computation 19, 1965.
#include "road/fourier.h"

#include <numbers>
#include <utility>

#include "base/math/elementary.h"

namespace tread {
namespace {

// Each to the place whose binary digits are those of its own in reverse.
void reverseOrder(std::vector<double>& numbers) {
    for (std::size_t i = 1, reversed = 0; i < numbers.size(); ++i) {
        std::size_t bit = numbers.size() >> 1;
        for (; reversed & bit; bit >>= 1) reversed ^= bit;
        reversed ^= bit;
        if (i < reversed) std::swap(numbers[i], numbers[reversed]);
    }
}

}  // namespace

void sumWaves(ComplexNumbers& waves) {
    const std::size_t size = waves.real.size();
    std::vector<double> sines(size / 2), cosines(size / 2);
    for (std::size_t k = 0; k < size / 2; ++k) {
        const double turn = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(size);
        sines[k] = sine(turn);
        cosines[k] = cosine(turn);
    }

    reverseOrder(waves.real);
    reverseOrder(waves.imaginary);
    for (std::size_t half = 1; half < size; half *= 2) {
        const std::size_t stride = size / (2 * half);
        for (std::size_t begin = 0; begin < size; begin += 2 * half) {
            for (std::size_t k = 0; k < half; ++k) {
                const double s = sines[k * stride], c = cosines[k * stride];
                const std::size_t a = begin + k, b = a + half;
                const double real = c * waves.real[b] - s * waves.imaginary[b];
                const double imaginary = c * waves.imaginary[b] + s * waves.real[b];
                waves.real[b] = waves.real[a] - real;
                waves.imaginary[b] = waves.imaginary[a] - imaginary;
                waves.real[a] += real;
                waves.imaginary[a] += imaginary;
            }
        }
    }
}

}  // namespace tread
