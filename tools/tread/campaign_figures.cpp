#include "campaign_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "campaign/row.h"
#include "campaign/sensitivity.h"
#include "report/text.h"

namespace tread::program {
namespace {

using campaign::DatabaseReader;
using campaign::mainEffect;
using campaign::Plan;
using campaign::Sampling;
using campaign::Share;
using campaign::sobolIndices;
using campaign::sqlText;
using campaign::Variable;

constexpr std::size_t kDrawnFactors = 4;   // of a metric
constexpr std::size_t kMostInAFigure = 6;  // in one figure
constexpr std::size_t kMostPoints = 1200;  // of a scatter plot
constexpr std::size_t kMostBars = 40;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Takes in a condition on a metric.
void want(MetricHere& metric, const std::string& condition) {
    std::string fault;
    metric.condition = condition;
    const std::optional<Condition> parsed = parseCondition(condition, fault);
    if (!parsed) return;
    metric.wanted = intervalOf(*parsed, metric.about->unit, fault);
    const std::string& text = parsed->first;
    const std::size_t number_ends = text.find_last_of("0123456789.");
    const std::size_t unit =
        number_ends == std::string::npos ? number_ends : text.find_first_not_of(' ', number_ends + 1);
    if (unit != std::string::npos) metric.shown = displayUnitAs(metric.about->unit, text.substr(unit));
}

}  // namespace

std::string titleOf(const MetricHere& metric) {
    return metric.about->title.empty() ? metric.about->name : metric.about->title;
}

std::vector<MetricHere> metricsOf(const Plan& plan, std::size_t scenario) {
    std::vector<MetricHere> all;
    for (const std::size_t i : plan.metrics_of_scenario[scenario]) {
        const MetricDefinition& about = plan.metrics[i];
        MetricHere here{&about, about.name + " [" + about.unit + "]", {}, {}, {about.unit, 1}};
        for (const AcceptLine& line : plan.inputs.scenarios[scenario].scenario.accept.lines) {
            if (line.metric == about.name) want(here, line.condition);
        }
        all.push_back(std::move(here));
    }
    const auto rank = [](const MetricHere& one) {
        return one.wanted ? -1000 : one.about->say.rank > 0 ? one.about->say.rank - 100 : 0;
    };
    std::stable_sort(all.begin(), all.end(), [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
    return all;
}

namespace {

// Worth a figure: more than two values, and a spread that is not lost in the digits that a chart shows.
bool spreads(const std::vector<double>& values) {
    constexpr double kVisible = 1e-3;   // of the largest value
    constexpr double kRounding = 1e-6;  // in the units of metrics: m, s, deg, m/s2
    double low = kInfinity, high = -kInfinity;
    bool between = false;
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    for (const double value : values) between = between || (value > low && value < high);
    return between && high - low > std::max(kRounding, kVisible * std::max(std::abs(low), std::abs(high)));
}

bool varies(const std::vector<double>& values) {
    double first = kNan;
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        if (std::isnan(first)) first = value;
        if (value != first) return true;
    }
    return false;
}

}  // namespace

std::string where(const std::string& vehicle, const std::string& scenario) {
    std::string condition = "scenario = " + sqlText(scenario);
    if (!vehicle.empty()) condition += " AND vehicle = " + sqlText(vehicle);
    return condition;
}

std::vector<MetricHere> worthShowing(const DatabaseReader& data, const std::string& scenario,
                                     std::vector<MetricHere> metrics) {
    std::vector<std::pair<double, MetricHere>> kept;
    for (MetricHere& one : metrics) {
        const std::vector<double> values = data.numbers(one.column, where("", scenario));
        if (one.wanted ? !varies(values) : !spreads(values)) continue;
        double sum = 0, squares = 0, n = 0;
        for (const double value : values) {
            if (!std::isfinite(value)) continue;
            sum += value;
            squares += value * value;
            n += 1;
        }
        const double relative = sum != 0 ? squares * n / (sum * sum) : kInfinity;  // 1 + (sd / mean)^2
        const bool first = one.wanted || one.about->say.rank > 0;
        kept.emplace_back(first ? -kInfinity : -relative, std::move(one));
    }
    std::stable_sort(kept.begin(), kept.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    metrics.clear();
    for (auto& [order, one] : kept) metrics.push_back(std::move(one));
    return metrics;
}

// ---- Distributions ----

Chart histogram(const Plan& plan, const DatabaseReader& data, std::size_t scenario, const MetricHere& metric) {
    const std::string& name = plan.inputs.scenarios[scenario].name;
    Chart chart;
    chart.title = titleOf(metric);
    chart.x = {titleOf(metric), metric.shown.unit};
    chart.y = {"runs", "-", 0.0};
    std::vector<std::vector<double>> sets;
    double low = kInfinity, high = -kInfinity;
    std::size_t most = 0;
    for (std::size_t v = 0; v < std::min(kMostInAFigure, plan.inputs.vehicles.size()); ++v) {
        std::vector<double> values = data.numbers(metric.column, where(plan.inputs.vehicles[v].name, name));
        std::erase_if(values, [](double value) { return !std::isfinite(value); });
        for (double& value : values) {
            value *= metric.shown.scale;
            low = std::min(low, value);
            high = std::max(high, value);
        }
        most = std::max(most, values.size());
        sets.push_back(std::move(values));
    }
    if (!(low <= high)) return chart;
    // About the square root of the number of runs, as is usual for a histogram.
    const auto bars =
        std::clamp<std::size_t>(static_cast<std::size_t>(std::sqrt(static_cast<double>(most))), 5, kMostBars);
    const double width = high > low ? (high - low) / static_cast<double>(bars) : std::max(1e-9, std::abs(low) * 1e-3);
    double tallest = 0;
    for (std::size_t v = 0; v < sets.size(); ++v) {
        std::vector<double> heights(bars);
        for (const double value : sets[v])
            heights[std::min(bars - 1, static_cast<std::size_t>((value - low) / width))] += 1;
        Series series;
        series.name = plan.inputs.vehicles.size() > 1 ? plan.inputs.vehicles[v].name : "";
        for (std::size_t i = 0; i < bars; ++i) {
            const double left = low + width * static_cast<double>(i);
            if (i == 0) series.x.push_back(left), series.y.push_back(0);
            series.x.insert(series.x.end(), {left, left + width});
            series.y.insert(series.y.end(), {heights[i], heights[i]});
            tallest = std::max(tallest, heights[i]);
        }
        series.x.push_back(low + width * static_cast<double>(bars));
        series.y.push_back(0);
        chart.series.push_back(std::move(series));
    }
    if (metric.wanted) {
        bool named = false;
        for (const double limit : {metric.wanted->lowest, metric.wanted->highest}) {
            if (!std::isfinite(limit) || (named && metric.wanted->lowest == metric.wanted->highest)) continue;
            Series line;
            line.name = named ? "" : "wanted " + metric.condition;
            line.x = {limit * metric.shown.scale, limit * metric.shown.scale};
            line.y = {0, tallest};
            line.colour = Colour::vermillion;
            line.dashed = true;
            chart.series.push_back(std::move(line));
            named = true;
        }
    }
    return chart;
}

// ---- Effects of the factors ----

namespace {

struct FactorHere {
    std::string name;    // as shown
    std::string column;  // of the table; empty: the vehicle
    std::string unit;
    std::vector<double> values;
    std::vector<std::string> words;  // of a factor whose values are words, or of the vehicle: by value
    campaign::Values kind = campaign::Values::listed;
};

std::vector<double> indicesOf(const std::vector<std::string>& texts, std::vector<std::string>& words) {
    std::map<std::string, double> known;
    std::vector<double> values;
    for (const std::string& text : texts) {
        if (text.empty()) {
            values.push_back(kNan);
            continue;
        }
        const auto [place, is_new] = known.emplace(text, static_cast<double>(words.size()));
        if (is_new) words.push_back(text);
        values.push_back(place->second);
    }
    return values;
}

std::vector<FactorHere> factorsOf(const Plan& plan, const DatabaseReader& data, std::size_t scenario) {
    const std::string condition = where("", plan.inputs.scenarios[scenario].name);
    const std::vector<std::string> names = columnNames(plan);
    std::vector<FactorHere> all;
    if (plan.inputs.vehicles.size() > 1) {
        FactorHere vehicle{"vehicle", "", "-", {}, {}, campaign::Values::listed};
        vehicle.values = indicesOf(data.texts("vehicle", condition), vehicle.words);
        all.push_back(std::move(vehicle));
    }
    for (std::size_t i = 0; i < plan.variables.size(); ++i) {
        const Variable& variable = plan.variables[i];
        FactorHere here{variable.path + (variable.relative ? " (of nominal)" : ""),
                        names[campaign::kFixedColumns + i],
                        variable.unit,
                        {},
                        {}};
        here.kind = variable.drawn ? campaign::Values::drawn : campaign::Values::listed;
        if (variable.words) here.values = indicesOf(data.texts(here.column, condition), here.words);
        else here.values = data.numbers(here.column, condition);
        if (varies(here.values)) all.push_back(std::move(here));
    }
    return all;
}

std::string shareText(const Share& share) {
    if (!std::isfinite(share.value)) return "–";
    const auto rounded = [](double value) { return std::round(100 * value) / 100 + 0.0; };  // no "-0.00"
    if (!std::isfinite(share.low)) return fmt::format("{:.2f}", rounded(share.value));
    return fmt::format("{:.2f} [{:.2f}, {:.2f}]", rounded(share.value), rounded(share.low), rounded(share.high));
}

tread::Cell cellOf(const Share& share) {
    return {.text = shareText(share),
            .number = true,
            .heat = std::isfinite(share.value) ? 0.6 * std::clamp(share.value, 0.0, 1.0) : 0};
}

std::string axisUnit(const std::string& unit, double& scale) {
    const DisplayUnit shown = displayUnit(unit);
    scale = shown.scale;
    return shown.unit;
}

Chart scatter(const FactorHere& factor, const MetricHere& metric, const std::vector<double>& values) {
    double scale = 1;
    Chart chart;
    chart.title = titleOf(metric);
    chart.x = {factor.name, axisUnit(factor.unit, scale)};
    chart.y = {titleOf(metric), metric.shown.unit};
    Series points;
    points.line = false;
    points.markers = true;
    points.colour = Colour::sky;
    points.width = 1;
    const std::size_t step = std::max<std::size_t>(1, values.size() / kMostPoints);
    for (std::size_t i = 0; i < values.size(); i += step) {
        if (!std::isfinite(factor.values[i]) || !std::isfinite(values[i])) continue;
        points.x.push_back(factor.values[i] * scale);
        points.y.push_back(values[i] * metric.shown.scale);
    }
    chart.series.push_back(std::move(points));
    const campaign::ClassMeans means = campaign::classMeans(factor.values, values, factor.kind);
    Series mean;
    mean.name = "mean";
    for (const double x : means.factor) mean.x.push_back(x * scale);
    for (const double y : means.metric) mean.y.push_back(y * metric.shown.scale);
    mean.colour = Colour::vermillion;
    mean.markers = factor.words.empty() ? false : true;
    mean.line = factor.words.empty();
    chart.series.push_back(std::move(mean));
    for (std::size_t i = 0; i < factor.words.size(); ++i)
        chart.note += fmt::format("{}{}: {}", i > 0 ? ", " : "", i, factor.words[i]);
    return chart;
}

}  // namespace

void addEffects(HtmlPage& page, const Plan& plan, const DatabaseReader& data, std::size_t scenario,
                const std::vector<MetricHere>& metrics) {
    const std::vector<FactorHere> factors = factorsOf(plan, data, scenario);
    if (factors.empty() || metrics.empty()) return;
    const std::string condition = where("", plan.inputs.scenarios[scenario].name);
    std::vector<std::string> header{"Factor"};
    std::vector<std::vector<tread::Cell>> rows;
    for (const FactorHere& factor : factors) rows.push_back({{.text = factor.name}});
    std::vector<Chart> charts;
    for (const MetricHere& metric : metrics) {
        header.push_back(titleOf(metric));
        const std::vector<double> values = data.numbers(metric.column, condition);
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t i = 0; i < factors.size(); ++i) {
            const Share share = mainEffect(factors[i].values, values, factors[i].kind);
            rows[i].push_back(cellOf(share));
            order.emplace_back(std::isfinite(share.value) ? -share.value : 1, i);
        }
        std::stable_sort(order.begin(), order.end());
        for (std::size_t i = 0; i < std::min(kDrawnFactors, order.size()); ++i) {
            if (order[i].first < -0.02 && spreads(values))
                charts.push_back(scatter(factors[order[i].second], metric, values));
        }
    }
    if (plan.inputs.campaign.sampling != Sampling::sobol_indices) {
        page.text(
            "Main effects: the share of the variance of a metric that the mean over classes of a factor shows, with "
            "its "
            "95 % confidence interval. What is missing to 1 is interaction of factors, and curvature within classes.");
        page.table(header, rows);
    }
    page.figures(charts);
}

void addSobol(HtmlPage& page, const Plan& plan, const DatabaseReader& data, const campaign::Cell& cell,
              const std::vector<MetricHere>& metrics) {
    if (cell.drawn.empty()) return;
    const auto repetitions = static_cast<std::uint64_t>(plan.inputs.campaign.repetitions);
    const std::string condition =
        fmt::format("run >= {} AND run < {} AND repetition = 0", cell.first, cell.first + cell.samples * repetitions);
    std::vector<std::string> header{"Factor"};
    std::vector<std::vector<tread::Cell>> rows;
    for (const std::size_t i : cell.drawn) rows.push_back({{.text = plan.variables[i].path}});
    for (const MetricHere& metric : metrics) {
        header.push_back(titleOf(metric) + ", first");
        header.push_back("total");
        const auto indices = sobolIndices(data.numbers(metric.column, condition), cell.drawn.size());
        for (std::size_t i = 0; i < indices.size(); ++i) {
            rows[i].push_back(cellOf(indices[i].first));
            rows[i].push_back(cellOf(indices[i].total));
        }
    }
    page.text(fmt::format(
        "Sobol indices of {} in {}{}: the first-order index is the share of the variance that the factor "
        "causes alone, the total index with all its interactions; 95 % confidence intervals.",
        plan.vehicleOf(cell), plan.scenarioOf(cell), cell.points > 1 ? ", at the first of the listed values" : ""));
    page.table(header, rows);
}

}  // namespace tread::program
