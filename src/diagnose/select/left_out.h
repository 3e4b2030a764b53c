// Does an effect of a set enlarge the gap of drives that it was not fitted to?
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "diagnose/select/held_out.h"
#include "diagnose/select/search.h"

namespace tread::diagnose::select {

// Sets of effects, with and without each of their effects, in each drive as the other drives predict it and in the
// drives held out. All are fitted within the tolerances, with a remainder of the usual size, so that their numbers
// close as much of the gap as they can; otherwise one of them might leave to its remainder what the other one explains.
class LeftOut {
public:
    LeftOut(const Calibration& car, const HeldOut& held_out);

    // True if these drives have a larger gap with one of the effects than without it (D38c). An effect that one drive
    // tells alone is not tested: without that drive it has no value.
    bool enlarges(const Candidate& set);

private:
    struct Fitted {
        std::optional<Fit> fit;
        // Of each drive as the others predict it, then of the drives held out. At most that of the nominal car: a
        // prediction that is worse predicts nothing.
        std::vector<double> gaps;
    };
    // Fitted from a point; effects that do not take part are taken out of it.
    const Fitted& fittedWith(const std::vector<std::size_t>& effects, const Deviation& from);

    const Calibration& car_;
    const HeldOut& held_out_;
    Replays within_;
    std::vector<double> nominal_;                     // gaps of the nominal car, in the same drives
    std::map<std::set<std::size_t>, Fitted> fitted_;  // by effects
};

// Whitened residual of each drive, if all numbers of a fit are those that the other drives tell, within the bounds of
// these parameters. In the linear model about the fit.
std::vector<Eigen::VectorXd> residualsLeftOut(model::Drives drives, const model::Uncertainty& uncertainty,
                                              const std::vector<Parameter>& parameters, const Fit& fit, int threads);

// True if gaps grow: their logarithms, summed over the drives, by more than the standard deviation that the differences
// between drives suggest. A drive that is predicted badly either way thus weighs no more than another one (D38c).
bool isLarger(const std::vector<double>& after, const std::vector<double>& before);

}  // namespace tread::diagnose::select
