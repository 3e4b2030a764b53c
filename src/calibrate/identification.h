// Numbers of a car fitted to recordings: how well the drives determine them, and how far the gap shrinks with them.
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
    double lowest = 0, highest = 0;  // within which it was sought
    double z = 0;                    // standard deviations of its prior that it moved
    bool at_bound = false;
    bool determined = false;  // by the drives; otherwise it is known no better than before
};

struct Identification {
    std::string answer;  // in words
    std::vector<FittedNumber> numbers;
    std::vector<std::vector<double>> correlation;  // of what is left uncertain, in the order of the numbers
    double condition = 0;                   // of the drives' information about the numbers, in units of their priors
    std::map<std::string, double> weakest;  // the mixture of them that the drives see least: shares of a unit vector
    double birge_ratio = 1;                 // times the noise that the fit leaves: the standard errors are scaled by it
    bool of_references = false;             // fitted is the car as it was before what changed on it
    bool converged = false;
    bool better = false;  // than the nominal car, in the drives that judge
    // Stages of the gap: the nominal car, the fitted numbers alone (`calibrated`), and the rest of what is uncertain
    // fitted within its tolerances, too (`extended`).
    diagnose::answer::Diagnosis gap;
};

// Fits the numbers that `file.fit` names. A number's prior is its tolerance, from the file or its description; the
// other tolerances are free, too, and disturbances and noise are those of a diagnosis. Where recordings have
// references, it is these that are fitted, and no others: the car before the change, from which a diagnosis can then
// begin. Throws LoadError when the car has no such number, or one whose tolerance nobody told.
Identification identificationOf(const recording::Subject& nominal, recording::DiagnosisFile file,
                                recording::Recorded recorded, const diagnose::Options& options = {});

}  // namespace tread::calibrate
