// How much of the gap that one sees the effects of a set close.
#pragma once

#include <vector>

#include "diagnose/select/calibration.h"

namespace tread::diagnose::select {

// The closest cars with all effects of a set, and with all but one of them, in the order of the effects.
struct Closeness {
    Closest with;
    std::vector<Closest> without;
};

// `at`: a point near these cars, from which they are found.
Closeness closenessOf(const Calibration& car, const std::vector<std::size_t>& effects, const Deviation& at);

// The closest car with some effects, found from the point, less its other effects, and from the closest car without
// effects. The nearer one counts: where cars differ much there are several.
Closest closestWith(const Calibration& car, const std::vector<std::size_t>& effects, const Deviation& at);

// Squared gap of all drives beyond that of a perfect model.
double gapBeyondNoise(const Calibration& car, const Rows& rows);

// Standard deviation of the squared gap of a perfect model.
double scatterOfGap(const Calibration& car);

// True if one of the effects closes no more of the gap than an effect without meaning may by chance, in view of what
// the set leaves and of the errors of the others' signatures (D38d). Never where there is neither.
bool closesByChance(const Calibration& car, const Closeness& closeness);

// True if forces that act beside a set close no more of the gap than chance may. `with`: the closest car with the set.
// `changes`: of the rows by each force, per drive. The car stays the closest one in one linear step (D38e).
bool forcesCloseByChance(const Calibration& car, const std::vector<std::size_t>& effects, const Closest& with,
                         const std::vector<Eigen::MatrixXd>& changes);

}  // namespace tread::diagnose::select
