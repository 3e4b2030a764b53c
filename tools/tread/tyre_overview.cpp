#include "tyre_overview.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <numbers>

#include "report/text.h"
#include "tyre_figures.h"

namespace tread::program {
namespace {

constexpr double kPerDegree = std::numbers::pi / 180;

// Slip between 0 and `highest` at which `force` is largest.
template <class Force>
double slipOfPeak(double highest, Force force) {
    constexpr int kSteps = 2000;
    double best = 0;
    for (int i = 1; i <= kSteps; ++i) {
        const double slip = highest * i / kSteps;
        if (force(slip) > force(best)) best = slip;
    }
    return best;
}

}  // namespace

std::vector<TyreFact> tyreFacts(const TyreParams& tyre) {
    const TyreCoefficients& p = tyre.parameters;
    const auto at = [&](double kappa, double alpha) {
        return steadyState(tyre, {p.Fzo, 0, kCurveSpeed, -kappa * kCurveSpeed, -alpha * kCurveSpeed});
    };
    const TyreSteadyState free = at(0, 0);
    const double peak_kappa = slipOfPeak(1, [&](double kappa) { return at(kappa, 0).Fx0; });
    const double peak_alpha = slipOfPeak(1, [&](double alpha) { return at(0, alpha).Fy0; });
    return {{"nominal_load", "nominal load", p.Fzo, "N", "N"},
            {"unloaded_radius", "unloaded radius", p.Ro, "m", "mm", 1000},
            {"rolling_radius", "effective rolling radius", p.Re, "m", "mm", 1000},
            {"radial_stiffness", "radial stiffness", p.pz1 * tyre.lambda.Cz, "N/m", "N/mm", 1e-3},
            {"longitudinal_friction", "peak longitudinal friction", free.mux, "-", "-"},
            {"longitudinal_peak_slip", "slip at that peak", peak_kappa, "-", "%", 100},
            {"lateral_friction", "peak lateral friction", free.muy, "-", "-"},
            {"lateral_peak_slip_angle", "slip angle at that peak", std::atan(peak_alpha), "rad", "deg", 1 / kPerDegree},
            {"slip_stiffness", "slip stiffness", free.Kx, "N", "kN/%", 1e-5},
            {"cornering_stiffness", "cornering stiffness", free.Ky, "N/rad", "kN/deg", 1e-3 * kPerDegree},
            {"pneumatic_trail", "pneumatic trail at zero slip", free.t, "m", "mm", 1000},
            {"longitudinal_relaxation_length", "longitudinal relaxation length", free.Kx / p.cFx, "m", "m"},
            {"lateral_relaxation_length", "lateral relaxation length", free.Ky / p.cFy, "m", "m"}};
}

std::string tyreName(const TyreParams& tyre) {
    return tyre.name.empty() ? "(without name)" : tyre.name;
}

std::string overviewText(const TyreParams& tyre, const std::vector<TyreFact>& facts) {
    const auto shown = [](const TyreFact& fact) {
        const std::string unit = fact.shown_unit == "-" ? "" : fmt::format(" {}", fact.shown_unit);
        return formatNumber(fact.value * fact.scale, 4) + unit;
    };
    const auto fact = [&](std::string_view key) {
        for (const TyreFact& candidate : facts) {
            if (candidate.key == key) return shown(candidate);
        }
        return std::string();
    };
    std::string text = fmt::format(
        "Tyre {}: peak friction {} longitudinal and {} lateral, cornering stiffness {} at its nominal load of {}\n",
        tyreName(tyre), fact("longitudinal_friction"), fact("lateral_friction"), fact("cornering_stiffness"),
        fact("nominal_load"));
    for (const TyreFact& each : facts) {
        fmt::format_to(std::back_inserter(text), "  {:<30} {}\n", each.label, shown(each));
    }
    fmt::format_to(std::back_inserter(text), "  {:<30} {}\n", "measured on the side",
                   enumNames(tyre.side)[static_cast<std::size_t>(tyre.side)]);
    if (!tyre.notes.empty()) {
        fmt::format_to(std::back_inserter(text), "  {:<30} {}, given as warnings\n", "notes", tyre.notes.size());
    }
    return text;
}

}  // namespace tread::program
