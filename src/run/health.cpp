#include "run/health.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/elementary.h"
#include "base/numbers.h"
#include "run/simulate.h"

namespace tread {
namespace {

constexpr double kFastest = 200;                         // m/s
constexpr double kFarthest = 1e6;                        // m
constexpr double kTipped = 80 * std::numbers::pi / 180;  // rad
constexpr auto kNumbers = SimulationError::Suspect::numbers;

}  // namespace

void checkHealth(const VehicleOutput& output, double time) {
    // A number that is not finite spreads from a tyre or the suspension into the body's acceleration within a step;
    // what turns may be cut off from the body by an open clutch or a wheel in the air.
    const ChassisOutput& c = output.chassis;
    double sum = c.ax + c.ay + c.az + c.roll_rate + c.pitch_rate + c.yaw_rate + output.driveline.engine_speed;
    for (std::size_t i = 0; i < kWheels; ++i) sum += output.wheel[i].spin;
    if (!std::isfinite(sum)) {
        VehicleOutput copy = output;
        for (const Number& number : numbers(copy)) {
            if (std::isfinite(*number.value)) continue;
            throw SimulationError(
                fmt::format("the simulation broke down at t = {:.4g} s: {} is {} (a parameter far from that of "
                            "a real car, or a step that is too long, can do this)",
                            time, number.path, *number.value),
                time, kNumbers);
        }
    }
    if (std::abs(c.roll) > kTipped || std::abs(c.pitch) > kTipped) {
        throw SimulationError(
            fmt::format("the car rolled over at t = {:.4g} s: chassis.roll is {:.0f} deg, chassis.pitch {:.0f} deg",
                        time, c.roll * 180 / std::numbers::pi, c.pitch * 180 / std::numbers::pi),
            time, kNumbers);
    }
    const double speed = hypotenuse(hypotenuse(c.vx, c.vy), c.vz);
    if (speed > kFastest) {
        throw SimulationError(fmt::format("the car left the bounds of the simulation at t = {:.4g} s: its speed "
                                          "(chassis.vx, vy, vz) is {:.3g} m/s, more than {} m/s",
                                          time, speed, kFastest),
                              time, kNumbers);
    }
    const double distance = hypotenuse(hypotenuse(c.x, c.y), c.z);
    if (distance > kFarthest) {
        throw SimulationError(fmt::format("the car left the bounds of the simulation at t = {:.4g} s: it is {:.3g} m "
                                          "from the origin (chassis.x, y, z)",
                                          time, distance),
                              time, kNumbers);
    }
}

}  // namespace tread
