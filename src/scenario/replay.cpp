#include "scenario/replay.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "base/yaml/session.h"
#include "log/csv.h"
#include "scenario/run_in.h"

namespace tread {
namespace {

// Calls visit(signal, replay, path) for every replay of a scenario.
void forEachReplay(auto& scenario, const auto& visit) {
    for (std::size_t i = 0; i < scenario.phases.size(); ++i) {
        auto& phase = scenario.phases[i];
        const std::string path = "phases." + std::to_string(i);
        const auto look = [&]<class Of>(auto& signal, const char* name, Of) {
            if (auto* replay = std::get_if<Replay<Of>>(&signal)) visit(signal, *replay, path + "." + name + ".replay");
        };
        look(phase.steering, "steering", Angle{});
        look(phase.throttle, "throttle", Pedal{});
        look(phase.brake, "brake", Pedal{});
        look(phase.clutch, "clutch", Pedal{});
        look(phase.parking_brake, "parking_brake", Pedal{});
    }
}

// The logs that a scenario names, each read once, and what was wrong with the channels asked for.
struct Logs {
    const Log& log(const std::string& file) {
        auto found = read.find(file);
        if (found == read.end()) found = read.emplace(file, readLog(file)).first;
        return found->second;
    }

    // What a signal of this kind was over the time since `from`; the limits of a pedal hold for a sensor's noise, too.
    template <class Of>
    Curve points(const Replay<Of>& replay, const std::string& path) {
        const auto fault = [&](const char* field, std::string text) {
            problems.push_back({replay.file, 0, 0, path + field, std::move(text)});
            return Curve{};
        };
        const Log& log = this->log(replay.file);
        const Channel* channel = log.find(replay.channel);
        if (!channel) {
            std::vector<std::string_view> names;
            for (const Channel& known : log.channels) names.push_back(known.name);
            return fault(".channel", "found " + quote(replay.channel) + ", which the log does not have" +
                                         didYouMean(replay.channel, names));
        }
        if (channel->unit != Of::kUnit) {
            return fault(".channel", "found " + quote(channel->name + " [" + channel->unit + "]") +
                                         ", expected a channel in " + std::string(Of::kUnit));
        }
        const std::vector<double>& time = log.channels.front().values;
        Curve points;
        for (std::size_t i = 0; i < log.samples(); ++i) {
            const double value = channel->values[i];
            if (!std::isfinite(value)) {
                return fault(".channel", "found a value that is not finite at t = " + numberText(time[i]) +
                                             " s, expected numbers; cut the log or fill the gap");
            }
            const double within = std::clamp(value, Of::kLimits.lowest, Of::kLimits.highest);
            points.points.push_back({time[i] - replay.from, within});
        }
        if (points.empty() || points.points.back().x <= 0)
            return fault(".from", "found " + numberText(replay.from) + " s, which is after the end of the log");
        return points;
    }

    std::map<std::string, Log> read;
    std::vector<Problem> problems;
};

struct Speed {
    static constexpr std::string_view kUnit = "m/s";
    static constexpr Limits kLimits = kNonNegative;
};

bool repeatsDrive(const Scenario& scenario) {
    bool found = false;
    for (const Phase& phase : scenario.phases) {
        const auto* hold = std::get_if<HoldSpeed>(&phase.throttle);
        found = found || phase.until.drive_end || (hold && hold->as_driven);
    }
    forEachReplay(scenario,
                  [&](auto&, const auto& replay, const std::string&) { found = found || replay.file.empty(); });
    return found;
}

// Whether the steering wheel repeats the drive from a moment at which that is in a turn.
bool startsInTurn(const Scenario& scenario, const Log& drive) {
    const auto* hand = std::get_if<Replay<Angle>>(&scenario.phases.front().steering);
    const Channel* yaw_rate = drive.find("chassis.yaw_rate");
    if (!hand || hand->file != scenario.drive || !yaw_rate || scenario.start.run_in > 0) return false;
    const std::vector<double>& time = drive.channels.front().values;
    const auto first = static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), hand->from) - time.begin());
    return beginsInTurn(scenario.start.speed, std::span(time).subspan(first),
                        std::span(yaw_rate->values).subspan(first));
}

// Puts what the drive says where the scenario asks for it, and names it to the replays that name no log. Whether the
// car has to be brought into a turn first.
bool takeDrive(Scenario& scenario, Logs& logs) {
    const bool repeats = repeatsDrive(scenario);
    if (scenario.drive.empty() == repeats) {
        logs.problems.push_back({scenario.drive, 0, 0, "scenario.drive",
                                 repeats ? "found no log of the drive that the scenario repeats; name it here, or with "
                                           "`tread run --log FILE`"
                                         : "found a log of a drive, but nothing that repeats it; expected a replay "
                                           "without a file, hold_speed.as_driven or until.drive_end"});
    }
    if (!repeats || scenario.drive.empty()) return false;
    const Curve speed = logs.points(Replay<Speed>{scenario.drive, "chassis.vx"}, "drive");
    if (speed.empty()) return false;
    if (scenario.start.speed == 0) scenario.start.speed = speed(0);
    for (Phase& phase : scenario.phases) {
        if (auto* hold = std::get_if<HoldSpeed>(&phase.throttle); hold && hold->as_driven) {
            hold->profile = speed;
            hold->as_driven = false;
        }
        if (std::exchange(phase.until.drive_end, false)) phase.until.time = speed.points.back().x;
    }
    forEachReplay(scenario, [&](auto&, auto& replay, const std::string&) {
        if (replay.file.empty()) replay.file = scenario.drive;
    });
    const bool in_turn = startsInTurn(scenario, logs.log(scenario.drive));
    scenario.drive.clear();
    return in_turn;
}

}  // namespace

void placeReplays(Scenario& scenario, const std::filesystem::path& folder) {
    const auto place = [&](std::string& file) {
        if (!file.empty()) file = (folder / file).lexically_normal().string();
    };
    place(scenario.drive);
    forEachReplay(scenario, [&](auto&, auto& replay, const std::string&) { place(replay.file); });
}

Scenario withReplaysRead(Scenario scenario) {
    Logs logs;
    const bool in_turn = takeDrive(scenario, logs);
    throwIfAny(std::move(logs.problems));
    forEachReplay(scenario, [&]<class Of>(auto& signal, const Replay<Of>& replay, const std::string& path) {
        signal = Table<Of>{logs.points(replay, path)};
    });
    throwIfAny(std::move(logs.problems));
    if (in_turn) runIntoTurn(scenario);
    return scenario;
}

}  // namespace tread
