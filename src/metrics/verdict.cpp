#include "metrics/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "base/text/trimmed.h"
#include "base/units/units.h"
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
    return fmt::format("found {}, which is not a metric of {}{}; `tread describe metrics` lists them", quote(name),
                       manoeuvre, didYouMean(name, names));
}

// Distance to the nearest end of the interval that is allowed.
std::optional<double> marginOf(const Interval& wanted, double value) {
    const double margin = std::min(value - wanted.lowest, wanted.highest - value);
    const double width = wanted.highest - wanted.lowest;
    const bool point = std::isfinite(width) && width <= 1e-6 * std::abs(wanted.highest);
    if (!std::isfinite(margin) || point) return {};
    return margin;
}

// The unit behind the first number of a condition; that of the metric where none is written.
std::string unitOf(const Verdict& verdict) {
    std::string fault;
    const auto parsed = parseCondition(verdict.condition, fault);
    std::string_view rest = parsed ? std::string_view(parsed->first) : std::string_view();
    if (!takeNumber(rest)) return verdict.unit;
    const std::string_view written = trimmed(rest);
    return written.empty() ? verdict.unit : std::string(written);
}

// From the unit of the metric to another; the number itself when there is no such conversion.
double converted(double value, const std::string& from, const std::string& to) {
    std::string fault;
    const std::string unit = from.empty() || from == "-" ? "1" : from;
    return toSi(numberText(value) + " " + unit, to, fault).value_or(value);
}

std::string withUnit(double value, const std::string& unit, int digits) {
    const bool pure = unit.empty() || unit == "-";
    return fmt::format("{:.{}g}{}{}", value, digits, pure ? "" : " ", pure ? "" : unit);
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
                        false,
                        found ? titleOf(*metric) : line.metric};
        std::string fault;
        if (const auto wanted = intervalOf(line.condition, verdict.unit, fault); found && wanted) {
            verdict.met = wanted->holds(verdict.value);
            verdict.margin = marginOf(*wanted, verdict.value);
        }
        verdicts.push_back(std::move(verdict));
    }
    return verdicts;
}

bool allMet(const std::vector<Verdict>& verdicts) {
    return std::all_of(verdicts.begin(), verdicts.end(), [](const Verdict& verdict) { return verdict.met; });
}

std::string valueInWords(const Verdict& verdict, int digits) {
    if (std::isnan(verdict.value)) return "could not be computed";
    const std::string unit = unitOf(verdict);
    return withUnit(converted(verdict.value, verdict.unit, unit), unit, digits);
}

std::string marginInWords(const Verdict& verdict) {
    if (!verdict.margin) return {};
    // A difference: what units add to a number (degrees Celsius) goes out.
    const std::string unit = unitOf(verdict);
    const auto inUnit = [&](double value) { return converted(value, verdict.unit, unit); };
    const double margin = std::abs(inUnit(verdict.value + *verdict.margin) - inUnit(verdict.value));
    return withUnit(margin, unit, 3) + (verdict.met ? " to spare" : " beyond");
}

std::string text(const Verdict& verdict) {
    const std::string margin = marginInWords(verdict);
    return fmt::format("{}{}: {}, required {}: {}{}{}", verdict.run.empty() ? "" : "run " + verdict.run + ", ",
                       verdict.metric, valueInWords(verdict), verdict.condition, verdict.met ? "met" : "missed",
                       margin.empty() ? "" : ", ", margin);
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
                        {"title", verdict.title},
                        {"value", known ? nlohmann::json(verdict.value) : nlohmann::json(nullptr)},
                        {"unit", verdict.unit},
                        {"condition", verdict.condition},
                        {"met", verdict.met},
                        {"margin", verdict.margin ? nlohmann::json(*verdict.margin) : nlohmann::json(nullptr)},
                        {"text", text(verdict)}});
    }
    return list;
}

}  // namespace tread
