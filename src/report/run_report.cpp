#include "report/run_report.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text/changed.h"
#include "report/cross_plot.h"
#include "report/html.h"
#include "report/manoeuvre_figures.h"
#include "report/replay.h"
#include "report/shown_metric.h"
#include "report/text.h"
#include "report/verdict_table.h"

namespace tread {
namespace {

struct Line {
    std::string_view channel;
    std::string_view label;
};

struct TimeChartPlan {
    std::string_view title;
    std::string_view unit;  // wanted on the chart
    std::vector<Line> lines;
};

struct WheelChartPlan {
    std::string_view title;
    std::string_view quantity;  // last part of the channel's name
    std::string_view unit;
};

const std::vector<TimeChartPlan>& inputPlans() {
    static const std::vector<TimeChartPlan> kPlans = {
        {"Steering-wheel angle", "deg", {{"driver.steering_wheel_angle", "steering wheel"}}},
        {"Pedals", "%", {{"driver.throttle", "throttle"}, {"driver.brake", "brake"}}}};
    return kPlans;
}

const std::vector<TimeChartPlan>& chassisPlans() {
    static const std::vector<TimeChartPlan> kPlans = {
        {"Speed", "km/h", {{"chassis.vx", "forward"}}},
        {"Yaw rate", "deg/s", {{"chassis.yaw_rate", "yaw rate"}}},
        {"Acceleration", "m/s2", {{"chassis.ay", "lateral"}, {"chassis.ax", "longitudinal"}}},
        {"Vertical acceleration", "m/s2", {{"chassis.az", "vertical"}}},
        {"Sideslip", "deg", {{"chassis.sideslip", "sideslip"}}},
        {"Roll and pitch", "deg", {{"chassis.roll", "roll"}, {"chassis.pitch", "pitch"}}}};
    return kPlans;
}

const std::vector<TimeChartPlan>& drivelinePlans() {
    static const std::vector<TimeChartPlan> kPlans = {
        {"Engine speed", "rev/min", {{"driveline.engine_speed", "engine"}}},
        {"Gear", "-", {{"driveline.gear", "gear"}}}};
    return kPlans;
}

constexpr std::array<WheelChartPlan, 10> kWheelPlans = {{{"Wheel load", "load", "N"},
                                                         {"Slip angle", "slip_angle", "deg"},
                                                         {"Lateral force Fy", "fy", "N"},
                                                         {"Longitudinal force Fx", "fx", "N"},
                                                         {"Slip ratio", "slip_ratio", "%"},
                                                         {"Aligning moment Mz", "mz", "N m"},
                                                         {"Wheel speed", "spin", "rev/min"},
                                                         {"Suspension travel", "travel", "mm"},
                                                         {"Road-wheel steer", "steer", "deg"},
                                                         {"Camber", "camber", "deg"}}};

// Adds a curve when the log has the channel in the unit of the chart.
void addCurve(TimeChart& chart, const Log& log, const std::string& channel_name, std::string_view wanted_unit,
              TimeChart::Curve curve) {
    const Channel* channel = completeChannel(log, channel_name);
    if (!channel) return;
    const DisplayUnit shown = displayUnitAs(channel->unit, wanted_unit);
    if (chart.curves.empty()) chart.unit = shown.unit;
    if (shown.unit != chart.unit) return;
    curve.values = channel->values;
    curve.scale = shown.scale;
    chart.curves.push_back(std::move(curve));
}

std::vector<TimeChart> plannedCharts(const Log& log, const std::vector<TimeChartPlan>& plans) {
    std::vector<TimeChart> charts;
    for (const TimeChartPlan& plan : plans) {
        TimeChart chart{
            .title = std::string(plan.title), .unit = {}, .time = log.channels.front().values, .curves = {}};
        for (const Line& line : plan.lines) {
            addCurve(chart, log, std::string(line.channel), plan.unit, {.name = std::string(line.label), .values = {}});
        }
        if (!chart.curves.empty()) charts.push_back(std::move(chart));
    }
    return charts;
}

std::vector<TimeChart> wheelCharts(const Log& log) {
    std::vector<TimeChart> charts;
    for (const WheelChartPlan& plan : kWheelPlans) {
        TimeChart chart{
            .title = std::string(plan.title), .unit = {}, .time = log.channels.front().values, .curves = {}};
        for (const WheelLook& wheel : kWheelLooks) {
            const std::string name = "wheel." + std::string(wheel.key) + "." + std::string(plan.quantity);
            addCurve(chart, log, name, plan.unit,
                     {.name = std::string(wheel.label), .values = {}, .colour = wheel.colour, .dashed = wheel.dashed});
        }
        if (!chart.curves.empty()) charts.push_back(std::move(chart));
    }
    return charts;
}

void addSection(HtmlPage& page, std::string_view title, const std::vector<TimeChart>& charts) {
    if (charts.empty()) return;
    page.section(title);
    page.timeCharts(charts);
}

void addCards(HtmlPage& page, const std::vector<Metric>& metrics) {
    constexpr std::size_t kMost = 6;
    std::vector<Card> cards;
    for (const Metric& metric : resultsFirst(metrics)) {
        if (cards.size() == kMost) break;
        cards.push_back({titleOf(metric), shownValue(metric, 3), prettyUnit(displayUnit(metric).unit)});
    }
    page.cards(cards);
}

void addMetrics(HtmlPage& page, const std::vector<Metric>& metrics) {
    if (metrics.empty()) return;
    page.section("Metrics");
    std::vector<std::vector<Cell>> rows;
    for (const Metric& metric : metrics) {
        const DisplayUnit shown = displayUnit(metric);
        rows.push_back({{.text = titleOf(metric), .note = metric.title.empty() ? "" : metric.name},
                        {formatNumber(metric.value * shown.scale, 5), true},
                        {prettyUnit(shown.unit)},
                        {metric.definition}});
    }
    page.table({"Metric", "Value", "Unit", "Definition"}, rows, true);
}

void addReplay(HtmlPage& page, const RunReport& content) {
    const Scenario scenario = content.record ? content.record->scenario : Scenario{};
    std::string data = replayData({{content.vehicle, content.log, shapeOf(content)}}, sceneOf(scenario));
    if (data.empty()) return;
    page.section("Replay");
    page.replay(std::move(data));
}

void addFigures(HtmlPage& page, const RunReport& content) {
    const std::vector<Chart> figures = manoeuvreFigures(content);
    if (figures.empty()) return;
    page.section("What the test shows");
    page.figures(figures);
}

}  // namespace

CarShape shapeOf(const RunReport& content) {
    if (!content.record) return typicalCarShape();
    return carShape(content.record->vehicle, content.record->scenario.course.car);
}

std::string runReport(const RunReport& content) {
    HtmlPage page(content.title);
    answerWithVerdict(page, content.answer, content.verdicts);
    page.warnings(content.warnings);
    addCards(page, content.metrics);
    const ChangedName car = splitChanged(content.vehicle);
    page.keyValues({{"Vehicle", car.name},
                    {"Changed settings", car.changes},
                    {"Manoeuvre", splitChanged(content.scenario).name},
                    {"Description", content.scenario_description},
                    {"Made by", "tread " + content.version}});
    page.links("Files", content.files);

    addVerdicts(page, content.verdicts);
    if (content.log.samples() > 0) {
        addFigures(page, content);
        addReplay(page, content);
    }
    addMetrics(page, content.metrics);
    if (content.log.samples() > 0) {
        addSection(page, "Driver", plannedCharts(content.log, inputPlans()));
        addSection(page, "Chassis", plannedCharts(content.log, chassisPlans()));
        addSection(page, "Wheels and tyres", wheelCharts(content.log));
        addSection(page, "Driveline", plannedCharts(content.log, drivelinePlans()));
    }
    if (!content.resolved_yaml.empty()) {
        page.section("Inputs");
        page.text("Every input of this run, defaults included. Saved to a file, it repeats the run.");
        page.collapsible("Resolved vehicle and scenario (YAML)", content.resolved_yaml);
    }
    return page.finish();
}

}  // namespace tread
