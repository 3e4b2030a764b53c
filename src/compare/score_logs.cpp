#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/text/pattern.h"
#include "compare/score.h"
#include "log/resample.h"

namespace tread {
namespace {

constexpr std::size_t kFewest = 10;  // samples: less is no curve
constexpr std::size_t kMost = 4000;  // warping costs time and memory with the square

// Uniform samples over the common time, as many as the measurement has.
std::vector<double> commonTime(const Log& measured, const Log& candidate) {
    const std::vector<double>&a = measured.channels.front().values, &b = candidate.channels.front().values;
    const double from = std::max(a.front(), b.front()), to = std::min(a.back(), b.back());
    const auto inside = std::count_if(a.begin(), a.end(), [&](double t) { return t >= from && t <= to; });
    const std::size_t count = std::min(static_cast<std::size_t>(inside), kMost);
    std::vector<double> time;
    if (count < kFewest || !(to > from)) return time;
    for (std::size_t i = 0; i < count; ++i) {
        time.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(count - 1));
    }
    return time;
}

bool finite(const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

bool wanted(const std::string& channel, const ScoreParams& params) {
    return std::any_of(params.scored.begin(), params.scored.end(),
                       [&](const std::string& pattern) { return matches(pattern, channel); });
}

void scoreOne(Scores& scores, const NamedLog& measured, const Log& candidate, const ScoreParams& params) {
    const std::vector<double> time = commonTime(measured.log, candidate);
    if (time.empty()) {
        scores.notes.push_back("The simulation and " + measured.name + " have fewer than ten samples in common.");
        return;
    }
    for (const Channel& channel : measured.log.channels) {
        if (channel.name == "time" || !wanted(channel.name, params)) continue;
        const Channel* const other = candidate.find(channel.name);
        if (!other || other->unit != channel.unit) {
            scores.notes.push_back(fmt::format("{} of {} was not scored: {} in the simulation.", channel.name,
                                               measured.name, other ? "its unit is " + other->unit : "it is missing"));
            continue;
        }
        const std::vector<double> a = resample(measured.log.channels.front().values, channel.values, time);
        const std::vector<double> b = resample(candidate.channels.front().values, other->values, time);
        if (!finite(a) || !finite(b)) {
            scores.notes.push_back(channel.name + " of " + measured.name + " was not scored: it is not finite.");
            continue;
        }
        const Score found = score(a, b, params);
        scores.channels.push_back({channel.name, measured.name, found, found.shift * (time[1] - time[0])});
    }
}

const ChannelScore& worst(const Scores& scores) {
    return *std::min_element(
        scores.channels.begin(), scores.channels.end(),
        [](const ChannelScore& a, const ChannelScore& b) { return a.score.total < b.score.total; });
}

std::string answer(const Scores& scores) {
    if (scores.channels.empty()) return "Not scored: the logs share none of the channels";
    const ChannelScore& low = worst(scores);
    return fmt::format("{}: lowest ISO 18571 score {:.3f} ({}, {}), threshold {:.2g}",
                       scores.passed ? "Good agreement" : "Poor agreement", low.score.total, low.channel,
                       gradeOf(low.score.total), scores.least);
}

}  // namespace

Scores scoreLogs(const std::vector<NamedLog>& measured, const Log& candidate, const ScoreParams& params) {
    Scores scores;
    scores.least = params.least;
    for (const NamedLog& log : measured) scoreOne(scores, log, candidate, params);
    scores.passed = !scores.channels.empty() && worst(scores).score.total >= params.least;
    return scores;
}

std::string text(const Scores& scores) {
    std::string out = answer(scores) + "\n";
    for (const std::string& note : scores.notes) out += note + "\n";
    if (scores.channels.empty()) return out;
    std::size_t width = 7;
    for (const ChannelScore& channel : scores.channels) width = std::max(width, channel.channel.size());
    out += fmt::format("\n{:<{}}  {:>6}  {:<9}  {:>8}  {:>6}  {:>9}  {:>6}  {:>10}  against\n", "channel", width,
                       "score", "grade", "corridor", "phase", "magnitude", "slope", "late [s]");
    for (const ChannelScore& channel : scores.channels) {
        const Score& s = channel.score;
        out += fmt::format("{:<{}}  {:>6.3f}  {:<9}  {:>8.3f}  {:>6.3f}  {:>9.3f}  {:>6.3f}  {:>10.4g}  {}\n",
                           channel.channel, width, s.total, gradeOf(s.total), s.corridor, s.phase, s.magnitude, s.slope,
                           channel.shift, channel.reference);
    }
    return out;
}

nlohmann::json json(const Scores& scores) {
    nlohmann::json list = nlohmann::json::array();
    for (const ChannelScore& channel : scores.channels) {
        const Score& s = channel.score;
        list.push_back({{"channel", channel.channel},
                        {"reference", channel.reference},
                        {"score", s.total},
                        {"grade", gradeOf(s.total)},
                        {"corridor", s.corridor},
                        {"phase", s.phase},
                        {"magnitude", s.magnitude},
                        {"slope", s.slope},
                        {"shift", channel.shift}});
    }
    return {{"passed", scores.passed},
            {"answer", answer(scores)},
            {"least", scores.least},
            {"channels", list},
            {"notes", scores.notes}};
}

}  // namespace tread
