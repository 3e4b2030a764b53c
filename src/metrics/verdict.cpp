#include "metrics/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/did_you_mean.h"
#include "base/number_text.h"
#include "scenario/condition.h"

namespace tread {
namespace {

std::optional<Interval> intervalOf(const std::string& condition, const std::string& unit, std::string& fault) {
    const auto parsed = parseCondition(condition, fault);
    return parsed ? tread::intervalOf(*parsed, unit, fault) : std::nullopt;
}

std::string unknownMetric(const std::string& name, std::string_view manoeuvre,
                          const std::vector<MetricDefinition>& known) {
    if (manoeuvre.empty()) {
        return "found a condition on " + quote(name) +
               ", but the scenario names no manoeuvre whose metrics are computed; add \"manoeuvre: <name>\"";
    }
    std::vector<std::string_view> names;
    for (const MetricDefinition& definition : known) names.push_back(definition.name);
    return fmt::format("found {}, which is no metric of {}{}; `tread describe metrics` lists them", quote(name),
                       manoeuvre, didYouMean(name, names));
}

std::string count(std::size_t number) {
    return fmt::format("{} condition{}", number, number == 1 ? "" : "s");
}

}  // namespace

std::vector<AcceptFault> acceptFaults(const Acceptance& acceptance, std::string_view manoeuvre,
                                      const std::vector<MetricDefinition>& known) {
    std::vector<AcceptFault> faults;
    for (const AcceptLine& line : acceptance.lines) {
        const auto metric = std::find_if(known.begin(), known.end(),
                                         [&](const MetricDefinition& about) { return about.name == line.metric; });
        std::string fault;
        if (metric == known.end()) {
            faults.push_back({line, unknownMetric(line.metric, manoeuvre, known)});
        } else if (!intervalOf(line.condition, metric->unit, fault)) {
            faults.push_back({line, fault});
        }
    }
    return faults;
}

std::vector<Verdict> judge(const Acceptance& acceptance, const std::vector<Metric>& metrics, const std::string& run) {
    std::vector<Verdict> verdicts;
    for (const AcceptLine& line : acceptance.lines) {
        const auto metric =
            std::find_if(metrics.begin(), metrics.end(), [&](const Metric& m) { return m.name == line.metric; });
        const bool found = metric != metrics.end();
        Verdict verdict{run,
                        line.metric,
                        found ? metric->value : std::numeric_limits<double>::quiet_NaN(),
                        found ? metric->unit : "",
                        line.condition,
                        false};
        std::string fault;
        if (const auto wanted = intervalOf(line.condition, verdict.unit, fault); found && wanted)
            verdict.met = wanted->holds(verdict.value);
        verdicts.push_back(std::move(verdict));
    }
    return verdicts;
}

bool allMet(const std::vector<Verdict>& verdicts) {
    return std::all_of(verdicts.begin(), verdicts.end(), [](const Verdict& verdict) { return verdict.met; });
}

std::string text(const Verdict& verdict) {
    const std::string value =
        std::isnan(verdict.value) ? "could not be computed" : fmt::format("{:.5g}", verdict.value);
    const bool has_unit = !std::isnan(verdict.value) && !verdict.unit.empty() && verdict.unit != "-";
    return fmt::format("{}{}: {}{}, wanted {}: {}", verdict.run.empty() ? "" : "run " + verdict.run + ", ",
                       verdict.metric, value, has_unit ? " " + verdict.unit : "", verdict.condition,
                       verdict.met ? "met" : "missed");
}

std::string answer(const std::vector<Verdict>& verdicts) {
    if (verdicts.empty()) return {};
    const auto missed = static_cast<std::size_t>(
        std::count_if(verdicts.begin(), verdicts.end(), [](const Verdict& verdict) { return !verdict.met; }));
    if (missed == 0) return fmt::format("accepted: {} met", count(verdicts.size()));
    return fmt::format("not accepted: {} of {} missed", missed, count(verdicts.size()));
}

nlohmann::json json(const std::vector<Verdict>& verdicts) {
    nlohmann::json list = nlohmann::json::array();
    for (const Verdict& verdict : verdicts) {
        const bool known = std::isfinite(verdict.value);
        list.push_back({{"run", verdict.run},
                        {"metric", verdict.metric},
                        {"value", known ? nlohmann::json(verdict.value) : nlohmann::json(nullptr)},
                        {"unit", verdict.unit},
                        {"condition", verdict.condition},
                        {"met", verdict.met},
                        {"text", text(verdict)}});
    }
    return list;
}

}  // namespace tread
