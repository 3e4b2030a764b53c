#include "blind/world/surroundings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "blind/world/draws.h"

namespace tread::blind::world {
namespace {

constexpr int kWaves = 40;

// ---- Definition of the sources -------------------------------------------------------------------------------------

// Waves whose powers follow `spectrum`, scaled to a total variance of 1. Frequencies are spaced geometrically and
// jittered, so that the sum is not periodic.
template <class Spectrum>
std::vector<PushSource::Wave> wavesOf(double lowest, double highest, Random& random, const Spectrum& spectrum) {
    const double factor = std::pow(highest / lowest, 1.0 / kWaves);
    std::vector<PushSource::Wave> waves;
    double variance = 0;
    for (int i = 0; i < kWaves; ++i) {
        const double frequency = lowest * std::pow(factor, i + random.uniform());
        const double power = spectrum(frequency) * frequency;  // bandwidth is proportional to frequency
        waves.push_back({std::sqrt(2 * power), frequency});
        variance += power;
    }
    for (PushSource::Wave& wave : waves) wave.amplitude /= std::sqrt(variance);
    return waves;
}

// Von Karman spectrum of lateral turbulence over the reduced frequency (frequency times passing time of an eddy).
double vonKarman(double frequency) {
    const double square = std::pow(1.339 * frequency, 2);
    return (1 + 8.0 / 3 * square) / std::pow(1 + square, 11.0 / 6);
}

// Guesses. A case scales each by a log-uniform factor between 1/2 and 2.
constexpr double kTurbulenceSide = 55, kTurbulenceAlong = 25, kGust = 130;  // N at kSourceSpeed
constexpr double kPressurePoint = 0.4;                                      // m ahead of the centre of gravity
constexpr double kCrossfall = 0.0025, kGrade = 0.0015;                      // -, standard deviation of the slope
constexpr double kUnevenness = 55;                                          // N m of roll, left minus right
constexpr double kRut = 220, kRutArm = 0.5;  // N; m ahead of the centre of gravity: the front meets a rut first

std::vector<PushSource> sourcesOfTheAir(const VehicleParams& car, Random& random, const auto& level) {
    const double eddy = 0.5 + random.uniform();                              // s
    const double above = std::max(0.0, 0.6 - car.centre_of_gravity_height);  // m, height of the pressure point
    const auto aside = [&](double force) {
        return Push{.force = {0, force, 0}, .moment = {-above * force, 0, kPressurePoint * force}};
    };
    const auto turbulence = [&](double frequency) { return vonKarman(frequency * eddy); };
    const double lowest = 2 * std::numbers::pi * 0.03, highest = 2 * std::numbers::pi * 5;  // rad/s
    return {
        {.name = "side turbulence",
         .push = aside(level(kTurbulenceSide)),
         .by_speed = true,
         .waves = wavesOf(lowest, highest, random, turbulence)},
        {.name = "turbulence along the car",
         .push = {.force = {level(kTurbulenceAlong), 0, 0}},
         .by_speed = true,
         .waves = wavesOf(lowest, highest, random, turbulence)},
        {.name = "side gusts",
         .push = aside(level(kGust)),
         .by_speed = true,
         .waves = {},
         .bumps_per = 0.12,  // 1/s
         .bump_length = between(random, 0.5, 1.2)},
    };
}

std::vector<PushSource> sourcesOfTheRoad(const VehicleParams& car, Random& random, const auto& level) {
    const double weight = car.mass * kStandardGravity;
    const auto wavelength = [](double metres) { return 2 * std::numbers::pi / metres; };  // -> rad/m
    const auto slopes = [](double) { return 1.0; };  // ISO 8608: the spectrum of slopes is flat
    const auto heights = [](double wave) { return 1 / (wave * wave); };
    const double across = level(weight * kCrossfall), rut = level(kRut);
    return {
        {.name = "crossfall",
         .push = {.force = {0, across, 0}, .moment = {0, 0, 0.2 * across}},
         .by_distance = true,
         .waves = wavesOf(wavelength(250), wavelength(12), random, slopes)},
        {.name = "grade",
         .push = {.force = {level(weight * kGrade), 0, 0}},
         .by_distance = true,
         .waves = wavesOf(wavelength(250), wavelength(20), random, slopes)},
        {.name = "unevenness",
         .push = {.moment = {level(kUnevenness), 0, 0}},
         .by_distance = true,
         .waves = wavesOf(wavelength(50), wavelength(7), random, heights)},
        {.name = "ruts",
         .push = {.force = {0, rut, 0}, .moment = {0, 0, kRutArm * rut}},
         .by_distance = true,
         .waves = {},
         .bumps_per = 0.007,  // 1/m
         .bump_length = between(random, 5, 10)},
    };
}

// ---- Realisations of them ------------------------------------------------------------------------------------------

double bump(double along) {  // `along`: 0 to 1 over its length
    return along < 0 || along > 1 ? 0 : 0.5 * (1 - std::cos(2 * std::numbers::pi * along));
}

// Realisation of one source in one drive.
class Running {
public:
    Running(const PushSource& source, std::uint64_t seed) : source_(source), random_(seed) {
        for (std::size_t i = 0; i < source.waves.size(); ++i)
            phases_.push_back(2 * std::numbers::pi * random_.uniform());
        if (source.bumps_per > 0) next_ = -source.bump_length;  // one may be in progress at the start
        advance();
    }

