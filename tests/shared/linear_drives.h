// A diagnosis in the middle of its work, filled in by hand: drives whose rows are linear in all parameters and in units
// of their noise. Each row is a channel of its own to the smoothing, so that nothing is smoothed; N_e is the count of
// rows.
#pragma once

#include <numeric>
#include <string>
#include <vector>

#include "base/math/random.h"
#include "diagnose/model/remainder.h"
#include "diagnose/select/doubt.h"
#include "diagnose/select/search.h"

namespace tread::linear_drives {

using diagnose::model::Disturbed;
using diagnose::model::Sizes;
using Eigen::MatrixXd;
using Eigen::VectorXd;

inline MatrixXd normals(Eigen::Index rows, Eigen::Index columns, Random& random) {
    MatrixXd all(rows, columns);
    for (double& one : all.reshaped()) one = random.normal();
    return all;
}

struct LinearDrive {
    MatrixXd nuisances, effects;        // a column each; every effect has one parameter
    VectorXd measured;                  // less what the nominal car does
    MatrixXd disturbances;              // columns of the usual size
    std::vector<Disturbed> kinds = {};  // of these columns; empty: all lateral

    Disturbed kindOf(Eigen::Index column) const { return kinds.empty() ? Disturbed::lateral : kinds[column]; }
};

inline diagnose::model::Problem problemOf(const std::vector<LinearDrive>& drives) {
    diagnose::model::Problem problem;
    const auto parameter = [&](const std::string& name, double limit) {
        problem.replays.parameters.push_back({.moves = {{name, 0, 1}}, .lowest = -limit, .highest = limit});
        return std::ssize(problem.replays.parameters) - 1;
    };
    for (Eigen::Index i = 0; i < drives.front().nuisances.cols(); ++i)
        problem.nuisances.push_back(parameter("n" + std::to_string(i), 4));
    for (Eigen::Index e = 0; e < drives.front().effects.cols(); ++e) {
        const std::string name = "e" + std::to_string(e);
        problem.effects.push_back({.name = name, .question = {}, .source = {}, .knobs = {}});
        problem.knobs.push_back({parameter(name, 8)});
    }
    static const recording::Recording kRecording;
    for (const LinearDrive& told : drives) {
        recording::RecordedDrive& drive = problem.drives.emplace_back();
        drive.recording = &kRecording;
        drive.name = "drive " + std::to_string(problem.drives.size());
        drive.measured = told.measured;
        drive.channels = {{.name = "rows", .measured = {}, .times = std::vector<double>(told.measured.size())}};
    }
    return problem;
}

// Kinds that act in the drives have so many times their usual size.
inline diagnose::model::Uncertainty uncertaintyOf(const std::vector<LinearDrive>& drives, double size) {
    diagnose::model::Uncertainty uncertainty;
    uncertainty.sizes.fill(1);
    for (const LinearDrive& told : drives) {
        const Eigen::Index rows = told.measured.size(), impulses = told.disturbances.cols();
        diagnose::model::RowNoise& noise = uncertainty.noise.emplace_back();
        noise.deviation = VectorXd::Ones(rows);
        noise.ends.resize(rows);
        std::iota(noise.ends.begin(), noise.ends.end(), 1);
        noise.expected = static_cast<double>(rows);
        uncertainty.until.push_back(kInfinity);
        diagnose::model::Disturbances& disturbing = uncertainty.disturbing.emplace_back();
        for (Eigen::Index i = 0; i < impulses; ++i) {
            disturbing.kinds.push_back(told.kindOf(i));
            uncertainty.sizes[placeOf(told.kindOf(i))] = size;
        }
        MatrixXd& directions = uncertainty.directions.emplace_back(MatrixXd::Zero(rows, impulses + 1));
        directions.leftCols(impulses) = disturbing.columns = told.disturbances;
        disturbing.by_start_speed = VectorXd::Zero(rows);  // the speed at the start changes nothing
        uncertainty.bare.push_back(inference::productsOf(MatrixXd(rows, 0), directions));
    }
    return uncertainty;
}

// The nominal car, with disturbances of so many times the usual size and signatures known to 5 %.
inline diagnose::select::Calibration calibrationOf(const diagnose::model::Problem& problem,
                                                   const std::vector<LinearDrive>& drives, double size = 1) {
    diagnose::select::Calibration car{problem, {}, {}, uncertaintyOf(drives, size), {}, {}, {}};
    diagnose::model::Sensitivities about{problem.replays.origin(), {}, {}};
    for (const LinearDrive& told : drives) {
        about.rows.emplace_back(VectorXd::Zero(told.measured.size()));
        MatrixXd& columns = about.columns.emplace_back(told.measured.size(), about.at.size());
        columns << told.nuisances, told.effects;
    }
    car.structure_error = 0.05;
    car.nominal = car.fit.rows = about.rows;
    car.about =
        diagnose::model::linearisation(std::move(about), problem.nuisances, problem.allKnobs(), car.uncertainty, 1);
    car.products = diagnose::model::productsWithResidual(problem.drives, car.about, car.uncertainty);
    car.fit.free = problem.nuisances;
    car.fit.at = problem.replays.origin();
    const auto nuisances = std::ssize(problem.nuisances);
    for (const MatrixXd& columns : car.about.columns) car.fit.columns.emplace_back(columns.leftCols(nuisances));
    car.fit.products = car.products;
    return car;
}

// The fit of the nuisances and these effects, with a remainder of these sizes: one step leads there.
inline diagnose::select::Fit fitOf(const diagnose::select::Calibration& car, const std::vector<std::size_t>& effects,
                                   const Sizes& sizes) {
    const diagnose::model::Problem& problem = car.problem;
    diagnose::select::Fit fit;
    fit.at = problem.replays.origin();
    for (const std::size_t e : effects) fit.knobs.push_back(problem.knobs[e].front());
    fit.free = diagnose::model::joined(problem.nuisances, fit.knobs);
    fit.rows = car.nominal;
    fit.sizes = sizes;
    const auto look = [&] {
        fit.products.clear(), fit.columns.clear();
        for (std::size_t d = 0; d < problem.drives.size(); ++d) {
            const MatrixXd all = diagnose::model::columnsAndResidual(problem.drives, car.uncertainty, car.about.about,
                                                                     fit.free, fit.rows, d);
            fit.columns.emplace_back(all.leftCols(all.cols() - 1));
            fit.products.push_back(diagnose::model::productsOf(car.uncertainty, d, all));
        }
        return diagnose::select::quadraticAt(fit, car.uncertainty);
    };
    fit.at(fit.free) = inference::bestStep(look());
    for (std::size_t d = 0; d < fit.rows.size(); ++d) fit.rows[d] = car.about.about.columns[d] * fit.at;
    const inference::QuadraticModel there = look();
    const Eigen::Index n = std::ssize(fit.free);
    fit.covariance = inference::factorOfPriorAnd(there.information).solve(MatrixXd::Identity(n, n));
    fit.log_evidence = inference::logEvidence(there, VectorXd::Zero(n)) +
                       diagnose::model::logPrior(sizes, diagnose::model::kWidePrior);
    fit.converged = true;
    return fit;
}
inline diagnose::select::Fit fitOf(const diagnose::select::Calibration& car, const std::vector<std::size_t>& effects) {
    return fitOf(car, effects, car.uncertainty.sizes);
}

// Doubt about the signatures of a fit, in the metric of its own remainder.
inline double doubtAgainst(const diagnose::select::Fit& rival, const diagnose::select::Calibration& car,
                           const diagnose::select::Fit& fit) {
    const diagnose::model::ChannelSquares squares(car.drives(), car.uncertainty, fit.sizes);
    return diagnose::select::doubt(car, squares, fit, rival.rows);
}

// The same with the sizes of the largest evidence.
inline diagnose::select::Fit resizedFitOf(const diagnose::select::Calibration& car,
                                          const std::vector<std::size_t>& effects) {
    constexpr int kEnough = 200;
    diagnose::select::Fit fit = fitOf(car, effects);
    for (int i = 0; i < kEnough; ++i)
        fit = fitOf(car, effects, diagnose::model::improvedSizes(car.uncertainty, fit.products, fit.sizes, 1));
    return fit;
}

// Logarithm of the density of all rows, without the constant -rows/2 log(2 pi): from their full covariance, in which
// everything but the noise is marginalised.
inline double logDensity(const std::vector<LinearDrive>& drives, const std::vector<std::size_t>& effects,
                         const Sizes& sizes) {
    Eigen::Index rows = 0, first = 0;
    for (const LinearDrive& drive : drives) rows += drive.measured.size();
    const Eigen::Index nuisances = drives.front().nuisances.cols();
    MatrixXd shared(rows, nuisances + std::ssize(effects)), covariance = MatrixXd::Identity(rows, rows);
    VectorXd measured(rows);
    for (const LinearDrive& drive : drives) {
        const Eigen::Index count = drive.measured.size();
        measured.segment(first, count) = drive.measured;
        shared.block(first, 0, count, nuisances) = drive.nuisances;
        for (std::size_t e = 0; e < effects.size(); ++e)
            shared.col(nuisances + static_cast<Eigen::Index>(e)).segment(first, count) =
                drive.effects.col(static_cast<Eigen::Index>(effects[e]));
        for (Eigen::Index i = 0; i < drive.disturbances.cols(); ++i) {
            const VectorXd column = sizes[placeOf(drive.kindOf(i))] * drive.disturbances.col(i);
            covariance.block(first, first, count, count) += column * column.transpose();
        }
        first += count;
    }
    covariance += shared * shared.transpose();
    const Eigen::LLT<MatrixXd> factor(covariance);
    return -0.5 * measured.dot(factor.solve(measured)) - MatrixXd(factor.matrixL()).diagonal().array().log().sum();
}

inline diagnose::select::Candidate candidateOf(const diagnose::select::Calibration& car,
                                               const std::vector<std::size_t>& effects) {
    diagnose::select::Candidate candidate{.effects = effects, .fit = fitOf(car, effects), .fitted = true};
    candidate.log_evidence = candidate.fit.log_evidence - fitOf(car, {}).log_evidence;
    return candidate;
}

}  // namespace tread::linear_drives
