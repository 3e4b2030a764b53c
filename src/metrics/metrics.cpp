#include "metrics/metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "metrics/manoeuvres.h"

namespace tread {

// What is more special comes first: a car that is dropped is parked as well, a step is slow steering at its end.
const std::vector<Manoeuvre>& manoeuvres() {
    static const std::vector<Manoeuvre> list = {dropAndSettle(),
                                                hillStart(),
                                                parked(),
                                                straightBraking(),
                                                splitMuBraking(),
                                                brakingInTurn(),
                                                acceleration(),
                                                coastDown(),
                                                powerOff(),
                                                freeSteer(),
                                                fishhook(),
                                                jTurn(),
                                                stepSteer(),
                                                sineSteer(),
                                                sineWithDwell(),
                                                steadyCircle(),
                                                slowlyIncreasingSteer(),
                                                frequencyResponse(),
                                                weave(),
                                                transition(),
                                                laneChange(),
                                                course(),
                                                crosswind(),
                                                bump(),
                                                ride(),
                                                straightRunning()};
    return list;
}

namespace {

std::vector<Metric> metricsOf(const Manoeuvre& manoeuvre, const Log& log, const KnownCar& car) {
    try {
        return manoeuvre.metrics(log, car);
    } catch (const NotInLog& why) {
        throw MetricError(fmt::format("no {} in this log: {}", manoeuvre.name, why.what()));
    }
}

}  // namespace

std::vector<Metric> metrics(const Log& log, std::string_view manoeuvre, const KnownCar& car) {
    std::string names;
    for (const Manoeuvre& known : manoeuvres()) {
        if (known.name == manoeuvre) return metricsOf(known, log, car);
        names += fmt::format("{}{}", names.empty() ? "" : ", ", known.name);
    }
    throw MetricError(fmt::format("unknown manoeuvre '{}', expected one of {}", manoeuvre, names));
}

std::string detectManoeuvre(const Log& log) {
    std::string looked_for = "the log contains none of the known manoeuvres:";
    for (const Manoeuvre& known : manoeuvres()) {
        try {
            metricsOf(known, log, {});
            return std::string(known.name);
        } catch (const MetricError& error) {
            looked_for += fmt::format("\n  {}", error.what());
        }
    }
    throw MetricError(looked_for);
}

std::string text(std::string_view manoeuvre, const std::vector<Metric>& metrics) {
    std::size_t name_width = 0, unit_width = 0, title_width = 0;
    for (const Metric& metric : metrics) {
        name_width = std::max(name_width, metric.name.size());
        title_width = std::max(title_width, titleOf(metric).size());
        unit_width = std::max(unit_width, metric.unit.size());
    }
    std::string out = fmt::format("{}: {} metrics\n\n", manoeuvre, metrics.size());
    for (const Metric& metric : metrics) {
        const std::string value = std::isnan(metric.value) ? "undefined" : fmt::format("{:.5g}", metric.value);
        out += fmt::format("{:<{}}  {:>11}  {:<{}}  {:<{}}  {}\n", titleOf(metric), title_width, value, metric.unit,
                           unit_width, metric.name, name_width, metric.definition);
    }
    return out;
}

// A metric that is not defined is null.
nlohmann::json json(const std::vector<Metric>& metrics) {
    nlohmann::json out = nlohmann::json::array();
    for (const Metric& metric : metrics) {
        out.push_back({{"name", metric.name},
                       {"title", titleOf(metric)},
                       {"value", std::isnan(metric.value) ? nlohmann::json(nullptr) : nlohmann::json(metric.value)},
                       {"unit", metric.unit},
                       {"definition", metric.definition}});
    }
    return out;
}

}  // namespace tread
