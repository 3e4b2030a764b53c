// Does a model predict drives that it was not fitted to? Each drive is left out in turn.
#pragma once

#include "diagnose/select/search.h"

namespace tread::diagnose::select {

// Logarithm of the density of each drive if its effects are those that the other drives tell, up to a constant that all
// models share. Its nuisances are as uncertain as before any drive: tolerances explain each drive anew, an effect must
// have one value in all. In the linear model about the fit, with its sizes of the remainder; bounds are ignored (D37).
std::vector<double> predictiveDensities(const Calibration& car, const Fit& fit);

// Nats that a model gains over another in the drives left out (Vehtari, Gelman & Gabry 2017), with the standard
// deviation of their sum that the differences between drives suggest (D38).
struct Prediction {
    double gain = 0, sd = 0;
    bool tested = false;  // false when a single drive determines the values of the effects
    // Nats that it gains in all other drives with the values of the drive that tells most of them (D38a).
    double others = 0;

    bool fails() const { return tested && gain <= 0; }
    // The others contradict the drive that tells most. If the model is true, this happens by chance with a probability
    // of kSettings.false_alarm at most: the mean of the likelihood ratio of a false to the true model is 1.
    bool contradicts() const;
};
Prediction predicted(const Calibration& car, const Fit& with, const Fit& without);

}  // namespace tread::diagnose::select
