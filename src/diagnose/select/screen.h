// Screen of all effects in the linearisation alone. Before a fit: can each effect be seen in these drives and told from
// the others? With the data: how much evidence would it gain?
#pragma once

#include <string>
#include <vector>

#include "diagnose/answer/diagnosis.h"
#include "diagnose/select/calibration.h"

namespace tread::diagnose::select {

struct Screen {
    std::vector<double> expected_evidence;  // nats at typical size, per effect
    // Nats over the model without effects, in the linear model, per effect: with the remainder that all effects
    // together leave and usual imperfections, and with remainder and imperfections of the model without effects.
    std::vector<double> gain, least_gain;
    Eigen::MatrixXd products;  // of all knobs, then the residual; nuisances and disturbances marginalised
};
// Expected evidence (D43), linear gains (D25) and products about the calibrated car.
Screen screen(const Calibration& car);

// Expected evidence corrected for effects that act beyond a limit only (controllers, play, stops): it is lowered to
// what a replay shows at typical size, since the car as found may never pass that limit.
std::vector<double> expectedEvidenceAt(const Calibration& car, const Fit& found, const Screen& screen);

// Indices of an effect's knobs in the list of all knobs.
std::vector<Eigen::Index> placesOf(const Problem& problem, std::size_t effect);

// Products of further columns of each drive, with the free parameters of a fit and disturbances of these sizes
// marginalised. The last of the columns must be the residual of the fit.
Eigen::MatrixXd productsBeside(const Calibration& car, const Fit& fit, const std::vector<Eigen::MatrixXd>& further,
                               const Sizes& sizes);

// The same for all knobs, then the residual, with the columns of a linearisation.
Eigen::MatrixXd productsOfKnobs(const Calibration& car, const Linearisation& about, const Fit& fit, const Sizes& sizes);

// Evidence that each effect would add to a fit, in the linear model with the columns of a linearisation.
std::vector<double> gainsOver(const Calibration& car, const Linearisation& about, const Fit& fit, const Sizes& sizes);

// Largest cosine between columns of two effects in such products.
double cosine(const Problem& problem, const Eigen::MatrixXd& products, std::size_t a, std::size_t b);

// Pairs with similar signatures that these drives would leave confused if one of them were true, worst first (D40).
std::vector<answer::ConfusablePair> confusablePairs(const Calibration& car, const Screen& screen,
                                                    const std::vector<double>& expected_evidence);

}  // namespace tread::diagnose::select
