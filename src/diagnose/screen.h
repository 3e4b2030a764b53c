// What each effect could explain, from the linearisation alone: before the data (can it be seen in these drives at all,
// and told from the others?) and with them.
#pragma once

#include <array>
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

// Takes back what was promised of effects that act on one side of a limit only (controllers, play, stops), where the
// car as it is found does not pass that limit.
void lookAgain(Study& study, const Fit& found, Screen& screen);

// Places of an effect's knobs among all knobs.
std::vector<Eigen::Index> placesOf(const Study& study, std::size_t effect);

// Products of further columns of each drive, beside a fit: what the fit has free and disturbances of these sizes
// projected out. The last of them are the fit's residuals.
Eigen::MatrixXd productsBeside(const Study& study, const Fit& fit, const std::vector<Eigen::MatrixXd>& further,
                               const std::array<double, kDisturbances>& sizes);

// The same of all knobs and then the residual, from the columns about `ground`.
Eigen::MatrixXd productsOver(const Study& study, const Ground& ground, const Fit& fit,
                             const std::array<double, kDisturbances>& sizes);

// Linear evidence that each effect would add to a fit that has some already, from the columns about `ground`.
std::vector<double> gainsOver(const Study& study, const Ground& ground, const Fit& fit);

// Largest cosine between two effects' signatures after the projection.
double cosine(const Study& study, const Eigen::MatrixXd& products, std::size_t a, std::size_t b);

// Pairs that look alike and that these drives would leave confused if one of them were true, worst first.
std::vector<ConfusablePair> confusablePairs(const Study& study, const Screen& screen,
                                            const std::vector<DriveGram>& grams);

}  // namespace tread
