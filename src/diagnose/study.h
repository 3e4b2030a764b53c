// A diagnosis while it is made: the recordings on the bench, the effects in question, and the linearisation at the
// calibrated car from which every effect starts.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "diagnose/fit.h"

namespace tread {

struct Study {
    Bench bench;
    std::vector<Effect> effects;                   // those that the car can show at all
    std::vector<std::vector<Eigen::Index>> knobs;  // of each effect: indices of parameters
    std::vector<Eigen::Index> nuisances;           // all, indices of parameters
    Uncertainty uncertainty;
    Rows nominal;       // what the nominal car does
    Rows allowed;       // standard deviation of that by its tolerances
    Ground calibrated;  // about the nominal car with its parameters where the recordings want them, within tolerances
    Fit calibration;    // that brought it there

    // A parameter as a mixture of those nuisances that matter; empty when it is none.
    std::vector<Share> asNuisances(const Parameter& parameter) const {
        return mixture(parameter, bench.parameters, {calibrated.nuisances.begin(), calibrated.nuisances.end()});
    }

    std::vector<std::string> namesOf(const std::vector<std::size_t>& some) const {
        std::vector<std::string> names;
        for (const std::size_t e : some) names.push_back(effects[e].name);
        return names;
    }

    std::vector<Eigen::Index> allKnobs() const {
        std::vector<Eigen::Index> all;
        for (const auto& of_effect : knobs) all.insert(all.end(), of_effect.begin(), of_effect.end());
        return all;
    }
};

// The recordings from which to learn, or those held out, less their references as the bench's nominal car sees them.
std::vector<RecordedDrive> drivesOf(Bench& bench, const DiagnosisFile& file, const Recorded& recorded, bool held_out);

// Puts the nominal car and the recordings from which to learn on a bench; its parameters are added by whoever asks.
void begin(Bench& bench, const Subject& nominal, const DiagnosisFile& file, const Recorded& recorded,
           const DiagnoseOptions& options);

// What may differ between the model and the car on the bench: all uncertain numbers, then the knobs of those effects.
void addParameters(Study& study, const DiagnosisFile& file, const std::vector<Effect>& effects);

// Drives the nominal car: its rows and what its tolerances do; noise and disturbances are those about it.
Linearised aboutNominal(Study& study, const std::function<void(double, const std::string&)>& progress);

// Throws when the nominal car could not be driven in one of the recordings.
void expectDriven(const Bench& bench, const Linearised& about);

// The study's nuisances without those that make no difference to any answer.
std::vector<Eigen::Index> thatMatter(const Study& study, const Linearised& about);

// Of the drives on a bench about a point, whose rows are these; with disturbances of the usual sizes.
Uncertainty uncertaintyOf(Bench& bench, const Deviation& at, const Rows& rows);

// The drives about another point: nuisances anew where they make a difference, all else as about the calibrated car.
Linearised nuisancesAt(Study& study, const Deviation& at, const std::function<void(double)>& progress);

// Of one drive, over the noise: the columns of all knobs about a point, then the residual that these rows leave.
Eigen::MatrixXd knobsAndResidual(const Study& study, const Linearised& about, const Rows& rows, std::size_t drive);

// Products of the nuisances, all knobs and the residual about a ground that knows the knobs' columns.
std::vector<DriveGram> everything(const Study& study, const Ground& ground);

// Times the noise that the rows of a model leave (the root of Birge's ratio, 1932; not below 1): a model whose
// structure is not that of the car leaves more, and what it says of anything is that much less certain.
double leftOver(const Study& study, const Rows& rows);

// Sizes of the disturbances under which the recordings are most likely, whatever mixture of nuisances and effects is
// true; near the usual ones unless the recordings say otherwise.
std::array<double, kDisturbances> disturbanceSizes(const Study& study, const std::vector<DriveGram>& grams);

}  // namespace tread
