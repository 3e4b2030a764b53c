// Identification: numbers of a car fitted to recordings, how well the drives determine them, and how far the gap
// shrinks.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "diagnose/answer/diagnosis.h"
#include "diagnose/options.h"
#include "recording/diagnosis_file.h"

namespace tread::calibrate {

struct FittedNumber {
    std::string path;
    double value = 0, sd = 0;
    double nominal = 0, prior_sd = 0;
    double lowest = 0, highest = 0;  // bounds of the search
    double z = 0;                    // change from the nominal value, in prior standard deviations
    bool at_bound = false;
    bool determined = false;  // by the drives; otherwise it is known no better than before
};

struct Identification {
    std::string answer;  // in words
    std::vector<FittedNumber> numbers;
    std::vector<std::vector<double>> correlation;  // of the posterior, in the order of the numbers
    double condition = 0;  // condition number of the drives' information about the numbers, in units of their priors
    // Eigenvector of the least information: the mixture of numbers that the drives determine least.
    std::map<std::string, double> weakest;
    double birge_ratio = 1;      // residual over noise at the last linearisation; scales the standard errors
    bool of_references = false;  // true when fitted to references: the car before the change
    bool converged = false;
    bool better = false;  // than the nominal car: in held-out drives, or in the fitted ones if there are none
    // Stages of the gap: the nominal car, the fitted numbers alone (`calibrated`), and with the other uncertain numbers
    // fitted within their tolerances (`extended`).
    diagnose::answer::Diagnosis gap;
};

// Fits the numbers that `file.fit` names. The prior of a number is its tolerance, from the file or from its
// description. All other tolerances are nuisance parameters; noise and disturbances are those of a diagnosis. Where
// recordings have references, only the references are fitted: the result is the car before the change, with which a
// diagnosis can then start. Throws LoadError when the car has no such number or its tolerance is unknown.
Identification identificationOf(const recording::Subject& nominal, recording::DiagnosisFile file,
                                recording::Recorded recorded, const diagnose::Options& options = {});

}  // namespace tread::calibrate
