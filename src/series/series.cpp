#include "series/series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/fields/numbers.h"
#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "base/yaml/setting.h"
#include "metrics/channels.h"
#include "metrics/metrics.h"
#include "run/simulate.h"
#include "scenario/load.h"

namespace tread {
namespace {

constexpr int kMostTries = 25;

Number numberAt(Scenario& scenario, const std::string& path) {
    std::vector<Number> all = numbers(scenario);
    const auto found = std::find_if(all.begin(), all.end(), [&](const Number& n) { return n.path == path; });
    if (found != all.end()) return *found;
    std::vector<std::string_view> known;
    for (const Number& n : all) known.push_back(n.path);
    throw SeriesError(fmt::format("the series names the number {}, which the scenario does not have{}", quote(path),
                                  didYouMean(path, known)));
}

std::string listing(std::string_view) {
    return "`tread describe scenario` lists the fields";
}

// The scenario with a number set from a text with its unit.
Scenario with(Scenario scenario, const std::string& path, const std::string& text) {
    const std::string assignment = path + "=" + text;
    applySettings(scenario, std::span(&assignment, 1), "series", listing);
    return scenario;
}

Scenario with(Scenario scenario, const std::string& path, double value) {
    return with(std::move(scenario), path, numberText(value));
}

// A limit of a number, given with its unit, SI.
double valueOf(const Scenario& scenario, const std::string& path, const std::string& text) {
    Scenario copy = with(scenario, path, text);
    return *numberAt(copy, path).value;
}

const Metric& metricOf(const std::vector<Metric>& metrics, const std::string& name) {
    const auto found = std::find_if(metrics.begin(), metrics.end(), [&](const Metric& m) { return m.name == name; });
    if (found == metrics.end()) {
        std::vector<std::string_view> known;
        for (const Metric& m : metrics) known.push_back(m.name);
        throw SeriesError(fmt::format("the series names the metric {}, which the manoeuvre does not have{}",
                                      quote(name), didYouMean(name, known)));
    }
    return *found;
}

// The secant method, kept within what is known to enclose the target.
Scenario tunedBy(const Tune& tune, const Scenario& scenario, const Measure& measure) {
    Scenario copy = scenario;
    double low = tune.lowest.empty() ? -kInfinity : valueOf(scenario, tune.number, tune.lowest);
    double high = tune.highest.empty() ? kInfinity : valueOf(scenario, tune.number, tune.highest);
    double value = std::clamp(*numberAt(copy, tune.number).value, low, high);
    double before = kUndefined, missing_before = kUndefined, low_missing = kUndefined, high_missing = kUndefined,
           reached = kUndefined;
    for (int i = 0; i < kMostTries; ++i) {
        const Scenario trial = with(scenario, tune.number, value);
        reached = metricOf(measure(trial), tune.metric).value;
        const double missing = reached - tune.target;
        if (std::abs(missing) <= tune.tolerance * std::abs(tune.target)) return trial;
        // Enclosed: the sign of what is missing changes between the two.
        if (!std::isnan(missing_before) && (missing < 0) != (missing_before < 0)) {
            std::tie(low, low_missing, high, high_missing) = value < before
                                                                 ? std::tuple(value, missing, before, missing_before)
                                                                 : std::tuple(before, missing_before, value, missing);
        } else if (!std::isnan(low_missing)) {
            ((missing < 0) == (low_missing < 0) ? low : high) = value;
        }
        double next = std::isnan(before) ? value * tune.target / reached
                                         : value - missing * (value - before) / (missing - missing_before);
        const bool enclosed = !std::isnan(low_missing);
        if (!std::isfinite(next) || next < low || next > high || (enclosed && (next == low || next == high))) {
            next = enclosed ? 0.5 * (low + high) : std::clamp(std::isfinite(next) ? next : low, low, high);
        }
        if (next == value || !std::isfinite(next)) break;
        before = value;
        missing_before = missing;
        value = next;
    }
    throw SeriesError(fmt::format("no {} between {} and {} gives a {} of {:.4g}: the last try, {:.4g}, gave {:.4g}",
                                  tune.number, tune.lowest.empty() ? "-inf" : tune.lowest,
                                  tune.highest.empty() ? "inf" : tune.highest, tune.metric, tune.target, value,
                                  reached));
}

SeriesRun runWith(const Scenario& scenario, const std::string& number, double value, const std::string& pass,
                  const Measure& measure) {
    SeriesRun run{value, {}, {}, false};
    Scenario one = with(scenario, number, value);
    one.series = {};
    try {
        run.metrics = measure(one);
        run.passed = pass.empty() || metricOf(run.metrics, pass).value == 1;
    } catch (const Interrupted&) {
        throw;
    } catch (const MetricError& error) {
        run.failure = error.what();
    } catch (const SimulationError& error) {
        run.failure = error.what();
    }
    return run;
}

// A metric of another scenario, measured in a run of it.
Metric measuredIn(const std::string& file, const std::string& metric, const Measure& measure) {
    try {
        return metricOf(measure(tuned(loadScenario(file), measure)), metric);
    } catch (const Interrupted&) {
        throw;
    } catch (const SimulationError& error) {
        throw SeriesError(
            fmt::format("{} of {}, which the series needs first, cannot be obtained: {}", metric, file, error.what()));
    }
}

std::string times(double factor, const Metric& metric) {
    if (std::isnan(metric.value)) {
        throw SeriesError(
            fmt::format("the other scenario of the series gives no {}, which the factors multiply", metric.name));
    }
    return fmt::format("{} {}", numberText(factor * metric.value), metric.unit);
}

Scenario scaledBy(const Scale& scale, const Scenario& scenario, const Measure& measure) {
    return with(scenario, scale.number, times(scale.factor, measuredIn(scale.of_scenario, scale.of_metric, measure)));
}

std::vector<double> valuesOf(const Vary& vary, const Scenario& scenario, const Measure& measure) {
    std::vector<double> values;
    for (const std::string& text : vary.values) values.push_back(valueOf(scenario, vary.number, text));
    if (!vary.factors.empty()) {
        const Metric unit = measuredIn(vary.of_scenario, vary.of_metric, measure);
        for (const double factor : vary.factors) values.push_back(valueOf(scenario, vary.number, times(factor, unit)));
    }
    if (!vary.least_last.empty())
        values.back() = std::max(values.back(), valueOf(scenario, vary.number, vary.least_last));
    if (!vary.largest.empty()) {
        const double largest = valueOf(scenario, vary.number, vary.largest);
        for (double& value : values) value = std::min(value, largest);
    }
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

}  // namespace

Scenario tuned(Scenario scenario, const Measure& measure) {
    const std::vector<Scale> scales = scenario.series.scale;
    for (const Scale& scale : scales) scenario = scaledBy(scale, scenario, measure);
    const std::vector<Tune> all = scenario.series.tune;
    for (const Tune& tune : all) scenario = tunedBy(tune, scenario, measure);
    return scenario;
}

SeriesResult series(const Scenario& scenario, const Measure& measure, const Measure& run) {
    SeriesResult found{"", "", {}, kUndefined};
    Scenario copy = scenario;
    const auto add = [&](double value, const std::string& pass) {
        found.runs.push_back(runWith(scenario, found.number, value, pass, run));
        return found.runs.back().passed;
    };
    if (const auto& vary = scenario.series.vary) {
        found.number = vary->number;
        found.unit = numberAt(copy, vary->number).about.unit;
        for (const double value : valuesOf(*vary, scenario, measure)) add(value, vary->pass);
    }
    if (const auto& search = scenario.series.highest) {
        found.number = search->number;
        found.unit = numberAt(copy, search->number).about.unit;
        double good = valueOf(scenario, search->number, search->lowest);
        double bad = valueOf(scenario, search->number, search->highest);
        const double resolution = valueOf(scenario, search->number, search->resolution);
        if (!add(good, search->pass)) return found;
        if (add(bad, search->pass)) good = bad;
        while (bad - good > resolution) (add(0.5 * (good + bad), search->pass) ? good : bad) = 0.5 * (good + bad);
        found.highest = good;
    }
    return found;
}

MetricDefinition highestMetric(const Scenario& scenario) {
    const std::string& number = scenario.series.highest->number;
    Scenario copy = scenario;
    std::string unit;
    for (const Number& one : numbers(copy))
        if (one.path == number) unit = one.about.unit;
    std::string words = number;
    for (char& c : words)
        if (c == '.' || c == '_') c = ' ';
    return {"highest_" + number, "Highest " + words + " that passes", unit, "highest value that passes"};
}

std::vector<Metric> highestOf(const Scenario& scenario, const SeriesResult& found) {
    if (std::isnan(found.highest)) return {};
    const MetricDefinition about = highestMetric(scenario);
    return {{about.name, found.highest, about.unit, about.definition, about.say, about.title}};
}

Scenario withHighest(const Scenario& scenario, const SeriesResult& found) {
    Scenario one = with(scenario, found.number, found.highest);
    one.series = {};
    return one;
}

std::string faultOf(const Scenario& scenario) {
    try {
        const auto known = [&](const std::string& number, std::initializer_list<std::string> texts) {
            Scenario copy = scenario;
            numberAt(copy, number);
            for (const std::string& text : texts) {
                if (!text.empty()) valueOf(scenario, number, text);
            }
        };
        for (const Scale& scale : scenario.series.scale) known(scale.number, {});
        for (const Tune& tune : scenario.series.tune) known(tune.number, {tune.lowest, tune.highest});
        if (const auto& vary = scenario.series.vary) {
            known(vary->number, {vary->least_last, vary->largest});
            for (const std::string& text : vary->values) known(vary->number, {text});
        }
        if (const auto& search = scenario.series.highest) {
            known(search->number, {search->lowest, search->highest, search->resolution});
            if (search->lowest.empty() || search->highest.empty() || search->resolution.empty())
                return "highest needs lowest, highest and resolution";
        }
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return {};
}

}  // namespace tread
