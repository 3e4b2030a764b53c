#include "diagnose/select/calibration.h"

#include <cmath>

#include "diagnose/settings.h"
#include "run/simulate.h"

namespace tread::diagnose::select {
namespace {

constexpr int kMostRounds = 2;   // fits after a new linearisation, which costs up to a replay per drive and nuisance
constexpr double kSettled = 15;  // nats; the linearisation is not renewed after a fit that gained less

// Coordinate search over the logarithms of the sizes, in usual sizes.
constexpr int kSweeps = 6;
constexpr double kFirstStep = 0.6;

Fit fitOf(const Problem& problem, const Uncertainty& uncertainty, const Linearisation& about, const Deviation& from) {
    std::optional<Fit> found = fitted(problem.replays, problem.drives, uncertainty, about, {}, from);
    if (!found)
        throw SimulationError(
            "the simulation of the nominal car in the recordings fails; check the vehicle file and the recorded inputs",
            0);
    return std::move(*found);
}

// The linearisation of the calibration with the columns of all knobs added. Knobs that move uncertain numbers only are
// mixtures of the nuisances' columns and need no replay.
model::Sensitivities withKnobs(const Calibration& car, const std::function<void(double)>& progress) {
    const Problem& problem = car.problem;
    std::vector<Eigen::Index> own, mixed;
    for (const Eigen::Index knob : problem.allKnobs())
        (car.asNuisances(problem.replays.parameters[knob]).empty() ? own : mixed).push_back(knob);
    model::Sensitivities about =
        model::sensitivities(problem.replays, problem.drives, car.fit.at,
                             {.parameters = own, .step = model::kEffectStep, .elsewhere = &car.about.about}, progress);
    for (Eigen::MatrixXd& columns : about.columns) {
        for (const Eigen::Index knob : mixed) {
            columns.col(knob).setZero();
            for (const model::Share& share : car.asNuisances(problem.replays.parameters[knob]))
                columns.col(knob) += share.units * columns.col(share.of);
        }
    }
    return about;
}

Sizes exponentialOf(const Sizes& logs) {
    Sizes sizes{};
    for (std::size_t i = 0; i < logs.size(); ++i) sizes[i] = std::exp(logs[i]);
    return sizes;
}

// The sizes describe the disturbances themselves, so the inflation for references is taken out.
std::vector<DriveProducts> withoutInflation(Drives drives, std::vector<DriveProducts> products) {
    for (std::size_t d = 0; d < products.size(); ++d) {
        const double inflation = model::referenceInflation(drives[d]);
        products[d].columns *= inflation * inflation;
        products[d].mixed *= inflation;
    }
    return products;
}

}  // namespace

std::vector<model::Share> Calibration::asNuisances(const Parameter& parameter) const {
    return model::mixture(parameter, problem.replays.parameters, about.nuisances);
}

Calibration calibrate(const Problem& problem, model::NominalCar nominal, const Progress& progress) {
    progress(0, "fitting tolerances");
    Calibration car{problem,
                    nominal.about.about.rows,
                    std::move(nominal.allowed),
                    std::move(nominal.uncertainty),
                    std::move(nominal.about),
                    {},
                    {}};
    car.fit = fitOf(problem, car.uncertainty, car.about, problem.replays.origin());
    const std::vector<Eigen::Index> relevant = car.about.nuisances;
    for (int round = 0; round < kMostRounds; ++round) {
        model::Sensitivities about = model::nuisancesAt(
            problem.replays, problem.drives, car.fit.at, car.about, car.uncertainty, [&](double share) {
                progress(0.5 * (round + share) / kMostRounds, "sensitivities to tolerances at their fitted values");
            });
        car.uncertainty =
            model::uncertaintyAt(problem.replays, problem.drives, about.at, about.rows, car.uncertainty.until);
        car.about = model::linearisation(std::move(about), relevant, car.uncertainty);
        car.fit = fitOf(problem, car.uncertainty, car.about, car.fit.at);
        if (car.fit.gained < kSettled) break;
    }
    model::Sensitivities with_knobs =
        withKnobs(car, [&](double share) { progress(0.5 + 0.5 * share, "sensitivities to effects"); });
    car.about = model::linearisation(std::move(with_knobs), relevant, car.uncertainty);
    car.products = model::productsWith(problem.allKnobs(), problem.drives, car.about, car.uncertainty);
    car.uncertainty.sizes = disturbanceSizes(problem.drives, car.uncertainty, car.products);
    car.fit = fitOf(problem, car.uncertainty, car.about, car.fit.at);
    return car;
}

Calibration uncalibrated(const Problem& problem, model::NominalCar nominal, const Progress& progress) {
    Calibration car{problem,
                    nominal.about.about.rows,
                    std::move(nominal.allowed),
                    std::move(nominal.uncertainty),
                    std::move(nominal.about),
                    {},
                    {}};
    const std::vector<Eigen::Index> relevant = car.about.nuisances;
    car.fit.free = relevant;
    car.fit.at = problem.replays.origin();
    car.fit.rows = car.nominal;
    car.fit.columns = car.about.columns;
    model::Sensitivities with_knobs =
        withKnobs(car, [&](double share) { progress(share, "sensitivities to effects"); });
    car.about = model::linearisation(std::move(with_knobs), relevant, car.uncertainty);
    car.products = model::productsWith(problem.allKnobs(), problem.drives, car.about, car.uncertainty);
    return car;
}

Sizes disturbanceSizes(Drives drives, const Uncertainty& uncertainty, const std::vector<DriveProducts>& products) {
    const std::vector<DriveProducts> plain = withoutInflation(drives, products);
    const auto merit = [&](const Sizes& logs) {
        double prior = 0;
        for (const double one : logs) prior += 0.5 * one * one / (kSettings.size_spread * kSettings.size_spread);
        const model::NormalEquations sum = model::normalEquations(uncertainty, plain, exponentialOf(logs));
        const Eigen::Index n = sum.products.cols() - 1;
        const inference::QuadraticModel all{.information = sum.products.topLeftCorner(n, n),
                                            .gradient = sum.products.topRightCorner(n, 1),
                                            .at = Eigen::VectorXd::Zero(n),
                                            .squared_residual = sum.products(n, n),
                                            .log_determinant = sum.log_determinant};
        return inference::logEvidence(all, inference::bestStep(all)) - prior;
    };
    Sizes logs{};
    double best = merit(logs), step = kFirstStep;
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        bool moved = false;
        for (double& one : logs) {
            for (const double by : {step, -step}) {
                const double before = one;
                if (std::abs(before + by) > std::log(kSettings.largest_size)) continue;
                one = before + by;
                const double now = merit(logs);
                if (now > best) {
                    best = now, moved = true;
                    break;
                }
                one = before;
            }
        }
        if (!moved) step /= 2;
    }
    return exponentialOf(logs);
}

}  // namespace tread::diagnose::select
