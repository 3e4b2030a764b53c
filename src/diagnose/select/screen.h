// What each effect could explain, from the linearisation alone: before the data (can it be seen in these drives at all,
// and told from the others?) and with them.
#pragma once

#include <string>
#include <vector>

#include "diagnose/answer/diagnosis.h"
#include "diagnose/select/calibration.h"

namespace tread::diagnose::select {

struct Screen {
    std::vector<double> expected_evidence;  // nats at typical size, per effect
    std::vector<double> gain;               // nats of linear evidence over none, per effect
    Eigen::MatrixXd products;               // of all knobs, then the residual; nuisances and disturbances marginalised
};
// Expected evidence (D43), linear gains (D25) and products about the calibrated car.
Screen screen(const Calibration& car);

// The expected evidence without what was promised of effects that act on one side of a limit only (controllers, play,
// stops), where the car as it is found does not pass that limit.
std::vector<double> expectedEvidenceAt(const Calibration& car, const Fit& found, const Screen& screen);

// Places of an effect's knobs among all knobs.
std::vector<Eigen::Index> placesOf(const Problem& problem, std::size_t effect);

// Products of further columns of each drive, beside a fit: what the fit has free and disturbances of these sizes are
// marginalised. The last of them are the fit's residuals.
Eigen::MatrixXd productsBeside(const Calibration& car, const Fit& fit, const std::vector<Eigen::MatrixXd>& further,
                               const Sizes& sizes);

// The same of all knobs and then the residual, from the columns about a linearisation.
Eigen::MatrixXd productsOfKnobs(const Calibration& car, const Linearisation& about, const Fit& fit, const Sizes& sizes);

// Linear evidence that each effect would add to a fit that has some already, from the columns about a linearisation.
std::vector<double> gainsOver(const Calibration& car, const Linearisation& about, const Fit& fit);

// Largest cosine between two effects' signatures in such products.
double cosine(const Problem& problem, const Eigen::MatrixXd& products, std::size_t a, std::size_t b);

// Pairs that look alike and that these drives would leave confused if one of them were true, worst first (D40).
std::vector<answer::ConfusablePair> confusablePairs(const Calibration& car, const Screen& screen,
                                                    const std::vector<double>& expected_evidence);

}  // namespace tread::diagnose::select
