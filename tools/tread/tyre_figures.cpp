#include "tyre_figures.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "report/text.h"

namespace tread::program {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kPercent = 0.01;
constexpr double kWidestSlip = 50;                              // %
constexpr double kWidestAngle = 15;                             // deg
constexpr double kWidestCamber = 6;                             // deg
constexpr int kPoints = 401;                                    // per curve
constexpr std::array kLoadShares = {0.25, 0.5, 1.0, 1.5, 2.0};  // shares of the nominal load

// A point of operation in the units of the figures. The slip angle has the same value in both axis systems.
struct Point {
    double load;        // N
    double slip = 0;    // %
    double angle = 0;   // deg
    double camber = 0;  // deg
};

TyreSteadyState at(const TyreView& view, const Point& point) {
    return steadyState(view.tyre, {.Fz = point.load,
                                   .gamma = point.camber * kDegree,
                                   .Vx = kCurveSpeed,
                                   .Vsx = -point.slip * kPercent * kCurveSpeed,
                                   .Vsy = -std::tan(point.angle * kDegree) * kCurveSpeed});
}

// Forces, kN, in the axes of the view.
double longitudinal(const TyreView& view, const Point& point) {
    return view.sign("Fx") * at(view, point).Fx / 1000;
}
double lateral(const TyreView& view, const Point& point) {
    return view.sign("Fy") * at(view, point).Fy / 1000;
}
double aligning(const TyreView& view, const Point& point) {
    return view.sign("Mz") * at(view, point).Mz;
}

double nominalLoad(const TyreView& view) {
    return view.tyre.parameters.Fzo;
}

std::string loadName(double load) {
    return formatNumber(load / 1000, 3) + " kN";
}

// A curve from `low` to `high`.
template <class Function>
Series curve(std::string name, double low, double high, Function function) {
    Series series{.name = std::move(name), .x = {}, .y = {}};
    for (int i = 0; i < kPoints; ++i) {
        series.x.push_back(low + (high - low) * i / (kPoints - 1));
        series.y.push_back(function(series.x.back()));
    }
    return series;
}

// A chart with one curve per load.
template <class Function>
Chart overLoads(const TyreView& view, std::string title, ChartAxis x, ChartAxis y, double widest, Function function) {
    Chart chart{.title = std::move(title), .x = std::move(x), .y = std::move(y), .series = {}};
    for (const double share : kLoadShares) {
        const double load = share * nominalLoad(view);
        chart.series.push_back(curve(loadName(load), -widest, widest, [&](double x_) { return function(load, x_); }));
    }
    return chart;
}

ChartAxis slipAxis() {
    return {"longitudinal slip κ", "%"};
}
ChartAxis angleAxis() {
    return {"slip angle α", "deg"};
}
ChartAxis forceAxis(std::string label) {
    return {std::move(label), "kN"};
}

// Lateral over longitudinal force, with one slip held and the other swept.
Series ellipse(const TyreView& view, const std::vector<Point>& points) {
    Series series{.name = {}, .x = {}, .y = {}};
    for (const Point& point : points) {
        series.x.push_back(longitudinal(view, point));
        series.y.push_back(lateral(view, point));
    }
    return series;
}

Chart frictionEllipse(const TyreView& view) {
    Chart chart{
        .title = "Friction ellipse at constant slip angle", .x = forceAxis("Fx"), .y = forceAxis("Fy"), .series = {}};
    chart.equal_aspect = true;
    chart.height = 480;
    chart.note = "Each line: slip swept from locked (-100 %) to spinning (+100 %) at one slip angle.";
    constexpr std::array colours = {Colour::blue, Colour::vermillion, Colour::green, Colour::purple, Colour::amber};
    constexpr std::array angles = {1.0, 2.0, 4.0, 8.0, 15.0};  // deg
    for (std::size_t i = 0; i < angles.size(); ++i) {
        for (const double side : {1.0, -1.0}) {
            std::vector<Point> sweep;
            for (double x = -1; x <= 1.0005; x += 0.005) {
                sweep.push_back({nominalLoad(view), 100 * x * x * x, side * angles[i]});  // denser near zero slip
            }
            Series series = ellipse(view, sweep);
            if (side > 0) series.name = fmt::format("±{:g} deg", angles[i]);
            series.colour = colours[i];
            chart.series.push_back(std::move(series));
        }
    }
    return chart;
}

}  // namespace

std::vector<Chart> pureSlipFigures(const TyreView& view) {
    return {overLoads(view, "Longitudinal force at pure slip", slipAxis(), forceAxis("Fx"), kWidestSlip,
                      [&](double load, double slip) {
                          return longitudinal(view, {load, slip});
                      }),
            overLoads(view, "Lateral force at pure slip", angleAxis(), forceAxis("Fy"), kWidestAngle,
                      [&](double load, double angle) {
                          return lateral(view, {load, 0, angle});
                      })};
}

