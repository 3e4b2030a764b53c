#include "report/manoeuvre_figures.h"

#include <functional>
#include <optional>
#include <string_view>

#include "report/braking_figures.h"
#include "report/course_figure.h"
#include "report/cross_plot.h"
#include "report/frequency_figures.h"
#include "report/handling_figures.h"
#include "report/ride_figures.h"
#include "report/run_figures.h"

namespace tread {
namespace {

using Figures = std::function<std::vector<Chart>(const RunReport&)>;

std::vector<Chart> listed(std::optional<Chart> chart) {
    if (!chart) return {};
    return {*std::move(chart)};
}

// ---- Figures that a row may name ----

Figures over(const char* title, const PlotAxis& x, const PlotAxis& y) {
    return [=](const RunReport& run) { return listed(crossPlot(run.log, title, x, y)); };
}
std::vector<Chart> path(const RunReport& run) {
    return listed(pathFigure(run.log, shapeOf(run)));
}
std::vector<Chart> steering(const RunReport& run) {
    return listed(steeringFigure(run.log));
}
std::vector<Chart> friction(const RunReport& run) {
    return listed(frictionFigure(run.log));
}
std::vector<Chart> wheelFriction(const RunReport& run) {
    return wheelFrictionFigures(run.log);
}
std::vector<Chart> gg(const RunReport& run) {
    return listed(accelerationFigure(run.log));
}
std::vector<Chart> understeer(const RunReport& run) {
    return listed(understeerFigure(run));
}
std::vector<Chart> step(const RunReport& run) {
    return listed(stepFigure(run));
}
std::vector<Chart> dwell(const RunReport& run) {
    return dwellFigures(run.log);
}
std::vector<Chart> bode(const RunReport& run) {
    return frequencyFigures(run.log);
}
std::vector<Chart> braking(const RunReport& run) {
    return brakingFigures(run);
}
std::vector<Chart> ride(const RunReport& run) {
    return rideFigures(run.log);
}
std::vector<Chart> bump(const RunReport& run) {
    return bumpFigures(run.log);
}
std::vector<Chart> course(const RunReport& run) {
    return listed(courseFigure(run));
}

// ---- The table ----

struct Row {
    std::string_view manoeuvre;
    std::vector<Figures> figures;
};

const std::vector<Row>& table() {
    static const Figures roll = over("Roll", kLateral, kRoll), sideslip = over("Sideslip", kLateral, kSideslip);
    static const std::vector<Figures> loops{over("Lateral acceleration", kSteeringWheel, kLateral),
                                            over("Yaw rate", kSteeringWheel, kYawRate),
                                            over("Steering-wheel torque", kSteeringWheel, kSteeringWheelTorque),
                                            over("Steering-wheel torque", kLateral, kSteeringWheelTorque)};
    static const std::vector<Row> kRows = {
        {"step_steer", {step, path}},
        {"fishhook", {over("Yaw rate and sideslip", kSideslip, kYawRate), roll, path}},
        {"j_turn", {over("Yaw rate and sideslip", kSideslip, kYawRate), roll, path}},
        {"slowly_increasing_steer", {understeer, roll, sideslip, path}},
        {"steady_circle", {understeer, roll, sideslip, path}},
        {"frequency_response", {bode}},
        {"sine_steer", {over("Yaw rate", kSteeringWheel, kYawRate), steering, path}},
        {"sine_with_dwell", {dwell, over("Yaw rate and sideslip", kSideslip, kYawRate), path}},
        {"straight_braking", {braking, friction}},
        {"split_mu_braking", {braking, path, wheelFriction}},
        {"braking_in_turn", {path, gg, braking, wheelFriction}},
        {"power_off", {path, gg, wheelFriction}},
        {"acceleration", {over("Acceleration", kForwardSpeed, kLongitudinal), friction}},
        {"coast_down", {over("Deceleration", kForwardSpeed, kLongitudinal)}},
        {"weave", loops},
        {"transition", loops},
        {"free_steer", {over("Yaw rate", kSteeringWheel, kYawRate), path}},
        {"course",
         {course, over("Distance from the path", kCourseDistance, kCrossTrack),
          over("Speed", kCourseDistance, kForwardSpeed), gg, friction}},
        {"lane_change", {course, gg, over("Yaw rate", kSteeringWheel, kYawRate), friction}},
        {"parked", {}},
        {"hill_start", {}},
        {"drop_and_settle", {}},
        {"ride", {ride}},
        {"bump", {bump}},
        {"straight_running", {path}},
    };
    return kRows;
}

const std::vector<Figures>& figuresFor(std::string_view manoeuvre) {
    static const std::vector<Figures> kOthers{path, steering, friction};
    for (const Row& row : table()) {
        if (row.manoeuvre == manoeuvre) return row.figures;
    }
    return kOthers;
}

}  // namespace

std::vector<Chart> manoeuvreFigures(const RunReport& content) {
    std::vector<Chart> charts;
    const bool on_path = content.record && lanes(content.record->scenario.course).empty() &&
                         content.record->scenario.manoeuvre != "course";
    if (on_path) charts = course(content);  // beside the figures of another manoeuvre
    for (const Figures& figures : figuresFor(content.record ? content.record->scenario.manoeuvre : "")) {
        for (Chart& chart : figures(content)) charts.push_back(std::move(chart));
    }
    return charts;
}

}  // namespace tread
