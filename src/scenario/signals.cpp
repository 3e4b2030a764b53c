#include "scenario/signals.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <type_traits>

#include "base/math/elementary.h"
#include "base/math/power.h"
#include "base/math/random.h"

namespace tread {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kFadeIn = 1;  // s: a random signal begins without a jump

// Keep, and what watches the car.
template <class Other>
double at(const Other&, double held, double) {
    return held;
}
template <class Of>
double at(const Constant<Of>& signal, double, double) {
    return signal.value;
}

template <class Of>
double at(const Ramp<Of>& signal, double held, double elapsed) {
    const double way = signal.to - held;
    const double moved = signal.rate * elapsed;
    return moved >= std::abs(way) ? signal.to : held + std::copysign(moved, way);
}

template <class Of>
double at(const Rescale<Of>& signal, double held, double elapsed) {
    const double to = signal.factor * held, way = to - held;
    if (signal.duration) return held + way * std::min(1.0, elapsed / *signal.duration);
    return at(Ramp<Of>{.to = to, .rate = signal.rate.value_or(kInfinity)}, held, elapsed);
}

template <class Of>
double at(const Sine<Of>& signal, double held, double elapsed) {
    if (elapsed * signal.frequency >= signal.cycles) return held;
    return held + signal.amplitude * sine(kTurn * signal.frequency * elapsed);
}

template <class Of>
double at(const SineWithDwell<Of>& signal, double held, double elapsed) {
    const double pause = 0.75 / signal.frequency;
    const double run = elapsed <= pause ? elapsed : std::max(pause, elapsed - signal.dwell);
    if (run * signal.frequency >= 1) return held;
    return held + signal.amplitude * sine(kTurn * signal.frequency * run);
}

template <class Of>
double at(const Sweep<Of>& signal, double held, double elapsed) {
    if (elapsed >= signal.duration) return held;
    double periods;
    if (signal.law == SweepLaw::logarithmic && signal.to != signal.from) {
        const double growth = logarithm(signal.to / signal.from) / signal.duration;
        periods = signal.from * exponentialLess1(growth * elapsed) / growth;
    } else {
        const double rise = (signal.to - signal.from) / signal.duration;
        periods = (signal.from + 0.5 * rise * elapsed) * elapsed;
    }
    return held + signal.amplitude * sine(kTurn * periods);
}

template <class Of>
double at(const Pulse<Of>& signal, double held, double elapsed) {
    return held + signal.amplitude * std::max(0.0, 1 - std::abs(2 * elapsed / signal.duration - 1));
}

template <class Of>
double at(const Noise<Of>& signal, double held, double elapsed) {
    const double width = (signal.to - signal.from) / signal.lines;
    Random random(static_cast<std::uint64_t>(signal.seed));
    double sum = 0;
    for (int line = 0; line < signal.lines; ++line) {
        const double frequency = signal.from + width * (line + random.uniform());
        sum += sine(kTurn * (frequency * elapsed + random.uniform()));
    }
    return held + std::min(1.0, elapsed / kFadeIn) * signal.rms * std::sqrt(2.0 / signal.lines) * sum;
}

template <class Of>
double at(const Table<Of>& signal, double, double elapsed) {
    return signal.points(elapsed);
}

// Keep and a constant have no way to go.
template <class Other>
double length(const Other&, double) {
    constexpr bool at_once = std::is_same_v<Other, Keep> || std::is_same_v<Other, Constant<Angle>>;
    return at_once ? 0 : kInfinity;
}
template <class Of>
double length(const Ramp<Of>& signal, double held) {
    return std::abs(signal.to - held) / signal.rate;
}
template <class Of>
double length(const Rescale<Of>& signal, double held) {
    if (signal.duration) return *signal.duration;
    return std::abs((signal.factor - 1) * held) / signal.rate.value_or(kInfinity);
}
template <class Of>
double length(const Sine<Of>& signal, double) {
    return signal.cycles / signal.frequency;
}
template <class Of>
double length(const SineWithDwell<Of>& signal, double) {
    return 1 / signal.frequency + signal.dwell;
}
template <class Of>
double length(const Sweep<Of>& signal, double) {
    return signal.duration;
}
template <class Of>
double length(const Pulse<Of>& signal, double) {
    return signal.duration;
}
template <class Of>
double length(const Table<Of>& signal, double) {
    return signal.points.empty() ? 0 : std::max(0.0, signal.points.points.back().x);
}

template <class Signal>
double visited(const Signal& signal, double held, double elapsed) {
    return std::visit([&](const auto& alternative) { return at(alternative, held, elapsed); }, signal);
}

}  // namespace

double valueAt(const SteeringSignal& signal, double held, double elapsed) {
    return visited(signal, held, elapsed);
}
double lengthOf(const SteeringSignal& signal, double held) {
    return std::visit([&](const auto& alternative) { return length(alternative, held); }, signal);
}
double valueAt(const PedalSignal& signal, double held, double elapsed) {
    return visited(signal, held, elapsed);
}
double valueAt(const ThrottleSignal& signal, double held, double elapsed) {
    return visited(signal, held, elapsed);
}

}  // namespace tread
