#include "recording/checks/data_checks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "recording/checks/log_checks.h"
#include "recording/observation.h"
#include "recording/recorded_drive.h"
#include "recording/reference.h"

namespace tread::recording::checks {
namespace {

constexpr double kLateral = 1;    // m/s2; less shows little of tyres and steering
constexpr double kSpeeds = 3;     // m/s, least difference between lowest and highest speed
constexpr double kAlike = 0.995;  // correlation of the steering-wheel angle in recordings of the same manoeuvre

// True when any instrument has measured the quantity.
bool has(const Log& log, std::string_view name) {
    const Channel* channel = measuredAs(log, name);
    return channel && std::any_of(channel->values.begin(), channel->values.end(),
                                  [](double value) { return std::isfinite(value); });
}

double range(const Log& log, std::string_view name) {
    const Channel* channel = measuredAs(log, name);
    double lowest = kInfinity, highest = -kInfinity;
    if (channel) {
        for (const double value : channel->values) {
            if (!std::isfinite(value)) continue;
            lowest = std::min(lowest, value);
            highest = std::max(highest, value);
        }
    }
    return highest > lowest ? highest - lowest : 0;
}

void checkInputs(const LogChecks& checks) {
    if (!has(checks.log, "driver.steering_wheel_angle"))
        checks.warn("driver.steering_wheel_angle", "is missing", "Without it, the replay assumes straight running",
                    "Record the steering-wheel angle, or compute it from the road-wheel angle and the steering ratio");
    if (!has(checks.log, "chassis.vx"))
        checks.warn("chassis.vx", "is missing", "Neither the start speed nor the speed to follow is known",
                    "Record the speed over ground");
    if (checks.recording.speed == SpeedReplay::pedals && !has(checks.log, "driver.throttle") &&
        !has(checks.log, "driver.brake"))
        checks.warn("driver.throttle, driver.brake", "are missing, but the recording has speed: pedals",
                    "The simulated car would coast", "Set speed: followed for this recording");
    if (checks.recording.speed == SpeedReplay::pedals && has(checks.log, "driver.throttle") &&
        !has(checks.log, "driveline.gear"))
        checks.warn("driveline.gear", "is missing",
                    "A gear shift at a different time than in the real car hides or mimics effects of the driveline",
                    "Record the gear, or choose a window in one gear");
}

// Channels that the reference lacks cannot be used after the change either.
void checkReference(const LogChecks& checks, const DiagnosisFile& file, const Log& after) {
    std::vector<std::string> missing;
    for (const Channel& channel : after.channels) {
        if (observedQuantity(channel.name) && wanted(file, channel.name) && !checks.log.find(channel.name))
            missing.push_back(channel.name);
    }
    if (missing.empty()) return;
    checks.warn(fmt::format("{}", fmt::join(missing, ", ")), "not measured here, but measured in the recording itself",
                "The gap before the change is unknown for these channels, so both drives are used without them",
                "Record the same channels before and after the change");
}

void checkNamed(std::vector<DataWarning>& found, const DiagnosisFile& file, const std::vector<Log>& logs) {
    std::vector<std::string> nowhere;
    for (const MeasuredChannel& told : file.channels) {
        if (std::none_of(logs.begin(), logs.end(), [&](const Log& log) { return has(log, told.channel); }))
            nowhere.push_back(told.channel);
    }
    if (nowhere.empty()) return;
    found.push_back({"all recordings", fmt::format("{} listed under channels, but in no log", fmt::join(nowhere, ", ")),
                     "A channel that was not measured cannot be used",
                     "Give the column to read it from, or remove it from channels"});
}

// Warns about missing channels that exclude whole groups of causes.
void checkResponses(std::vector<DataWarning>& found, const std::vector<Log>& logs) {
    const auto none = [&](std::initializer_list<const char*> channels) {
        return std::none_of(logs.begin(), logs.end(), [&](const Log& log) {
            return std::any_of(channels.begin(), channels.end(), [&](const char* name) { return has(log, name); });
        });
    };
    const auto warn = [&](const char* what, const char* lost) {
        found.push_back(
            {"all recordings", what, lost, "Record the missing signal, or use other evidence for these causes"});
    };
    if (none({"chassis.yaw_rate", "chassis.ay"}))
        warn("neither yaw rate nor lateral acceleration was measured",
             "Effects of tyres, steering and side forces are not testable; drag, drive and brakes remain");
    if (none({"chassis.ax", "chassis.vx"}))
        warn("neither speed nor longitudinal acceleration was measured",
             "Effects of drag, drive and brakes are not testable");
    if (none({"chassis.roll", "chassis.roll_rate"}))
        warn("neither roll angle nor roll rate was measured",
             "Roll stiffness, damping and centre of gravity height are visible only through the tyre loads");
    if (none({"wheel.front_left.spin", "wheel.front_right.spin", "wheel.rear_left.spin", "wheel.rear_right.spin"}))
        warn("no wheel speed was measured",
             "Wheel radius, slip stiffness, brake balance and differentials can hardly be separated");
}

void checkExcitation(std::vector<DataWarning>& found, const std::vector<Log>& logs) {
    double lateral = 0, speeds = 0, slowest = kInfinity, fastest = 0;
    bool turning_known = false;
    for (const Log& log : logs) {
        turning_known = turning_known || has(log, "chassis.ay") || has(log, "chassis.yaw_rate");
        lateral = std::max(lateral, 0.5 * range(log, "chassis.ay"));
        const Channel *vx = measuredAs(log, "chassis.vx"), *yaw_rate = measuredAs(log, "chassis.yaw_rate");
        if (!vx) continue;
        speeds = std::max(speeds, range(log, "chassis.vx"));
        for (std::size_t i = 0; i < vx->values.size(); ++i) {
            if (!std::isfinite(vx->values[i])) continue;
            slowest = std::min(slowest, vx->values[i]);
            fastest = std::max(fastest, vx->values[i]);
            if (!has(log, "chassis.ay") && yaw_rate && std::isfinite(yaw_rate->values[i]))
                lateral = std::max(lateral, std::abs(vx->values[i] * yaw_rate->values[i]));
        }
    }
    const auto warn = [&](std::string what, const char* why, const char* advice) {
        found.push_back({"all recordings", std::move(what), why, advice});
    };
    if (turning_known && lateral < kLateral)
        warn(fmt::format("lateral acceleration never exceeds {:.2g} m/s2", lateral),
             "Effects of tyres, steering and suspension are not testable with these drives",
             "Add a step steer, a sine sweep or a lane change");
    if (fastest == 0) return;
    if (speeds < kSpeeds)
        warn(fmt::format("the speed changes by no more than {:.2g} m/s in any drive", speeds),
             "Effects of drive, brakes and drag are not testable with these drives",
             "Add a coast-down, an acceleration and a braking manoeuvre");
    else if (fastest < 2 * std::max(slowest, 1.0))
        warn(fmt::format("all speeds are between {:.3g} and {:.3g} m/s", slowest, fastest),
             "Effects that depend on speed (drag, lift, understeer) are hard to separate from those that do not",
             "Add a drive at another speed");
}

bool alike(const Log& a, const Log& b) {
    const Channel *x = a.find("driver.steering_wheel_angle"), *y = b.find("driver.steering_wheel_angle");
    if (!x || !y || std::abs(a.channels[0].values.back() - b.channels[0].values.back()) > 0.5) return false;
    const Channel *u = a.find("chassis.vx"), *v = b.find("chassis.vx");
    if (u && v && std::abs(u->values.front() - v->values.front()) > 1) return false;
    return relation(x->values, y->values).correlation > kAlike;
}

void checkTheSet(std::vector<DataWarning>& found, const DiagnosisFile& file, const std::vector<Log>& logs) {
    const auto warn = [&](const char* what, const char* why, const char* advice) {
        found.push_back({"all recordings", what, why, advice});
    };
    std::size_t training = 0, references = 0;
    std::set<std::string> groups;
    bool repeats = false;
    for (const Recording& recording : file.recordings) {
        training += !recording.hold_out;
        references += !recording.reference.empty();
        if (!recording.repeat_group.empty()) repeats |= !groups.insert(recording.repeat_group).second;
    }
    if (training == 1)
        warn("only one recording is used for fitting",
             "The best test for an unknown cause, a parameter that differs between drives, is not possible",
             "Add other manoeuvres");
    if (references > 0 && references < file.recordings.size())
        warn("only some of the recordings have a reference",
             "Without a reference, a model error that existed before is mistaken for a change of the car",
             "Give every recording a reference, or remove those without one");
    if (training == file.recordings.size())
        warn("no recording is held out", "The gap is then judged in the fitted drives, which is too optimistic",
             "Set hold_out: true for one or two recordings");
    bool all_alike = logs.size() > 1 && !repeats;
    for (std::size_t i = 1; i < logs.size(); ++i) all_alike = all_alike && alike(logs[0], logs[i]);
    if (all_alike)
        warn("all recordings show the same manoeuvre at the same speed",
             "Causes with the same response in this manoeuvre cannot be separated",
             "Add other manoeuvres; give repeated recordings a repeat_group");
}

}  // namespace

std::string toText(const DataWarning& warning) {
    return fmt::format("{}: {}. {}. {}.", warning.where, warning.what, warning.why, warning.advice);
}

std::vector<DataWarning> dataWarnings(const DiagnosisFile& file, const Recorded& recorded, const Subject& nominal) {
    std::vector<DataWarning> found;
    const auto check = [&](const Recording& recording, const Log& whole) {
        const Log log = withUsedChannels(whole, file);
        const LogChecks checks{recording, log, nominal, found};
        if (standsStill(checks)) return;
        checkInputs(checks);
        checkDrive(checks);
        checkChannels(checks);
        checkKinematics(checks);
        checkCar(checks);
    };
    for (std::size_t i = 0; i < recorded.logs.size(); ++i) {
        const Recording& recording = file.recordings[i];
        check(recording, recorded.logs[i]);
        if (recording.reference.empty()) continue;
        const Recording reference = referenceOf(recording);
        check(reference, recorded.references[i]);
        const LogChecks before{reference, recorded.references[i], nominal, found};
        checkReference(before, file, recorded.logs[i]);
        checkSameCar(before, {recording, recorded.logs[i], nominal, found});
    }
    for (std::size_t i = 0; i < recorded.before.size(); ++i) check(file.before[i], recorded.before[i]);
    checkNamed(found, file, recorded.logs);
    checkResponses(found, recorded.logs);
    checkExcitation(found, recorded.logs);
    checkTheSet(found, file, recorded.logs);
    return found;
}

}  // namespace tread::recording::checks
