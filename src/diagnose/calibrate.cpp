#include "diagnose/calibrate.h"

#include "run/simulate.h"

namespace tread {
namespace {

// Half the squared deviations of all parameters, over their number, that a car within its tolerances seldom exceeds.
constexpr double kLikely = 0.5;

Fit fitOf(Study& study, const Ground& ground, const Deviation& from) {
    std::optional<Fit> found = fitted(study.bench, study.uncertainty, ground, {}, from);
    if (!found) throw SimulationError("the nominal car cannot be driven in the recordings", 0);
    return std::move(*found);
}

}  // namespace

void calibrate(Study& study, const std::function<void(double)>& progress) {
    const std::vector<Eigen::Index>& nuisances = study.nominal.nuisances;
    study.calibration = fitOf(study, study.nominal, study.bench.origin());
    Linearised about = linearised(study.bench, study.calibration.at,
                                  {.parameters = nuisances, .elsewhere = &study.nominal.about}, progress);
    const double off = 0.5 * study.calibration.at.squaredNorm();
    study.likely = off < kLikely * static_cast<double>(nuisances.size());
    if (study.likely) {
        study.uncertainty = uncertaintyOf(study.bench, about.at, about.rows);
        study.nominal = ground(std::move(study.nominal.about), std::vector(nuisances), study.uncertainty);
    }
    study.calibrated = ground(std::move(about), study.nominal.nuisances, study.uncertainty);
    study.uncertainty.sizes =
        disturbanceSizes(everything(study, study.likely ? study.calibrated : study.nominal), study.uncertainty);
    study.calibration = fitOf(study, study.calibrated, study.calibration.at);
}

}  // namespace tread
