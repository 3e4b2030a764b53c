// The problem that a diagnosis solves: the recorded drives, the model that replays them, and the parameters in which
// model and car may differ. Built once and constant from then on.
#pragma once

#include "diagnose/catalogue/effect.h"
#include "diagnose/model/linearisation.h"
#include "diagnose/options.h"

namespace tread::diagnose::model {

struct Problem {
    Replays replays;
    std::vector<RecordedDrive> drives;             // the model is fitted to these
    std::vector<RecordedDrive> held_out;           // these only test the fitted model
    std::vector<Effect> effects;                   // those that this car can have
    std::vector<std::vector<Eigen::Index>> knobs;  // of each effect: indices into replays.parameters
    std::vector<Eigen::Index> nuisances;           // indices into replays.parameters
    // Further nuisances: numbers of the car before and after alike. They matter only about a car that differs much from
    // the one before.
    std::vector<Eigen::Index> of_both;
    std::vector<Eigen::Index> imperfections;  // one per knob: indices into replays.parameters

    bool compared() const { return recording::compared(drives); }
    std::vector<std::string> namesOf(const std::vector<std::size_t>& some) const;
    std::vector<Eigen::Index> allKnobs() const;
    std::vector<Eigen::Index> knobsOf(const std::vector<std::size_t>& some) const;
    // The point without other effects than these.
    Deviation withOnly(const std::vector<std::size_t>& some, Deviation point) const;
};

// Parameters are all uncertain numbers and the knobs of the given effects. Where a recording has a reference, the gap
// of the nominal car to the reference is subtracted. `left_open`: tolerances of numbers that car and reference share.
// Throws std::invalid_argument when nothing can be learnt from a recording.
Problem problemOf(const Subject& nominal, const recording::DiagnosisFile& file, const recording::Recorded& recorded,
                  const std::vector<Effect>& effects, const Options& options,
                  const std::vector<KnownWithin>& left_open = {});

// The same with parameters chosen by the caller.
struct Differences {
    std::vector<Parameter> parameters;
    std::vector<Effect> effects;
    std::vector<std::vector<Eigen::Index>> knobs;
    std::vector<Eigen::Index> nuisances, of_both, imperfections;
};
Problem problemOf(const Subject& nominal, const recording::DiagnosisFile& file, const recording::Recorded& recorded,
                  const std::function<Differences(Drives)>& differences, const Options& options);

// The nominal car in the drives: its rows, their sensitivities to the tolerances, and the noise and disturbances about
// them.
struct NominalCar {
    Rows allowed;  // standard deviation of its rows due to its tolerances
    Uncertainty uncertainty;
    Linearisation about;  // with respect to the relevant nuisances; about.about.rows are the rows of the nominal car
};
NominalCar nominalCar(const Problem& problem, const Progress& progress, Resolution resolution = Resolution::fine);

// Throws std::invalid_argument when the nominal car could not be driven in one of the recordings.
void expectDriven(Drives drives, const Sensitivities& about);

}  // namespace tread::diagnose::model
