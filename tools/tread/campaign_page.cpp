#include "campaign_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "base/text/number_text.h"
#include "campaign/database.h"
#include "campaign_begin.h"
#include "campaign_figures.h"
#include "report/html.h"
#include "report/text.h"

namespace tread::program {
namespace {

using campaign::DatabaseReader;
using campaign::Plan;
using campaign::Sampling;
using campaign::Status;
using campaign::Tally;
using campaign::Variable;

constexpr std::size_t kDrawnMetrics = 4;  // of a scenario: with a distribution, and in the table of effects
constexpr std::size_t kMostScenarios = 4, kMostVehicles = 6;  // with figures of their own
constexpr std::size_t kWorst = 10, kMostMessages = 20;

// ---- Worst runs and failures ----

struct Bad {
    double excess;  // beyond the condition, in standard deviations of the metric
    std::uint64_t run;
    std::string vehicle, scenario, metric, value, condition;
};

void collectWorst(std::vector<Bad>& all, const Plan& plan, const DatabaseReader& data, std::size_t scenario,
                  const std::vector<MetricHere>& metrics) {
    const std::string& name = plan.inputs.scenarios[scenario].name;
    const std::vector<double> runs = data.numbers("run", where("", name));
    const std::vector<std::string> vehicles = data.texts("vehicle", where("", name));
    for (const MetricHere& metric : metrics) {
        if (!metric.wanted) continue;
        const std::vector<double> values = data.numbers(metric.column, where("", name));
        double sum = 0, squares = 0, n = 0;
        for (const double value : values) {
            if (!std::isfinite(value)) continue;
            sum += value;
            squares += value * value;
            n += 1;
        }
        const double variance = n > 1 ? (squares - sum * sum / n) / (n - 1) : 0;
        const double sd = variance > 0 ? std::sqrt(variance) : 1;
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (!std::isfinite(values[i])) continue;
            const double excess = std::max(metric.wanted->lowest - values[i], values[i] - metric.wanted->highest) / sd;
            const std::string value = formatNumber(values[i] * metric.shown.scale, 4);
            all.push_back({excess, static_cast<std::uint64_t>(runs[i]), vehicles[i], name, titleOf(metric),
                           value + (metric.shown.unit == "-" ? "" : " " + prettyUnit(metric.shown.unit)),
                           metric.condition});
        }
        const auto worse = [](const Bad& a, const Bad& b) {
            return a.excess != b.excess ? a.excess > b.excess : a.run < b.run;
        };
        const std::size_t keep = std::min(kWorst, all.size());
        std::partial_sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(keep), all.end(), worse);
        all.resize(keep);
    }
}

void addWorst(HtmlPage& page, const std::vector<Bad>& all, const Path& folder) {
    if (all.empty()) return;
    page.section("Worst runs");
    page.text(
        "The runs farthest beyond, or nearest to, a condition. The command drives a run again, with log and page.");
    std::vector<std::vector<tread::Cell>> rows;
    for (const Bad& bad : all) {
        rows.push_back({{.text = std::to_string(bad.run), .number = true},
                        {.text = bad.vehicle},
                        {.text = bad.scenario},
                        {.text = bad.metric},
                        {.text = bad.value, .number = true, .alarm = bad.excess > 0},
                        {.text = bad.condition},
                        {.text = fmt::format("tread campaign {} --run {}", folder.string(), bad.run)}});
    }
    page.table({"Run", "Vehicle", "Scenario", "Metric", "Value", "Wanted", "Command"}, rows);
}

// The message with # for every number: runs that fail alike fail at different moments.
std::string alike(const std::string& message) {
    std::string out;
    for (const char c : message) {
        const bool part = (c >= '0' && c <= '9') || (c == '.' && !out.empty() && out.back() == '#');
        if (!part) out += c;
        else if (out.empty() || out.back() != '#') out += '#';
    }
    return out;
}

void addFailures(HtmlPage& page, const DatabaseReader& data, const Path& folder) {
    const std::string condition = "status NOT IN ('ok', 'rejected')";
    const std::vector<std::string> messages = data.texts("message", condition),
                                   states = data.texts("status", condition);
    if (messages.empty()) return;
    const std::vector<double> runs = data.numbers("run", condition);
    struct Kind {
        std::size_t count = 0;
        std::size_t first = 0;
    };
    std::map<std::string, Kind> kinds;
    for (std::size_t i = 0; i < messages.size(); ++i) {
        Kind& kind = kinds[states[i] + ": " + alike(messages[i])];
        if (kind.count++ == 0) kind.first = i;
    }
    std::vector<Kind> order;
    for (const auto& [text, kind] : kinds) order.push_back(kind);
    std::stable_sort(order.begin(), order.end(), [](const Kind& a, const Kind& b) { return a.count > b.count; });
    page.section("Failures");
    std::vector<std::vector<tread::Cell>> rows;
    for (std::size_t i = 0; i < std::min(kMostMessages, order.size()); ++i) {
        const Kind& kind = order[i];
        rows.push_back({{.text = std::to_string(kind.count), .number = true, .alarm = true},
                        {.text = states[kind.first]},
                        {.text = fmt::format("tread campaign {} --run {:.0f}", folder.string(), runs[kind.first])},
                        {.text = messages[kind.first]}});
    }
    page.table({"Runs", "Status", "First of them", "Message of the first"}, rows, true);
    if (order.size() > kMostMessages)
        page.text(fmt::format("{} more kinds of messages.", order.size() - kMostMessages));
}

}  // namespace

