#include "run/health.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/fields/numbers.h"
#include "base/math/elementary.h"
#include "run/simulate.h"

namespace tread {
namespace {

constexpr double kFastest = 200;                         // m/s
constexpr double kFarthest = 1e6;                        // m
constexpr double kTipped = 80 * std::numbers::pi / 180;  // rad
constexpr double kFastestTurn = 2e4;  // rad/s: the rim of the smallest wheel, of 1 cm, at kFastest; 190 000 1/min
constexpr double kLongest = 10;    // m, of a suspension's travel and a tyre's deflection: those of trucks are below 1 m
constexpr double kHottest = 4000;  // K: carbon, which endures the most heat of all discs, sublimes at 3915 K (CRC)
constexpr auto kNumbers = SimulationError::Suspect::numbers;

constexpr const char* kReason = "a parameter far from that of a real car, or a step that is too long, can do this";

// Calls `see` for each state of the car that may leave its bounds while the body stays where it is.
void eachState(const VehicleOutput& output, auto&& see) {
    const ChassisOutput& c = output.chassis;
    see(c.roll_rate, kFastestTurn, "rad/s");
    see(c.pitch_rate, kFastestTurn, "rad/s");
    see(c.yaw_rate, kFastestTurn, "rad/s");
    for (std::size_t i = 0; i < kWheels; ++i) {
        const WheelOutput& wheel = output.wheel[i];
        see(wheel.spin, kFastestTurn, "rad/s");
        see(wheel.travel, kLongest, "m");
        see(wheel.patch_u, kLongest, "m");
        see(wheel.patch_v, kLongest, "m");
        see(wheel.brake_temperature, kHottest, "K");
        see(wheel.temperature, kHottest, "K");
    }
    see(output.driveline.engine_speed, kFastestTurn, "rad/s");
}

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
            throw SimulationError(fmt::format("the simulation broke down at t = {:.4g} s: {} is {} ({})", time,
                                              number.path, *number.value, kReason),
                                  time, kNumbers);
        }
    }
    if (std::abs(c.roll) > kTipped || std::abs(c.pitch) > kTipped) {
        throw SimulationError(
            fmt::format("the car rolled over at t = {:.4g} s: chassis.roll is {:.0f} deg, chassis.pitch {:.0f} deg",
                        time, c.roll * 180 / std::numbers::pi, c.pitch * 180 / std::numbers::pi),
            time, kNumbers);
    }
    if (c.vx * c.vx + c.vy * c.vy + c.vz * c.vz > kFastest * kFastest) {
        const double speed = hypotenuse(hypotenuse(c.vx, c.vy), c.vz);
        throw SimulationError(fmt::format("the car left the bounds of the simulation at t = {:.4g} s: its speed "
                                          "(chassis.vx, vy, vz) is {:.3g} m/s, more than {} m/s",
                                          time, speed, kFastest),
                              time, kNumbers);
    }
    if (c.x * c.x + c.y * c.y + c.z * c.z > kFarthest * kFarthest) {
        const double distance = hypotenuse(hypotenuse(c.x, c.y), c.z);
        throw SimulationError(fmt::format("the car left the bounds of the simulation at t = {:.4g} s: it is {:.3g} m "
                                          "from the origin (chassis.x, y, z)",
                                          time, distance),
                              time, kNumbers);
    }
    bool within = true;
    eachState(output, [&](double value, double most, const char*) { within &= std::abs(value) <= most; });
    if (within) return;
    eachState(output, [&](const double& value, double most, const char* unit) {
        if (std::abs(value) <= most) return;
        VehicleOutput named;  // its numbers lie where those of `output` do
        const auto offset = reinterpret_cast<const char*>(&value) - reinterpret_cast<const char*>(&output);
        for (const Number& number : numbers(named)) {
            if (reinterpret_cast<const char*>(number.value) - reinterpret_cast<const char*>(&named) != offset) continue;
            throw SimulationError(fmt::format("the simulation broke down at t = {:.4g} s: {} is {:.3g} {}, more than "
                                              "{:g} {} ({})",
                                              time, number.path, value, unit, most, unit, kReason),
                                  time, kNumbers);
        }
    });
}

}  // namespace tread
