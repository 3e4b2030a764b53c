#include "report/series_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "report/shown_metric.h"
#include "report/text.h"
#include "scenario/condition.h"

namespace tread {
namespace {

constexpr std::size_t kMostCharts = 6;

struct Limit {
    std::string name;
    double value;  // in the unit of the metric
};

std::vector<Limit> limitsOf(const std::string& whose, const std::string& condition, const std::string& unit) {
    std::string fault;
    const auto parsed = parseCondition(condition, fault);
    const auto wanted = parsed ? intervalOf(*parsed, unit, fault) : std::nullopt;
    std::vector<Limit> limits;
    if (!wanted) return limits;
    const std::string name = fmt::format("{}: {}", whose, condition);
    if (std::isfinite(wanted->lowest)) limits.push_back({name, wanted->lowest});
    const bool point = wanted->highest - wanted->lowest <= 1e-6 * std::abs(wanted->highest);
    if (std::isfinite(wanted->highest) && !point) limits.push_back({limits.empty() ? name : "", wanted->highest});
    return limits;
}

// The limits of the user's conditions; where there are none, those of the standard.
std::vector<Limit> limitsOf(const Metric& metric, const std::vector<Verdict>& verdicts) {
    std::vector<Limit> limits;
    std::vector<std::string> seen;
    for (const Verdict& verdict : verdicts) {
        if (verdict.metric != metric.name || std::find(seen.begin(), seen.end(), verdict.condition) != seen.end())
            continue;
        seen.push_back(verdict.condition);
        for (Limit& limit : limitsOf("accepted", verdict.condition, metric.unit)) limits.push_back(std::move(limit));
    }
    if (limits.empty()) limits = limitsOf("standard", metric.standard, metric.unit);
    return limits;
}

// One metric of all runs, in the order of the varied number.
struct MetricCurve {
    std::vector<double> x, y;  // as shown
    std::vector<bool> passed;
};

MetricCurve curveOf(const SeriesReport& content, std::size_t metric, double scale_x, double scale_y) {
    std::vector<std::size_t> order(content.runs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return content.runs[a].value < content.runs[b].value; });
    MetricCurve curve;
    for (const std::size_t i : order) {
        const SeriesReport::Run& run = content.runs[i];
        if (run.metrics.size() <= metric || !std::isfinite(run.metrics[metric].value)) continue;
        curve.x.push_back(run.value * scale_x);
        curve.y.push_back(run.metrics[metric].value * scale_y);
        curve.passed.push_back(run.passed);
    }
    return curve;
}

// A flag, or what hardly changes, makes no curve.
bool isWorthDrawing(const Metric& metric, const MetricCurve& curve, bool limited) {
    if (curve.x.size() < 2) return false;
    if (limited) return true;
    const auto isFlag = [](double value) { return value == 0 || value == 1; };
    if (metric.unit == "-" && std::all_of(curve.y.begin(), curve.y.end(), isFlag)) return false;
    constexpr double kHardly = 1e-3;  // of the largest value
    const auto [low, high] = std::minmax_element(curve.y.begin(), curve.y.end());
    return *high - *low > kHardly * std::max(std::abs(*low), std::abs(*high));
}

Series pointsOf(const MetricCurve& curve, bool passed) {
    Series points{.name = passed ? "passed" : "not passed",
                  .x = {},
                  .y = {},
                  .colour = passed ? Colour::green : Colour::vermillion,
                  .line = false,
                  .markers = true};
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        if (curve.passed[i] != passed) continue;
        points.x.push_back(curve.x[i]);
        points.y.push_back(curve.y[i]);
    }
    return points;
}

Series straight(std::string name, std::vector<double> x, std::vector<double> y, Colour colour) {
    Series line{.name = std::move(name), .x = std::move(x), .y = std::move(y), .colour = colour, .dashed = true};
    line.width = 1.4;
    return line;
}

Chart chartOf(const SeriesReport& content, const Metric& metric, const MetricCurve& curve,
              const std::vector<Limit>& limits) {
    const DisplayUnit varied = displayUnit(content.unit), shown = displayUnit(metric);
    Chart chart{.title = titleOf(metric),
                .x = {variedInWords(content.number), varied.unit},
                .y = {"", shown.unit},
                .series = {}};
    chart.series.push_back({.name = "", .x = curve.x, .y = curve.y, .colour = Colour::blue});
    for (const bool passed : {true, false}) {
        Series points = pointsOf(curve, passed);
        if (!points.x.empty()) chart.series.push_back(std::move(points));
    }
    for (const Limit& limit : limits)
        chart.series.push_back(straight(limit.name, {curve.x.front(), curve.x.back()},
                                        {limit.value * shown.scale, limit.value * shown.scale}, Colour::purple));
    if (std::isfinite(content.highest)) {
        const auto [low, high] = std::minmax_element(curve.y.begin(), curve.y.end());
        const double at = content.highest * varied.scale;
        chart.series.push_back(straight("highest that passes", {at, at}, {*low, *high}, Colour::grey));
    }
    chart.note = metric.definition;
    return chart;
}

}  // namespace

std::string variedInWords(const std::string& path) {
    std::string words = path.substr(path.rfind('.') + 1);
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

std::vector<Chart> seriesFigures(const SeriesReport& content) {
    const auto full =
        std::find_if(content.runs.begin(), content.runs.end(), [](const auto& run) { return !run.metrics.empty(); });
    if (full == content.runs.end()) return {};
    const std::vector<Metric>& metrics = full->metrics;
    std::vector<std::size_t> order(metrics.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto place = [&](std::size_t i) {
        constexpr int kLimited = 0, kSaid = 1, kOther = 1000;
        if (!limitsOf(metrics[i], content.verdicts).empty()) return kLimited;
        return metrics[i].say.rank > 0 ? kSaid + metrics[i].say.rank : kOther;
    };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return place(a) < place(b); });

    std::vector<Chart> charts;
    const double scale_x = displayUnit(content.unit).scale;
    for (const std::size_t i : order) {
        if (charts.size() == kMostCharts) break;
        const MetricCurve curve = curveOf(content, i, scale_x, displayUnit(metrics[i]).scale);
        const std::vector<Limit> limits = limitsOf(metrics[i], content.verdicts);
        if (isWorthDrawing(metrics[i], curve, !limits.empty()))
            charts.push_back(chartOf(content, metrics[i], curve, limits));
    }
    return charts;
}

}  // namespace tread
