#include "scenario/replay.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "base/did_you_mean.h"
#include "base/number_text.h"
#include "base/yaml_session.h"
#include "log/csv.h"

namespace tread {
namespace {

// Calls visit(signal, replay, path) for every replay of a scenario.
void forEachReplay(Scenario& scenario, const auto& visit) {
    for (std::size_t i = 0; i < scenario.phases.size(); ++i) {
        Phase& phase = scenario.phases[i];
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

// What a signal of this kind was over the time since `from`; the limits of a pedal hold for a sensor's noise, too.
template <class Of>
Curve pointsOf(const Replay<Of>& replay, const std::string& path, const Log& log, std::vector<Problem>& problems) {
    const auto fault = [&](const char* field, std::string text) {
        problems.push_back({replay.file, 0, 0, path + "." + field, std::move(text)});
        return Curve{};
    };
    const Channel* channel = log.find(replay.channel);
    if (!channel) {
        std::vector<std::string_view> names;
        for (const Channel& known : log.channels) names.push_back(known.name);
        return fault("channel", "found " + quote(replay.channel) + ", which the log does not have" +
                                    didYouMean(replay.channel, names));
    }
    if (channel->unit != Of::kUnit) {
        return fault("channel", "found " + quote(channel->name + " [" + channel->unit + "]") +
                                    ", expected a channel in " + std::string(Of::kUnit));
    }
    const std::vector<double>& time = log.channels.front().values;
    Curve points;
    for (std::size_t i = 0; i < log.samples(); ++i) {
        const double value = channel->values[i];
        if (!std::isfinite(value)) {
            return fault("channel", "found a value that is not finite at t = " + numberText(time[i]) +
                                        " s, expected numbers; cut the log or fill the gap");
        }
        const double beyond = std::clamp(value, Of::kLimits.lowest, Of::kLimits.highest);
        points.points.push_back({time[i] - replay.from, beyond});
    }
    if (points.empty() || points.points.back().x <= 0)
        return fault("from", "found " + numberText(replay.from) + " s, which is behind the end of the log");
    return points;
}

}  // namespace

void placeReplays(Scenario& scenario, const std::filesystem::path& folder) {
    forEachReplay(scenario, [&](auto&, auto& replay, const std::string&) {
        replay.file = (folder / replay.file).lexically_normal().string();
    });
}

Scenario withReplaysRead(Scenario scenario) {
    std::map<std::string, Log> logs;
    std::vector<Problem> problems;
    forEachReplay(scenario, [&]<class Of>(auto& signal, const Replay<Of>& replay, const std::string& path) {
        auto found = logs.find(replay.file);
        if (found == logs.end()) found = logs.emplace(replay.file, readLog(replay.file)).first;
        signal = Table<Of>{pointsOf(replay, path, found->second, problems)};
    });
    throwIfAny(std::move(problems));
    return scenario;
}

}  // namespace tread