std::vector<Chart> combinedSlipFigures(const TyreView& view) {
    const double load = nominalLoad(view);
    Chart braking{
        .title = "Longitudinal force at constant slip angle", .x = slipAxis(), .y = forceAxis("Fx"), .series = {}};
    for (const double angle : {0.0, 2.0, 4.0, 8.0, 12.0}) {
        braking.series.push_back(curve(fmt::format("{:g} deg", angle), -kWidestSlip, kWidestSlip, [&](double slip) {
            return longitudinal(view, {load, slip, angle});
        }));
    }
    Chart cornering{.title = "Lateral force at constant slip", .x = angleAxis(), .y = forceAxis("Fy"), .series = {}};
    for (const double slip : {0.0, -5.0, -10.0, -20.0, -40.0}) {
        cornering.series.push_back(curve(fmt::format("{:g} %", slip), -kWidestAngle, kWidestAngle, [&](double angle) {
            return lateral(view, {load, slip, angle});
        }));
    }
    return {braking, cornering, frictionEllipse(view)};
}

std::vector<Chart> aligningTorqueFigures(const TyreView& view) {
    const double load = nominalLoad(view);
    Chart braking{.title = "Aligning torque at constant slip", .x = angleAxis(), .y = {"Mz", "N m"}, .series = {}};
    for (const double slip : {0.0, -2.0, -5.0, -10.0, -20.0}) {
        braking.series.push_back(curve(fmt::format("{:g} %", slip), -kWidestAngle, kWidestAngle, [&](double angle) {
            return aligning(view, {load, slip, angle});
        }));
    }
    return {overLoads(view, "Aligning torque at pure slip", angleAxis(), {"Mz", "N m"}, kWidestAngle,
                      [&](double fz, double angle) {
                          return aligning(view, {fz, 0, angle});
                      }),
            overLoads(view, "Pneumatic trail at pure slip", angleAxis(), {"trail t", "mm"}, kWidestAngle,
                      [&](double fz, double angle) {
                          return 1000 * at(view, {fz, 0, angle}).t;
                      }),
            braking};
}

std::vector<Chart> loadFigures(const TyreView& view) {
    const double most = 2.5 * nominalLoad(view) / 1000;
    const ChartAxis load_axis{"load Fz", "kN", 0, most};
    const auto overLoad = [&](std::string name, auto value) {
        return curve(std::move(name), 0, most, [&](double load) { return value(at(view, {1000 * load})); });
    };
    Chart cornering{.title = "Cornering stiffness", .x = load_axis, .y = {"Ky", "kN/deg", 0}, .series = {}};
    cornering.series = {overLoad("", [](const TyreSteadyState& s) { return s.Ky * kDegree / 1000; })};
    Chart slip{.title = "Slip stiffness", .x = load_axis, .y = {"Kx", "kN/%", 0}, .series = {}};
    slip.series = {overLoad("", [](const TyreSteadyState& s) { return s.Kx * kPercent / 1000; })};
    Chart friction{.title = "Peak friction", .x = load_axis, .y = {"μ", "-", 0}, .series = {}};
    friction.series = {overLoad("longitudinal, μx", [](const TyreSteadyState& s) { return s.mux; }),
                       overLoad("lateral, μy", [](const TyreSteadyState& s) { return s.muy; })};
    return {cornering, slip, friction};
}

std::vector<Chart> camberFigures(const TyreView& view) {
    const double load = nominalLoad(view);
    Chart force{.title = "Lateral force at constant camber", .x = angleAxis(), .y = forceAxis("Fy"), .series = {}};
    Chart torque{.title = "Aligning torque at constant camber", .x = angleAxis(), .y = {"Mz", "N m"}, .series = {}};
    for (const double camber : {-kWidestCamber, -kWidestCamber / 2, 0.0, kWidestCamber / 2, kWidestCamber}) {
        const std::string name = fmt::format("{:g} deg", camber);
        const auto point = [&](double angle) { return Point{load, 0, angle, camber}; };
        force.series.push_back(curve(name, -kWidestAngle / 2, kWidestAngle / 2,
                                     [&](double angle) { return lateral(view, point(angle)); }));
        torque.series.push_back(curve(name, -kWidestAngle / 2, kWidestAngle / 2,
                                      [&](double angle) { return aligning(view, point(angle)); }));
    }
    return {force, torque,
            overLoads(view, "Camber force at zero slip angle", {"camber γ", "deg"}, forceAxis("Fy"), kWidestCamber,
                      [&](double fz, double camber) {
                          return lateral(view, {fz, 0, 0, camber});
                      })};
}

}  // namespace tread::program
