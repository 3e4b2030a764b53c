// Step responses of the contact patch, and the page with all curves.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "report/html.h"
#include "report/text.h"
#include "tyre_figures.h"
#include "tyre_overview.h"

namespace tread::program {
namespace {

constexpr std::array kSpeeds = {20.0, 40.0, 80.0, 160.0};  // km/h
constexpr double kStepAngle = 1;                           // deg
constexpr double kStepSlip = 1;                            // %
constexpr double kTimeStep = 0.5e-3;                       // s
constexpr double kShownLengths = 5;                        // relaxation lengths shown, travelled by the slowest wheel
constexpr double kSettledLengths = 20;  // relaxation lengths before the step, for the wheel to reach equilibrium

TyreMotion rolling(const TyreView& view, double speed, double kappa, double alpha) {
    const TyreCoefficients& p = view.tyre.parameters;
    return {
        .Vsx = -kappa * speed, .Vsy = -alpha * speed, .Vx = speed, .Omega = (1 + kappa) * speed / p.Re, .Fz = p.Fzo};
}

struct Response {
    std::vector<double> time;  // s after the step
    std::vector<TyreForces> forces;
};

// Response of a wheel that rolls straight ahead and then gets a step of slip.
Response respond(const TyreView& view, double speed, double kappa, double alpha, double length, double duration) {
    TyreState state;
    const TyreMotion before = rolling(view, speed, 0, 0), after = rolling(view, speed, kappa, alpha);
    const auto take = [&](const TyreMotion& motion) {
        return advance(state, view.tyre, motion, motion, kTimeStep, Standstill::paper);
    };
    const auto steps = [](double time) { return static_cast<int>(std::ceil(time / kTimeStep)); };
    TyreForces forces;
    for (int i = steps(kSettledLengths * length / speed); i >= 0; --i) forces = take(before);

    Response response{{0}, {forces}};
    for (int i = 1; i <= steps(duration); ++i) {
        response.time.push_back(i * kTimeStep);
        response.forces.push_back(take(after));
    }
    return response;
}

}  // namespace

std::vector<Chart> stepResponseFigures(const TyreView& view) {
    // The sign gives a force to the positive side in either axis system.
    const double angle = view.sign("Fy") * kStepAngle;
    const double alpha = std::tan(angle * std::numbers::pi / 180), kappa = kStepSlip / 100;
    const TyreCoefficients& p = view.tyre.parameters;
    const TyreSteadyState steady = steadyState(view.tyre, {.Fz = p.Fzo, .Vx = 20});
    const double slowest = kSpeeds[0] / 3.6;

    Chart across{.title = fmt::format("Fy after a step of slip angle to {:g} deg", angle),
                 .x = {"time", "ms", 0},
                 .y = {"Fy", "kN"},
                 .series = {}};
    Chart distance{
        .title = "The same over the distance rolled", .x = {"distance", "m", 0}, .y = {"Fy", "kN"}, .series = {}};
    Chart along{.title = fmt::format("Fx after a step of slip to {:g} %", kStepSlip),
                .x = {"time", "ms", 0},
                .y = {"Fx", "kN"},
                .series = {}};
    const double length_y = steady.Ky / p.cFy, length_x = steady.Kx / p.cFx;
    for (const double kmh : kSpeeds) {
        const double speed = kmh / 3.6;
        const std::string name = fmt::format("{:g} km/h", kmh);
        const auto add = [&](Chart& chart, const Response& response, double scale, double sign,
                             double TyreForces::*force) {
            Series series{.name = name, .x = {}, .y = {}};
            for (const double time : response.time) series.x.push_back(time * scale);
            for (const TyreForces& forces : response.forces) series.y.push_back(sign * forces.*force / 1000);
            chart.series.push_back(std::move(series));
        };
        const Response lateral = respond(view, speed, 0, alpha, length_y, kShownLengths * length_y / slowest);
        add(across, lateral, 1000, view.sign("Fy"), &TyreForces::Fy);
        add(distance, lateral, speed, view.sign("Fy"), &TyreForces::Fy);
        add(along, respond(view, speed, kappa, 0, length_x, kShownLengths * length_x / slowest), 1000, view.sign("Fx"),
            &TyreForces::Fx);
    }
    distance.x.highest = kShownLengths * length_y;
    return {across, distance, along};
}

std::string tyrePage(const TyreView& view, std::size_t& charts) {
    const TyreParams& tyre = view.tyre;
    HtmlPage page(fmt::format("Tyre {}", tyreName(tyre)));
    page.answer(
        view.axes == Axes::iso
            ? "Delft Tyre 97 in ISO 8855 axes: x forward, y left, z up; a positive slip angle gives a force to "
              "the right, Fy < 0."
            : "Delft Tyre 97 in the axes of its paper: x forward, y right, z down; a positive slip angle gives a "
              "force to the right, Fy > 0.");
    page.warnings(tyre.notes);
    std::vector<Card> cards;
    for (const TyreFact& fact : tyreFacts(tyre)) {
        cards.push_back(
            {std::string(fact.label), formatNumber(fact.value * fact.scale, 4), prettyUnit(fact.shown_unit)});
    }
    page.cards(cards);

    const std::string load = formatNumber(tyre.parameters.Fzo / 1000, 3) + " kN";
    charts = 0;
    const auto section = [&](const char* title, const std::string& text, const std::vector<Chart>& figures) {
        page.section(title);
        page.text(text);
        page.figures(figures);
        charts += figures.size();
    };
    section("Pure slip", "Braking or cornering alone, for several loads.", pureSlipFigures(view));
    section("Combined slip", "Braking, driving and cornering at once, at the nominal load of " + load + ".",
            combinedSlipFigures(view));
    section("Aligning torque", "For several loads; while braking, at the nominal load of " + load + ".",
            aligningTorqueFigures(view));
    section("Influence of load", "Stiffnesses at zero slip, and the peak of each force over the load.",
            loadFigures(view));
    section("Influence of camber",
            "A positive camber leans the top of the wheel to the right. Load " + load + " unless stated otherwise.",
            camberFigures(view));
    section("Step responses",
            "Of the contact-patch mass on its carcass, at the nominal load of " + load +
                ": the force builds up over the distance rolled.",
            stepResponseFigures(view));
    return page.finish();
}

}  // namespace tread::program
