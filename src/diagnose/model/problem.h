// What is asked of a diagnosis: the drives, the model that repeats them, and what may differ between model and car. It
// is built whole and does not change any more.
#pragma once

#include "diagnose/catalogue/effect.h"
#include "diagnose/model/linearisation.h"
#include "diagnose/options.h"

namespace tread::diagnose::model {

struct Problem {
    Replays replays;
    std::vector<RecordedDrive> drives;             // from which to learn
    std::vector<RecordedDrive> held_out;           // that judge
    std::vector<Effect> effects;                   // those that the car can show at all
    std::vector<std::vector<Eigen::Index>> knobs;  // of each effect: indices of parameters
    std::vector<Eigen::Index> nuisances;           // indices of parameters

    bool compared() const { return recording::compared(drives); }
    std::vector<std::string> namesOf(const std::vector<std::size_t>& some) const;
    std::vector<Eigen::Index> allKnobs() const;
};

// All uncertain numbers may differ, and then the parameters of those effects. Recordings are less their references, as
// the nominal car sees them. Throws std::invalid_argument when nothing can be learnt from a recording.
Problem problemOf(const Subject& nominal, const recording::DiagnosisFile& file, const recording::Recorded& recorded,
                  const std::vector<Effect>& effects, const Options& options);

// The same with parameters of the caller's.
struct Differences {
    std::vector<Parameter> parameters;
    std::vector<Effect> effects;
    std::vector<std::vector<Eigen::Index>> knobs;
    std::vector<Eigen::Index> nuisances;
};
Problem problemOf(const Subject& nominal, const recording::DiagnosisFile& file, const recording::Recorded& recorded,
                  const std::function<Differences(bool compared)>& differences, const Options& options);

// The nominal car in the drives: its rows and what its tolerances do; noise and disturbances are those about it.
struct NominalCar {
    Rows allowed;  // standard deviation of its rows by its tolerances
    Uncertainty uncertainty;
    Linearisation about;  // to the relevant nuisances; about.about.rows is what it does
};
NominalCar nominalCar(const Problem& problem, const Progress& progress);

// Throws when the nominal car could not be driven in one of the recordings.
void expectDriven(Drives drives, const Sensitivities& about);

}  // namespace tread::diagnose::model
