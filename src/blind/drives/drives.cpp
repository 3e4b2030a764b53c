#include "blind/drives/drives.h"

#include <numbers>

#include "base/text/enum_named.h"

namespace tread::blind::drives {
namespace {

constexpr double kKmh = 1 / 3.6;                    // m/s
constexpr double kDegree = std::numbers::pi / 180;  // rad
constexpr double kStepRate = 500 * kDegree;         // rad/s, steering machine (ISO 7401)
constexpr double kSweepTo = 2.8604;                 // Hz: a sweep from 0.2 Hz in 10 s ends after ten periods
constexpr double kPedalRate = 5;                    // 1/s

Phase during(double seconds) {
    Phase phase;
    phase.until.duration = seconds;
    return phase;
}

Phase steering(double seconds, const SteeringSignal& signal) {
    Phase phase = during(seconds);
    phase.steering = signal;
    return phase;
}

Phase braking(double seconds, double pedal) {
    Phase phase = during(seconds);
    phase.throttle = Ramp<Pedal>{0, kPedalRate};
    phase.brake = Ramp<Pedal>{pedal, kPedalRate};
    return phase;
}

Phase throttle(double seconds, double pedal) {
    Phase phase = during(seconds);
    phase.throttle = Ramp<Pedal>{pedal, kPedalRate};
    return phase;
}

Ramp<Angle> turnTo(double degrees) {
    return {degrees * kDegree, kStepRate};
}

Drive drive(const std::string& name, double kmh, std::vector<Phase> phases) {
    Drive drive{.name = name, .scenario = {}};
    drive.scenario.title = name;
    drive.scenario.start.speed = kmh * kKmh;
    drive.scenario.phases = {during(0.5)};
    drive.scenario.phases.insert(drive.scenario.phases.end(), phases.begin(), phases.end());
    return drive;
}

Drive repeated(Drive drive, int times) {
    drive.repeats = times;
    return drive;
}

Drive heldOut(Drive drive) {
    drive.hold_out = true;
    return drive;
}

Phase slowRamp() {
    Phase phase = steering(9, Ramp<Angle>{135 * kDegree, 15 * kDegree});
    phase.throttle = HoldSpeed{};
    return phase;
}

// Whether a set contains this training drive.
bool belongs(const Drive& drive, DriveSet set) {
    const auto is = [&](std::string_view beginning) { return drive.name.starts_with(beginning); };
    if (set == DriveSet::step_steers) return is("step_steer");
    if (set == DriveSet::coast_and_accelerate) return is("coast_down") || is("acceleration");
    return true;
}

std::vector<Drive> allDrives() {
    const SteeringSignal sweep = Sweep<Angle>{
        .amplitude = 20 * kDegree, .from = 0.2, .to = kSweepTo, .duration = 10, .law = SweepLaw::logarithmic};
    const SteeringSignal dwell = SineWithDwell<Angle>{.amplitude = 70 * kDegree, .frequency = 0.7, .dwell = 0.5};
    return {
        repeated(drive("step_steer_80", 80, {steering(3.5, turnTo(45)), steering(2, turnTo(0))}), 2),
        repeated(drive("step_steer_110", 110, {steering(3, turnTo(-28)), steering(2, turnTo(0))}), 2),
        drive("sine_sweep_90", 90, {steering(10, sweep), during(0.5)}),
        drive("straight_braking_110", 110, {braking(2.5, 0.35)}),
        drive("braking_in_turn_90", 90, {steering(2, turnTo(32)), braking(2.2, 0.2)}),
        drive("coast_down_120", 120, {throttle(9, 0)}),
        drive("acceleration_50", 50, {throttle(7, 1)}),
        drive("slow_ramp_80", 80, {slowRamp()}),
        heldOut(drive("sine_with_dwell_80", 80, {steering(4.5, dwell)})),
        heldOut(drive("power_on_in_turn_75", 75, {steering(2, turnTo(-45)), throttle(4, 1)})),
    };
}

}  // namespace

DriveSet driveSetNamed(std::string_view name) {
    return enumNamed<DriveSet>(name, "the set of drives");
}

std::vector<Drive> caseDrives(DriveSet set) {
    std::vector<Drive> drives = allDrives();
    if (set == DriveSet::all) return drives;
    std::erase_if(drives, [&](const Drive& drive) { return !drive.hold_out && !belongs(drive, set); });
    for (Drive& drive : drives) drive.repeats = 1;
    return drives;
}

}  // namespace tread::blind::drives
