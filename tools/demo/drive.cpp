#include "drive.h"

#include <algorithm>
#include <array>

namespace tread::demo {
namespace {

using scene::scalar;
using scene::vector;

constexpr std::array<double, 8> kRates{20, 30, 45, 60, 90, 120, 180, 240};  // Hz
constexpr double kLongest = 0.25;  // s: a slower computer lets the world go slower

}  // namespace

Drive::Drive() {
    begin(Place::plane);
}

void Drive::begin(Place where, double speed, double heading) {
    place = where;
    time = left_ = 0;
    track.reset();
    marks.clear();
    btTransform at = start(where);
    at.setRotation(btQuaternion(vector(0, 1, 0), scalar(heading)) * at.getRotation());
    car.put(at);
    car.setSpeed(speed);
    before_ = now_ = shown = car.pose();
}

void Drive::step(const Pedals& pedals) {
    const double dt = 1 / rate;
    time += dt;
    track.movePlatform(time);
    car.drive(pedals);
    track.world.dynamics.stepSimulation(scalar(dt), 0);
    marks.note(car);
    before_ = now_;
    now_ = shown = car.pose();
}

void Drive::run(const Pedals& pedals, double seconds) {
    left_ += std::min(seconds, kLongest);
    while (left_ >= 1 / rate) {
        step(pedals);
        left_ -= 1 / rate;
    }
    shown = between(before_, now_, left_ * rate);
}

void Drive::changeRate(int steps) {
    const auto now = std::lower_bound(kRates.begin(), kRates.end(), rate) - kRates.begin();
    rate = kRates[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(now + steps, 0, kRates.size() - 1))];
}

}  // namespace tread::demo
