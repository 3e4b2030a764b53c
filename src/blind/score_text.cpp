#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "blind/score.h"
#include "diagnose/answer/diagnosis.h"
#include "diagnose/answer/diagnosis_json.h"

namespace tread {
namespace {

using diagnose::answer::Verdict;

bool reached(const Figure& figure) {
    return figure.at_least ? figure.share() >= figure.target : figure.share() <= figure.target;
}

std::string targetOf(const Figure& figure) {
    if (figure.target == 0) return "";
    const char* word = figure.of == 0 ? "" : reached(figure) ? "reached" : "missed";
    return fmt::format("{} {:.0f} %  {}", figure.at_least ? ">=" : "<=", 100 * figure.target, word);
}

std::string joined(std::vector<std::string> names) {
    std::sort(names.begin(), names.end());
    return fmt::format("{}", fmt::join(names, " + "));
}

double rmsOf(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value * value;
    return values.empty() ? 0 : std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace

std::string scoreText(const BlindScore& score) {
    const Figure& first = score.figure("named_first");
    std::string text = fmt::format(
        "Blind check of {} cases: a single testable effect is named first in {} of {}, false alarms {} of {}, "
        "calibration error {:.3f}\n\n",
        score.cases, first.hits, first.of, score.figure("false_alarm").hits, score.figure("false_alarm").of,
        score.calibration_error);
    for (const Figure& figure : score.figures) {
        const Interval interval = figure.interval();
        const std::string share = figure.of > 0 ? fmt::format("{:5.1f} % [{:.0f}, {:.0f}]", 100 * figure.share(),
                                                              100 * interval.low, 100 * interval.high)
                                                : "-";
        text += fmt::format("  {:<70} {:>7}  {:<20} {}\n", figure.what, fmt::format("{}/{}", figure.hits, figure.of),
                            share, targetOf(figure));
    }
    text +=
        fmt::format("\n  stated probabilities: expected calibration error {:.3f} (<= 0.05)\n", score.calibration_error);
    text += fmt::format("  parameters of the causes named: {} errors, rms {:.2f} sd\n", score.parameter_errors.size(),
                        rmsOf(score.parameter_errors));
    text += "  closure obtained on held-out drives, single effects: ";
    text += score.median_closure ? fmt::format("median {:.0f} %\n", 100 * *score.median_closure)
                                 : "none was blamed on the catalogue and driven again\n";
    text += "  causes in the 90 % set, single effects: ";
    text += score.mean_credible_set
                ? fmt::format("mean {:.1f}, median {:.0f}\n", *score.mean_credible_set, *score.median_credible_set)
                : "there are no cases of one effect\n";
    text += fmt::format("  time of a diagnosis: median {:.0f} s, longest {:.0f} s\n", score.median_seconds,
                        score.longest_seconds);
    if (score.failed > 0) text += fmt::format("  {} cases without an answer\n", score.failed);
    text += "\nWhat was so, and what was answered:\n";
    for (const auto& [truth, answers] : score.confusion) {
        for (const auto& [answer, count] : answers) text += fmt::format("  {:<52} {:<52} {}\n", truth, answer, count);
    }
    return text;
}

std::string scoreJson(const BlindScore& score) {
    using Json = nlohmann::json;
    const auto orNull = [](const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); };
    Json figures = Json::object(), bins = Json::array();
    for (const Figure& figure : score.figures) {
        const Interval interval = figure.interval();
        figures[figure.name] = {{"what", figure.what}, {"hits", figure.hits},
                                {"of", figure.of},     {"share", figure.of > 0 ? Json(figure.share()) : Json(nullptr)},
                                {"low", interval.low}, {"high", interval.high}};
        if (figure.target != 0) figures[figure.name][figure.at_least ? "at_least" : "at_most"] = figure.target;
    }
    for (const ReliabilityBin& bin : score.reliability) {
        bins.push_back(
            {{"from", bin.from}, {"to", bin.to}, {"claims", bin.claims}, {"right", bin.right}, {"stated", bin.stated}});
    }
    const Json json{{"cases", score.cases},
                    {"failed", score.failed},
                    {"figures", figures},
                    {"reliability", bins},
                    {"calibration_error", score.calibration_error},
                    {"parameter_errors", score.parameter_errors},
                    {"parameter_error_rms", rmsOf(score.parameter_errors)},
                    {"median_closure", orNull(score.median_closure)},
                    {"mean_credible_set", orNull(score.mean_credible_set)},
                    {"median_credible_set", orNull(score.median_credible_set)},
                    {"median_seconds", score.median_seconds},
                    {"longest_seconds", score.longest_seconds},
                    {"confusion", score.confusion}};
    return json.dump(2) + "\n";
}

std::string wordsOf(const CaseKey& key) {
    if (key.kind == CaseKind::none) return "nothing";
    if (key.kind == CaseKind::outside) return "outside: " + key.outsider;
    return (key.kind == CaseKind::small ? "too small: " : "") + joined(key.effects);
}

std::string wordsOf(const CaseAnswer& answer) {
    if (answer.verdict == Verdict::explained) return joined(answer.causes);
    if (answer.verdict != Verdict::ambiguous) return std::string(nameOf(answer.verdict));
    std::set<std::string> either{joined(answer.causes)};
    for (const auto& alternative : answer.alternatives) either.insert(joined(alternative));
    return fmt::format("{}", fmt::join(either, " or "));
}

}  // namespace tread
