#include "recording/replay.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/fields/numbers.h"
#include "recording/driver_inputs.h"
#include "recording/observation.h"
#include "scenario/run_in.h"

namespace tread::recording {
namespace {

constexpr double kStanding = 0.3;  // m/s; a drive that starts slower starts at standstill
constexpr double kParked = 0.3;    // brake pedal of a standing car when the log has no brake; keeps it from rolling

// A road or wind known for this drive, changed by the differences between subject and nominal subject.
template <class T>
T changed(T known, const T& subject, const T& nominal) {
    T now = subject, before = nominal;
    const std::vector<Number> news = numbers(now), olds = numbers(before);
    for (const Number& number : numbers(known)) {
        for (std::size_t i = 0; i < news.size() && i < olds.size(); ++i) {
            if (news[i].path == number.path && *news[i].value != *olds[i].value)
                *number.value += *news[i].value - *olds[i].value;
        }
    }
    return known;
}

// Speed of the car at which its instrument shows this.
double speedBehind(double shown, const Instrument& instrument) {
    return std::max(0.0, (shown - instrument.bias) / instrument.gain);
}

std::string speedChannel(const RecordedDrive& drive) {
    const Channel* speed = measuredAs(drive.log, "chassis.vx");
    return speed ? speed->name : "chassis.vx";
}

// What feet or commands do in the drive.
void takePedals(Phase& phase, const RecordedDrive& drive, const Instruments& instruments, double nominal_mass) {
    switch (drive.recording->speed) {
        case SpeedReplay::followed:
            phase.throttle = FollowSpeed{followedSpeed(drive, instruments)};
            return;
        case SpeedReplay::command:
            phase.throttle = CommandedForce{commandedForce(drive, instruments.command, nominal_mass)};
            return;
        case SpeedReplay::pedals:
            break;
    }
    const Curve throttle = driverInput(drive, "driver.throttle", instruments.throttle, Pedal::kLimits);
    const Curve brake = driverInput(drive, "driver.brake", instruments.brake, Pedal::kLimits);
    if (!throttle.empty()) phase.throttle = Table<Pedal>{throttle};
    if (!brake.empty()) phase.brake = Table<Pedal>{brake};
}

Phase driven(const RecordedDrive& drive, const Instruments& instruments, double nominal_mass) {
    Phase phase;
    phase.name = "the drive";
    const Curve steering =
        driverInput(drive, "driver.steering_wheel_angle", instruments.steering_wheel_angle, Angle::kLimits);
    if (!steering.empty()) phase.steering = Table<Angle>{steering};
    takePedals(phase, drive, instruments, nominal_mass);
    const Curve clutch = driverInput(drive, "driver.clutch", {}, Pedal::kLimits);
    if (!clutch.empty()) phase.clutch = Table<Pedal>{clutch};
    phase.until.duration = drive.duration();
    return phase;
}

// The signals of a phase that begins later by this time.
Phase startedLater(Phase phase, double by) {
    const auto shift = [&](Curve& curve) {
        for (Curve::Point& point : curve.points) point.x -= by;
    };
    if (auto* table = std::get_if<Table<Angle>>(&phase.steering)) shift(table->points);
    if (auto* force = std::get_if<CommandedForce>(&phase.throttle)) shift(force->points);
    if (auto* table = std::get_if<Table<Pedal>>(&phase.throttle)) shift(table->points);
    for (PedalSignal* signal : {&phase.brake, &phase.clutch})
        if (auto* table = std::get_if<Table<Pedal>>(signal)) shift(table->points);
    *phase.until.duration -= by;
    return phase;
}

bool isFollowedThroughout(const RecordedDrive& drive) {
    return drive.recording->followedUntil() >= drive.duration();
}

// The drive, in two phases if its speed is followed at first, by so much faster than recorded.
std::vector<Phase> phasesOf(const RecordedDrive& drive, const Instruments& instruments, double nominal_mass,
                            double faster) {
    Phase whole = driven(drive, instruments, nominal_mass);
    const double followed = std::min(drive.recording->followed_for, drive.duration());
    if (followed == 0 || drive.recording->speed == SpeedReplay::followed) return {whole};
    Phase first = whole;
    first.name = "the speed is followed";
    Curve speed = followedSpeed(drive, instruments);
    for (Curve::Point& point : speed.points) point.y = std::max(0.0, point.y + faster);
    first.throttle = FollowSpeed{std::move(speed)};
    first.brake = Keep{};
    first.until.duration = followed;
    if (followed == drive.duration()) return {first};
    return {first, startedLater(std::move(whole), followed)};
}

// If the drive stays in one gear, makes it the only gear, so that the model cannot shift at another time.
void holdGear(VehicleParams& vehicle, const RecordedDrive& drive) {
    const Channel* gear = drive.log.find("driveline.gear");
    auto& gearbox = vehicle.driveline.gearbox;
    if (!gear || gear->values.empty()) return;
    const double held = std::round(gear->values.front());
    const bool constant = std::all_of(gear->values.begin(), gear->values.end(),
                                      [&](double g) { return !std::isfinite(g) || std::round(g) == held; });
    if (!constant || held < 1 || held > static_cast<double>(gearbox.ratios.size())) return;
    gearbox.ratios = {gearbox.ratios[static_cast<std::size_t>(held) - 1]};
}

}  // namespace

Scenario replayOf(const RecordedDrive& drive, const Subject& subject, const Replayer& replayer) {
    const Subject& nominal = replayer.nominal;
    const double faster = isFollowedThroughout(drive) ? 0 : replayer.faster;
    Scenario scenario;
    scenario.title = drive.name;
    scenario.step = scenario.substep = replayer.step;
    scenario.road = changed(drive.recording->road, subject.road, nominal.road);
    scenario.wind = changed(drive.recording->wind, subject.wind, nominal.wind);
    const Instrument speed = instrumentOf(subject.instruments, speedChannel(drive));
    scenario.start.speed = drive.speed < kStanding ? 0 : speedBehind(drive.speed, speed) + faster;
    scenario.phases = phasesOf(drive, subject.instruments, nominal.vehicle.mass, faster);
    if (scenario.start.speed == 0) {
        const auto* brake = std::get_if<Table<Pedal>>(&scenario.phases.front().brake);
        scenario.start.brake = brake ? brake->points(0) : kParked;
    }
    const Channel* yaw_rate = measuredAs(drive.log, "chassis.yaw_rate");
    if (yaw_rate && beginsInTurn(drive.speed, drive.time, yaw_rate->values)) runIntoTurn(scenario);
    scenario.time_limit = drive.duration() + 1;
    scenario.log.rate = 1 / replayer.step;
    scenario.log.channels = {"chassis.pitch_rate", "chassis.pitch"};
    for (const ObservedQuantity& quantity : observedQuantities()) scenario.log.channels.push_back(quantity.channel);
    return scenario;
}

Log replayed(const RecordedDrive& drive, const Subject& subject, const Replayer& replayer, const Pushing& pushing) {
    const bool moves_with_load = subject.instruments.read_at == ReadAt::centre_of_gravity;
    VehicleParams vehicle = moves_with_load ? loaded(subject.vehicle) : subject.vehicle;
    holdGear(vehicle, drive);
    Log motion;
    replayer.simulate(vehicle, replayOf(drive, subject, replayer), recorderInto(motion), pushing);
    return motion;
}

Eigen::VectorXd readings(const RecordedDrive& drive, const Log& motion, const Instruments& instruments) {
    Eigen::VectorXd rows(drive.rows());
    for (const ObservedChannel& channel : drive.channels)
        rows.segment(channel.first_row, channel.rows()) =
            blockMeans(channel, drive.time, readings(motion, instruments, channel.name, drive.time));
    return rows;
}

}  // namespace tread::recording
