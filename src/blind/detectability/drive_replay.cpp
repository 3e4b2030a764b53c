#include "blind/detectability/drive_replay.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "blind/drives/measure.h"
#include "blind/world/instruments.h"
#include "recording/instruments.h"

namespace tread::blind::detectability {
namespace {

using drives::Conditions;
using drives::Drive;
using drives::kIdeal;
using drives::readingsOf;
using recording::Instrument;
using recording::Instruments;
using world::blockMeans;
using world::InstrumentSheet;
using world::instrumentSheets;
using world::measuresDriver;
using world::Truth;

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kStep = 0.005;        // s; the error of this step cancels in the difference of two runs
constexpr std::uint64_t kAnySeed = 1;  // only instruments of outsiders (Truth::misread) are random in these drives

constexpr Conditions conditions() {
    Conditions ideal = kIdeal;
    ideal.step = kStep;
    return ideal;
}

std::vector<const InstrumentSheet*> vehicleSheets() {
    std::vector<const InstrumentSheet*> found;
    for (const InstrumentSheet& sheet : instrumentSheets())
        if (!measuresDriver(sheet)) found.push_back(&sheet);
    return found;
}

// The driver's true input over time, from its reading by an instrument.
Curve trueInput(const std::vector<double>& times, const std::vector<double>& reading, const Instrument& instrument,
                const Limits& limits) {
    Curve curve;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double value = (reading[i] - instrument.bias) / instrument.gain;
        curve.points.push_back({times[i] - instrument.delay, std::clamp(value, limits.lowest, limits.highest)});
    }
    return curve;
}

// `drive` with the inputs that `log` records, for a car with the instruments of `truth`.
Drive repeated(const Drive& drive, const Log& log, const Truth& truth, double faster) {
    const std::vector<double>& times = log.channels.front().values;
    const Instruments& instruments = truth.car.instruments;
    const auto input = [&](const char* name, const Instrument& instrument, const Limits& limits) {
        return trueInput(times, log.find(name)->values, instrument, limits);
    };
    Phase phase;
    phase.steering =
        Table<Angle>{input("driver.steering_wheel_angle", instruments.steering_wheel_angle, Angle::kLimits)};
    phase.throttle = Table<Pedal>{input("driver.throttle", instruments.throttle, Pedal::kLimits)};
    phase.brake = Table<Pedal>{input("driver.brake", instruments.brake, Pedal::kLimits)};
    phase.until.duration = times.back();
    Drive again = drive;
    again.scenario.start.speed += faster;
    again.scenario.phases = {phase};
    return again;
}

// Leaves the gear of the recorded drive as the only one: a changed car cannot shift at another time.
void holdGear(VehicleParams& car, const Log& recorded) {
    const auto gear = static_cast<std::size_t>(std::lround(recorded.find("driveline.gear")->values.front()));
    std::vector<double>& ratios = car.driveline.gearbox.ratios;
    if (gear >= 1 && gear <= ratios.size()) ratios = {ratios[gear - 1]};
}

}  // namespace

VectorXd rowsOf(const Log& log) {
    const std::vector<double>& times = log.channels.front().values;
    std::vector<VectorXd> parts;
    Index count = 0;
    for (const InstrumentSheet* sheet : vehicleSheets()) {
        parts.push_back(blockMeans(times, log.find(sheet->channel)->values));
        count += parts.back().size();
    }
    VectorXd rows(count);
    Index first = 0;
    for (const VectorXd& part : parts) rows.segment(first, part.size()) = part, first += part.size();
    return rows;
}

ChannelRows rowsOfChannel(std::string_view channel, Index rows) {
    const std::vector<const InstrumentSheet*> sheets = vehicleSheets();
    const auto count = rows / static_cast<Index>(sheets.size());
    const auto found = std::find_if(sheets.begin(), sheets.end(),
                                    [&](const InstrumentSheet* sheet) { return sheet->channel == channel; });
    return {(found - sheets.begin()) * count, count};
}

DriveReplay::DriveReplay(const Drive& drive, const Truth& truth)
    : drive_(drive), recorded_(readingsOf(truth, drive, kAnySeed, conditions())) {}

Log DriveReplay::readings(const Truth& truth, double faster) const {
    Truth held = truth;
    holdGear(held.car.vehicle, recorded_);
    return readingsOf(held, repeated(drive_, recorded_, truth, faster), kAnySeed, conditions());
}

}  // namespace tread::blind::detectability
