#include "road/roughness.h"

#include <cmath>
#include <numbers>

#include "base/math/elementary.h"
#include "base/math/power.h"
#include "base/math/random.h"
#include "road/fade.h"
#include "road/fourier.h"

namespace tread {
namespace {

constexpr double kPi = std::numbers::pi;

// ISO 8608: geometric mean of class A at the reference wave number.
constexpr double kReference = 0.1;  // cycles/m
constexpr double kClassA = 16e-6;   // m3

// A spline through points 0.05 m apart carries waves down to 0.2 m (a quarter of its sampling frequency) within 1 %.
constexpr std::size_t kNodes = 65536;
constexpr double kSpacing = 0.05;      // m
constexpr double kLowest = 1 / 128.0;  // cycles/m
constexpr double kHighest = 5;         // cycles/m
constexpr double kFarthest = 1e12;     // m, where a double still knows a node from the next
constexpr double kFade = 10;           // m, over which the roughness begins

double sinc(double x) {
    return x == 0 ? 1 : sine(kPi * x) / (kPi * x);
}

// Response of the cubic B-spline at its own nodes, to which the coefficients are matched.
double splineAtNodes(double wave_number) {
    return (2 + cosine(2 * kPi * wave_number * kSpacing)) / 3;
}

// Coherence of the wheel paths of an isotropic surface over x (roughness.h): with (x/2)^v K_v(x) as an integral over
// u = e^t (M. Abramowitz, I.A. Stegun, Handbook of mathematical functions, 9.6.24 and 6.1.1),
//     g = integral of e^(v t - u - x^2 / 4 u) dt / integral of e^(v t - u) dt.
class IsotropicCoherence {
public:
    explicit IsotropicCoherence(double waviness) {
        const double v = 0.5 * waviness;
        for (double t = kLast; v * t > -kNegligible; t -= kStep) {
            const double u = exponential(t);
            nodes_.push_back({exponential(v * t - u), 1 / u});
            whole_ += nodes_.back().weight;
        }
    }

    double operator()(double x) const {
        double sum = 0;
        for (const Node& node : nodes_) {
            const double exponent = 0.25 * x * x * node.inverse;
            if (exponent > kNegligible) break;  // and so are all further ones
            sum += node.weight * exponential(-exponent);
        }
        return sum / whole_;
    }

private:
    // The trapezoidal rule errs by about e^(-pi^2 / step): the integrand has no singularity within pi/2 of the axis.
    static constexpr double kStep = 0.25;
    static constexpr double kNegligible = 41;  // e^-41 is below the rounding of 1
    static constexpr double kLast = 4;         // e^-e^4 is far below that

    struct Node {
        double weight;
        double inverse;
    };
    std::vector<Node> nodes_;
    double whole_ = 0;
};

double coherence(const RoughnessParams& params, const IsotropicCoherence& isotropic, double wave_number) {
    if (params.coherence == Coherence::equal) return 1;
    if (params.coherence == Coherence::independent) return 0;
    return isotropic(2 * kPi * wave_number * params.track);
}

std::size_t wrapped(long node) {
    static_assert((kNodes & (kNodes - 1)) == 0);
    return static_cast<std::size_t>(node) & (kNodes - 1);
}

}  // namespace

bool isRough(const RoughnessParams& params) {
    return displacementPsd(params, kReference) > 0;
}

double displacementPsd(const RoughnessParams& params, double wave_number) {
    if (!params.unevenness && params.road_class == RoadClass::none) return 0;
    const int steps = static_cast<int>(params.road_class) - static_cast<int>(RoadClass::A);
    const double level = params.unevenness.value_or(kClassA * power(4, steps));
    return level * power(wave_number / kReference, -params.waviness);
}

double wheelPathCoherence(const RoughnessParams& params, double wave_number) {
    return coherence(params, IsotropicCoherence(params.waviness), wave_number);
}

Roughness::Roughness(const RoughnessParams& params, double contact_length)
    : wave_across_(kPi / params.track), begin_(params.begin), itself_(kNodes), averaged_(kNodes) {
    constexpr std::size_t kProfiles = 3;
    const double step = 1 / (static_cast<double>(kNodes) * kSpacing);  // cycles/m
    // Of each profile, the waves that are to add up to the profile itself in the real part and to the averaged one in
    // the imaginary part.
    std::array<ComplexNumbers, kProfiles> waves;
    waves.fill({std::vector<double>(kNodes), std::vector<double>(kNodes)});

    // Every third frequency belongs to one profile: their sums have the wanted PSD exactly, not only in the mean.
    Random random(static_cast<std::uint64_t>(params.seed));
    const IsotropicCoherence isotropic(params.waviness);
    const double across = sinc(0.5 * contact_length / params.track);
    for (std::size_t k = 1; static_cast<double>(k) * step <= kHighest; ++k) {
        const double n = static_cast<double>(k) * step;
        const SineCosine<double> phase = sineCosine(2 * kPi * random.uniform());
        if (n < kLowest) continue;
        const std::size_t profile = k % kProfiles;
        const double sign = profile == 0 ? 1 : -1;
        const double psd = 0.5 * (1 + sign * coherence(params, isotropic, n)) * displacementPsd(params, n);
        const double amplitude = std::sqrt(2 * psd * kProfiles * step) / splineAtNodes(n);
        const double share = sinc(n * contact_length) * (profile == 0 ? 1 : across);
        // A cos(wave + phase), half as the wave k and half as the wave -k.
        const double real = 0.5 * amplitude * phase.cosine, imaginary = 0.5 * amplitude * phase.sine;
        ComplexNumbers& sum = waves[profile];
        sum.real[k] = real - share * imaginary;
        sum.imaginary[k] = imaginary + share * real;
        sum.real[kNodes - k] = real + share * imaginary;
        sum.imaginary[kNodes - k] = share * real - imaginary;
    }

    for (std::size_t profile = 0; profile < kProfiles; ++profile) {
        sumWaves(waves[profile]);
        for (std::size_t i = 0; i < kNodes; ++i) {
            itself_[i][profile] = waves[profile].real[i];
            averaged_[i][profile] = waves[profile].imaginary[i];
        }
    }
}

SurfacePoint Roughness::evaluate(const Profile& profile, double x, double y) const {
    if (!(x > begin_) || std::abs(x) > kFarthest) return {};

    // Cubic B-spline along x: values and slopes of the three profiles.
    const double u = x / kSpacing, whole = std::floor(u), t = u - whole, s = 1 - t;
    const std::array<double, 4> weight{s * s * s / 6, (4 + t * t * (3 * t - 6)) / 6, (4 + s * s * (3 * s - 6)) / 6,
                                       t * t * t / 6};
    const std::array<double, 4> slope_weight{-0.5 * s * s, t * (1.5 * t - 2), -s * (1.5 * s - 2), 0.5 * t * t};
    const long first = static_cast<long>(whole) - 1;
    std::array<double, 3> value{}, slope{};
    for (int k = 0; k < 4; ++k) {
        const Node& node = profile[wrapped(first + k)];
        for (std::size_t i = 0; i < 3; ++i) {
            value[i] += weight[k] * node[i];
            slope[i] += slope_weight[k] / kSpacing * node[i];
        }
    }

    // Across the road.
    const auto [sine, cosine] = sineCosineFar(wave_across_ * y);
    const SurfacePoint surface{value[0] + value[1] * cosine + value[2] * sine,
                               slope[0] + slope[1] * cosine + slope[2] * sine,
                               wave_across_ * (value[2] * cosine - value[1] * sine)};
    return fadedIn(surface, x - begin_, kFade);
}

}  // namespace tread
