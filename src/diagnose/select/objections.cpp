#include "diagnose/select/objections.h"

#include <algorithm>
#include <cmath>

#include "diagnose/select/prediction.h"

namespace tread::diagnose::select {
namespace {

// True when the drive that tells most of one of the effects contradicts the others (D38a).
bool contradicted(const Calibration& car, const Candidate& model, const Search& found) {
    return std::any_of(found.candidates.begin(), found.candidates.end(), [&](const Candidate& less) {
        return less.fitted && less.lacksOneOf(model) && predicted(car, model.fit, less.fit).contradicts();
    });
}

}  // namespace

bool implausible(const Calibration& car, const Fit& fit) {
    constexpr double kUsual = 2;   // typical sizes
    constexpr double kBeyond = 2;  // standard deviations
    const inference::QuadraticModel here = quadraticAt(fit, car.uncertainty);
    const Eigen::VectorXd slope = here.gradient - here.at;  // of the log posterior
    for (Eigen::Index i = std::ssize(fit.free) - std::ssize(fit.knobs); i < std::ssize(fit.free); ++i) {
        const Parameter& knob = car.problem.replays.parameters[fit.free[i]];
        const double units = fit.at(fit.free[i]);
        // A knob at 0 has found nothing, which is no reason against the others.
        if (units == 0 || !knob.implausibleAt(units)) continue;
        if (std::abs(units) > kUsual) return true;
        const double outwards = knob.highest - units < units - knob.lowest ? slope(i) : -slope(i);
        if (outwards * std::sqrt(fit.covariance(i, i)) > kBeyond) return true;
    }
    return false;
}

std::string objectionInTheFit(const Calibration& car, const Candidate& model, const Search& found,
                              const HeldOut& held_out, double variance_factor) {
    const Fit& none = found.none().fit;
    if (model.effects.empty()) return {};
    if (implausible(car, model.fit)) return kAtItsEnd;
    if (predicted(car, model.fit, none).fails()) return "it does not predict drives that are left out of the fit";
    if (contradicted(car, model, found)) return "one drive supports it and the others contradict it";
    if (held_out.speakAgainst(model.fit, none.at, variance_factor))
        return "it does not reduce the gap of the held-out drives";
    return {};
}

std::string objectionInTheGap(const Calibration& car, const Candidate& model, const Closeness& closeness,
                              LeftOut& left_out) {
    if (model.effects.empty()) return {};
    if (closesByChance(car, closeness)) return kClosesByChance;
    if (left_out.enlarges(model)) return "it enlarges the gap of drives that it is not fitted to";
    return {};
}

}  // namespace tread::diagnose::select
