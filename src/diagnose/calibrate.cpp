#include "diagnose/calibrate.h"

#include "run/simulate.h"

namespace tread {
namespace {

constexpr int kMostRounds = 2;
constexpr double kSettled = 15;  // nats: a fit that gained less needs no new linearisation

Fit fitOf(Study& study, const Ground& ground, const Deviation& from) {
    std::optional<Fit> found = fitted(study.bench, study.uncertainty, ground, {}, from);
    if (!found) throw SimulationError("the nominal car cannot be driven in the recordings", 0);
    return std::move(*found);
}

}  // namespace

Linearised withKnobs(Study& study, const Linearised& nuisances, const std::function<void(double)>& progress) {
    std::vector<Eigen::Index> own, mixed;
    for (const Eigen::Index knob : study.allKnobs()) {
        const Parameter& parameter = study.bench.parameters[static_cast<std::size_t>(knob)];
        (study.asNuisances(parameter).empty() ? own : mixed).push_back(knob);
    }
    Linearised about = linearised(study.bench, study.calibration.at,
                                  {.parameters = own, .step = kKnobStep, .elsewhere = &nuisances}, progress);
    for (Eigen::MatrixXd& columns : about.columns) {
        for (const Eigen::Index knob : mixed) {
            columns.col(knob).setZero();
            for (const Share& share : study.asNuisances(study.bench.parameters[static_cast<std::size_t>(knob)]))
                columns.col(knob) += share.units * columns.col(static_cast<Eigen::Index>(share.of));
        }
    }
    return about;
}

std::vector<DriveGram> calibrate(Study& study, Ground nominal,
                                 const std::function<void(double, const std::string&)>& progress) {
    progress(0, "fitting tolerances");
    study.calibration = fitOf(study, nominal, study.bench.origin());
    study.calibrated = std::move(nominal);
    const std::vector<Eigen::Index> nuisances = study.calibrated.nuisances;
    for (int round = 0; round < kMostRounds; ++round) {
        Linearised about = nuisancesAt(study, study.calibration.at, [&](double share) {
            progress(0.5 * (round + share) / kMostRounds, "sensitivities to tolerances where they are");
        });
        study.uncertainty = uncertaintyOf(study.bench, about.at, about.rows);
        study.calibrated = ground(std::move(about), nuisances, study.uncertainty);
        study.calibration = fitOf(study, study.calibrated, study.calibration.at);
        if (study.calibration.gained < kSettled) break;
    }
    Linearised about = withKnobs(study, study.calibrated.about,
                                 [&](double share) { progress(0.5 + 0.5 * share, "sensitivities to effects"); });
    study.calibrated = ground(std::move(about), nuisances, study.uncertainty);
    study.uncertainty.sizes = disturbanceSizes(study, everything(study, study.calibrated));
    study.calibration = fitOf(study, study.calibrated, study.calibration.at);
    return everything(study, study.calibrated);
}

}  // namespace tread
