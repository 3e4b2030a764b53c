#include "scenario/signals.h"

#include <cmath>
#include <numbers>

namespace tread {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

double at(const Keep&, double held, double) {
    return held;
}
double at(const HoldSpeed&, double held, double) {
    return held;
}
double at(const HandsOff&, double held, double) {
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
double at(const Sine<Of>& signal, double held, double elapsed) {
    if (elapsed * signal.frequency >= signal.cycles) return held;
    return held + signal.amplitude * std::sin(kTurn * signal.frequency * elapsed);
}

template <class Of>
double at(const Sweep<Of>& signal, double held, double elapsed) {
    if (elapsed >= signal.duration) return held;
    const double rise = (signal.to - signal.from) / signal.duration;
    return held + signal.amplitude * std::sin(kTurn * (signal.from + 0.5 * rise * elapsed) * elapsed);
}

template <class Of>
double at(const Table<Of>& signal, double, double elapsed) {
    return signal.points(elapsed);
}

template <class Signal>
double visited(const Signal& signal, double held, double elapsed) {
    return std::visit([&](const auto& alternative) { return at(alternative, held, elapsed); }, signal);
}

}  // namespace

double valueAt(const SteeringSignal& signal, double held, double elapsed) {
    return visited(signal, held, elapsed);
}
double valueAt(const PedalSignal& signal, double held, double elapsed) {
    return visited(signal, held, elapsed);
}
double valueAt(const ThrottleSignal& signal, double held, double elapsed) {
    return visited(signal, held, elapsed);
}

}  // namespace tread
