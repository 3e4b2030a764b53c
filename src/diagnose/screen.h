// What each effect could explain, from the linearisation alone: before the data (can it be seen in these drives at all,
// and told from the others?) and with them.
#pragma once

#include <string>
#include <vector>

#include "diagnose/study.h"

namespace tread {

struct Screen {
    std::vector<double> detectability;  // nats to expect at typical size, per effect
    std::vector<double> gain;           // nats of linear evidence over none, per effect
    Eigen::MatrixXd products;           // of all knobs, then the residual; nuisances and disturbances projected out
};
Screen screen(const Study& study, const std::vector<DriveGram>& grams);

// Linear evidence that each effect would add to a fit that has some already, from the columns about `ground`.
std::vector<double> gainsOver(const Study& study, const Ground& ground, const Fit& fit);

// Largest cosine between two effects' signatures after the projection.
double cosine(const Study& study, const Eigen::MatrixXd& products, std::size_t a, std::size_t b);

// Pairs that these drives would leave confused if one of them were true, worst first.
std::vector<ConfusablePair> confusablePairs(const Study& study, const Screen& screen,
                                            const std::vector<DriveGram>& grams);

}  // namespace tread
