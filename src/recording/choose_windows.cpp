#include "recording/choose_windows.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "log/log_columns.h"
#include "recording/observation.h"

namespace tread::recording {
namespace {

constexpr double kLong = 180;      // s
constexpr double kWindow = 20;     // s
constexpr double kStep = 0.5;      // s between the windows that are considered
constexpr double kGentle = 0.5;    // m/s2; a replay starts best where the car drives nearly straight on
constexpr double kLeastSpeed = 1;  // m/s; a car that stands or crawls shows nothing

struct Window {
    double from = 0;
    double excitation = 0;  // mean square of the acceleration, (m/s2)^2
};

// Mean of the squared acceleration, from speed and yaw rate, or from the steering-wheel angle without them.
double excitationOf(const Log& log, std::size_t first, std::size_t last) {
    const Channel *vx = measuredAs(log, "chassis.vx"), *r = measuredAs(log, "chassis.yaw_rate"),
                  *steer = log.find("driver.steering_wheel_angle");
    const std::vector<double>& time = log.channels.front().values;
    const std::size_t reach = std::max<std::size_t>(1, (last - first) / 80);  // a quarter of a second
    double sum = 0, count = 0;
    for (std::size_t i = first; i + reach < last; ++i) {
        const double along = vx ? (vx->values[i + reach] - vx->values[i]) / (time[i + reach] - time[i]) : 0;
        const double across = vx && r ? vx->values[i] * r->values[i] : steer ? steer->values[i] : 0;
        const double square = along * along + across * across;
        if (std::isfinite(square)) sum += square, count += 1;
    }
    return count > 0 ? sum / count : 0;
}

bool startsGently(const Log& log, std::size_t at) {
    const Channel *vx = measuredAs(log, "chassis.vx"), *r = measuredAs(log, "chassis.yaw_rate");
    if (vx && !(vx->values[at] > kLeastSpeed)) return false;
    return !vx || !r || std::abs(vx->values[at] * r->values[at]) < kGentle;
}

std::vector<Window> candidates(const Log& log, bool gentle) {
    const std::vector<double>& time = log.channels.front().values;
    std::vector<Window> found;
    for (double from = 0; from + kWindow <= time.back(); from += kStep) {
        const auto first = static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), from) - time.begin());
        const auto last =
            static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), from + kWindow) - time.begin());
        if (last - first > 2 && (!gentle || startsGently(log, first)))
            found.push_back({from, excitationOf(log, first, last)});
    }
    return found;
}

// The best windows that do not overlap, in the order of time.
std::vector<Window> best(std::vector<Window> candidates, std::size_t most) {
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Window& a, const Window& b) { return a.excitation > b.excitation; });
    std::vector<Window> chosen;
    for (const Window& one : candidates) {
        const bool apart = std::all_of(chosen.begin(), chosen.end(),
                                       [&](const Window& other) { return std::abs(one.from - other.from) >= kWindow; });
        if (apart && chosen.size() < most) chosen.push_back(one);
    }
    std::sort(chosen.begin(), chosen.end(), [](const Window& a, const Window& b) { return a.from < b.from; });
    return chosen;
}

Log part(const Log& log, double from) {
    Log cut;
    if (log.channels.empty()) return cut;
    const std::vector<double>& time = log.channels.front().values;
    const auto first = std::lower_bound(time.begin(), time.end(), from) - time.begin(),
               last = std::upper_bound(time.begin(), time.end(), from + kWindow) - time.begin();
    for (const Channel& channel : log.channels)
        cut.channels.push_back(
            {channel.name, channel.unit, {channel.values.begin() + first, channel.values.begin() + last}});
    for (double& t : cut.channels.front().values) t -= from;
    return cut;
}

// Recordings with their logs, and with those of their references if there are any.
struct Windowed {
    std::vector<Recording> recordings = {};
    std::vector<Log> logs = {};
    std::vector<Log> references = {};
};

// The windows that are used of the recordings, at most so many of each.
Windowed windowsOf(const Windowed& whole, std::size_t most, std::vector<std::string>& notes) {
    Windowed chosen;
    const bool referred = !whole.references.empty();
    for (std::size_t i = 0; i < whole.recordings.size(); ++i) {
        const Recording& recording = whole.recordings[i];
        const Log& log = whole.logs[i];
        const double seconds = log.channels.front().values.back();
        if (seconds <= kLong) {
            chosen.recordings.push_back(recording);
            chosen.logs.push_back(log);
            if (referred) chosen.references.push_back(whole.references[i]);
            continue;
        }
        std::vector<Window> windows = best(candidates(log, true), most);
        if (windows.empty()) windows = best(candidates(log, false), most);
        std::vector<std::string> said;
        for (const Window& window : windows) {
            said.push_back(fmt::format("{:g} to {:g} s", window.from, window.from + kWindow));
            chosen.recordings.push_back(recording);
            chosen.recordings.back().name = recording.name + ", " + said.back();
            chosen.logs.push_back(part(log, window.from));
            if (referred) chosen.references.push_back(part(whole.references[i], window.from));
        }
        notes.push_back(fmt::format(
            "{}: lasts {:.0f} s, of which the windows with the largest accelerations are used: {}; windows: 0 uses the "
            "whole recording",
            recording.name, seconds, fmt::join(said, ", ")));
    }
    return chosen;
}

}  // namespace

void chooseWindows(DiagnosisFile& file, Recorded& recorded) {
    const auto most = static_cast<std::size_t>(file.windows);
    if (most == 0) return;
    Windowed after = windowsOf({file.recordings, recorded.logs, recorded.references}, most, recorded.notes);
    file.recordings = std::move(after.recordings);
    recorded.logs = std::move(after.logs);
    recorded.references = std::move(after.references);
    Windowed before = windowsOf({file.before, recorded.before, {}}, most, recorded.notes);
    file.before = std::move(before.recordings);
    recorded.before = std::move(before.logs);
}

}  // namespace tread::recording