    double at(double place) {
        double sum = 0;
        for (std::size_t i = 0; i < phases_.size(); ++i)
            sum += source_.waves[i].amplitude * std::cos(source_.waves[i].frequency * place + phases_[i]);
        while (source_.bumps_per > 0 && next_ <= place) {
            bumps_.push_back({next_, random_.normal()});
            advance();
        }
        for (const auto& [begin, height] : bumps_) sum += height * bump((place - begin) / source_.bump_length);
        return sum;
    }

private:
    void advance() {
        if (source_.bumps_per > 0) next_ -= std::log(1 - random_.uniform()) / source_.bumps_per;
    }

    struct Bump {
        double begin, height;
    };
    PushSource source_;
    Random random_;
    std::vector<double> phases_;
    std::vector<Bump> bumps_;
    double next_ = 0;
};

}  // namespace

std::vector<PushSource> drawnSurroundings(const VehicleParams& nominal, Random& random) {
    const auto level = [&](double usual) { return usual * std::exp2(2 * random.uniform() - 1); };
    std::vector<PushSource> sources = sourcesOfTheAir(nominal, random, level);
    for (PushSource& source : sourcesOfTheRoad(nominal, random, level)) sources.push_back(std::move(source));
    return sources;
}

Pushing pushingOf(const std::vector<PushSource>& sources, std::uint64_t seed) {
    std::vector<Running> running;
    for (const PushSource& source : sources) running.emplace_back(source, seedOf(seed, running.size()));
    return
        [sources, running, way = 0.0, last = 0.0](double time, const VehicleInput&, const VehicleOutput& car) mutable {
            way += (time - last) * car.chassis.vx;
            last = time;
            Push sum;
            for (std::size_t i = 0; i < running.size(); ++i) {
                const PushSource& source = sources[i];
                const double size = running[i].at(source.by_distance ? way : time) *
                                    (source.by_speed ? car.chassis.vx / kSourceSpeed : 1);
                sum.force += size * source.push.force;
                sum.moment += size * source.push.moment;
            }
            return sum;
        };
}

double autocovariance(const PushSource& source, double apart) {
    double sum = 0;
    for (const PushSource::Wave& wave : source.waves)
        sum += 0.5 * wave.amplitude * wave.amplitude * std::cos(wave.frequency * apart);
    const double share = source.bump_length > 0 ? std::abs(apart) / source.bump_length : 1;
    if (source.bumps_per == 0 || share >= 1) return sum;
    // Campbell's theorem: rate of the bumps times the integral of b(x) b(x + apart).
    const double rest = 1 - share, turn = 2 * std::numbers::pi * share;
    const double overlap = 0.25 * (rest * (1 + 0.5 * std::cos(turn)) + 3 / (4 * std::numbers::pi) * std::sin(turn));
    return sum + source.bumps_per * source.bump_length * overlap;
}

}  // namespace tread::blind::world