std::string campaignPage(const Plan& plan, const Path& folder, const Tally& tally) {
    const DatabaseReader data(folder / "results.sqlite");
    const campaign::CampaignFile& file = plan.inputs.campaign;
    HtmlPage page(file.title);
    const bool judged = std::any_of(plan.inputs.scenarios.begin(), plan.inputs.scenarios.end(),
                                    [](const auto& one) { return !one.scenario.accept.empty(); });
    const std::uint64_t ok = tally.count(Status::ok);
    const double percent = tally.runs > 0 ? 100.0 * static_cast<double>(ok) / static_cast<double>(tally.runs) : 0;
    page.answer(judged ? fmt::format("{} of {} accepted ({:.3g} %)", ok, counted(tally.runs, "run"), percent)
                       : fmt::format("{}, {} without failure", counted(tally.runs, "run"), tally.runs - tally.failed()),
                tally.missing > 0 ? "incomplete" : "", false);
    std::vector<Card> cards{{"runs", std::to_string(tally.runs), ""}};
    if (judged) cards.push_back({"not accepted", std::to_string(tally.count(Status::rejected)), ""});
    cards.push_back({"failed", std::to_string(tally.failed()), ""});
    if (tally.missing > 0) cards.push_back({"missing", std::to_string(tally.missing), ""});
    page.cards(cards);
    std::string vehicles, scenarios, factors;
    for (const auto& one : plan.inputs.vehicles) vehicles += (vehicles.empty() ? "" : ", ") + one.name;
    for (const auto& one : plan.inputs.scenarios) scenarios += (scenarios.empty() ? "" : ", ") + one.name;
    for (const Variable& variable : plan.variables) factors += (factors.empty() ? "" : ", ") + variable.path;
    page.keyValues(
        {{"What it is", file.description},
         {"Vehicles", vehicles},
         {"Scenarios", scenarios},
         {"Factors", factors},
         {"Sampling",
          plan.dimensions > 0
              ? fmt::format("{}, {}, seed {}", enumNames(file.sampling)[static_cast<std::size_t>(file.sampling)],
                            counted(static_cast<std::uint64_t>(file.samples), "sample"), file.seed)
              : ""},
         {"Table", "results.csv, results.sqlite"},
         {"Made by", "tread " + plan.inputs.tread_version}});
    std::vector<Bad> worst;
    for (std::size_t s = 0; s < std::min(kMostScenarios, plan.inputs.scenarios.size()); ++s) {
        const std::string& name = plan.inputs.scenarios[s].name;
        std::vector<MetricHere> metrics = metricsOf(plan, s);
        collectWorst(worst, plan, data, s, metrics);
        metrics = worthShowing(data, name, std::move(metrics));
        if (metrics.size() > kDrawnMetrics) metrics.resize(kDrawnMetrics);
        if (metrics.empty()) continue;
        page.section(plan.inputs.scenarios[s].scenario.title.empty() ? name : plan.inputs.scenarios[s].scenario.title);
        std::vector<Chart> charts;
        for (const MetricHere& metric : metrics) charts.push_back(histogram(plan, data, s, metric));
        page.figures(charts);
        if (file.sampling == Sampling::sobol_indices && tally.missing == 0) {
            std::size_t shown = 0;
            for (const campaign::Cell& cell : plan.cells) {
                if (cell.scenario == s && shown++ < kMostVehicles) addSobol(page, plan, data, cell, metrics);
            }
        }
        addEffects(page, plan, data, s, metrics);
    }
    addWorst(page, worst, folder);
    addFailures(page, data, folder);
    return page.finish();
}

std::string outcomeText(const Tally& tally) {
    std::string text = counted(tally.runs, "run");
    const auto add = [&](Status status, std::string_view words) {
        if (tally.count(status) > 0) text += fmt::format(", {} {}", tally.count(status), words);
    };
    add(Status::rejected, "not accepted");
    add(Status::failed, "failed");
    add(Status::invalid, "with invalid numbers");
    add(Status::no_metrics, "without metrics");
    return text;
}

std::string campaignAnswer(const Plan& plan, const Tally& found) {
    return fmt::format("{}: {}{}", plan.inputs.campaign.title, outcomeText(found),
                       found.missing == 0 ? "" : fmt::format(", {} missing", found.missing));
}

}  // namespace tread::program
