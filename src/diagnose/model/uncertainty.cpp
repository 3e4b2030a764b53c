#include "diagnose/model/uncertainty.h"

#include <algorithm>
#include <cmath>

#include "base/threads/parallel.h"
#include "diagnose/model/sensitivities.h"
#include "recording/sliding.h"

namespace tread::diagnose::model {
Eigen::VectorXd Uncertainty::sizesOf(std::size_t drive, const Sizes& with) const {
    const std::vector<Disturbed>& kinds = disturbing[drive].kinds;
    Eigen::VectorXd all(std::ssize(kinds) + 1);
    for (std::size_t i = 0; i < kinds.size(); ++i) all(i) = with[placeOf(kinds[i])];
    all(all.size() - 1) = kStartSpeedStep;
    return all;
}

std::vector<double> endsOf(Drives drives) {
    std::vector<double> until;
    for (const RecordedDrive& drive : drives) until.push_back(drive.until);
    return until;
}

Uncertainty uncertaintyAt(const Replays& replays, Drives drives, const Deviation& at, const Rows& rows,
                          std::vector<double> until, const Uncertainty* known, const std::vector<bool>& renewed,
                          Resolution resolution) {
    for (std::size_t d = 0; d < drives.size(); ++d)
        until[d] = std::min(until[d], recording::slideApart(drives[d], rows[d]));
    Uncertainty uncertainty;
    uncertainty.sizes.fill(1);
    uncertainty.noise = rowNoise(drives, rows, until);
    uncertainty.until = std::move(until);
    uncertainty.disturbing.resize(drives.size());
    uncertainty.directions.resize(drives.size());
    uncertainty.bare.resize(drives.size());
    std::vector<const RecordedDrive*> driven;
    std::vector<Subject> subjects;
    std::vector<std::size_t> places;
    for (std::size_t d = 0; d < drives.size(); ++d) {
        if (known && (renewed.empty() || !renewed[d])) {
            uncertainty.disturbing[d] = known->disturbing[d];
            continue;
        }
        driven.push_back(&drives[d]);
        subjects.push_back(replays.subjectAt(at, drives[d]));
        places.push_back(d);
    }
    std::vector<Disturbances> found = disturbances(replays, driven, subjects, resolution);
    for (std::size_t i = 0; i < found.size(); ++i) uncertainty.disturbing[places[i]] = std::move(found[i]);
    inParallel(drives.size(), replays.threads, [&](std::size_t d) {
        const Disturbances& disturbing = uncertainty.disturbing[d];
        Eigen::MatrixXd all(disturbing.columns.rows(), disturbing.columns.cols() + 1);
        all << disturbing.columns, disturbing.by_start_speed;
        all = uncertainty.noise[d].over(all) * disturbanceScale(drives[d]);
        uncertainty.bare[d] = inference::productsOf(Eigen::MatrixXd(all.rows(), 0), all);
        uncertainty.directions[d] = std::move(all);
    });
    return uncertainty;
}

Eigen::VectorXd residual(Drives drives, const Uncertainty& uncertainty, const Rows& rows, std::size_t drive) {
    return uncertainty.noise[drive].over(drives[drive].measured - rows[drive]);
}

DriveProducts productsOf(const Uncertainty& uncertainty, std::size_t drive, const Eigen::MatrixXd& columns) {
    return inference::extended(uncertainty.bare[drive], Eigen::MatrixXd(columns.rows(), 0),
                               uncertainty.directions[drive], columns);
}

double squaresOf(const Uncertainty& uncertainty, std::size_t drive, const Eigen::VectorXd& off, const Sizes& sizes) {
    return normalEquations(uncertainty, drive, productsOf(uncertainty, drive, off), sizes).products(0, 0);
}

NormalEquations normalEquations(const Uncertainty& uncertainty, std::size_t drive, const DriveProducts& products,
                                const Sizes& sizes) {
    return inference::normalEquations(products, uncertainty.sizesOf(drive, sizes));
}

std::vector<NormalEquations> equationsOfEach(const Uncertainty& uncertainty, const std::vector<DriveProducts>& products,
                                             const Sizes& sizes, int threads) {
    std::vector<NormalEquations> each(products.size());
    inParallel(products.size(), threads,
               [&](std::size_t d) { each[d] = normalEquations(uncertainty, d, products[d], sizes); });
    return each;
}

NormalEquations normalEquations(const Uncertainty& uncertainty, const std::vector<DriveProducts>& products,
                                const Sizes& sizes, int threads) {
    return inference::sumOf(equationsOfEach(uncertainty, products, sizes, threads));
}

double birgeRatio(Drives drives, const Uncertainty& uncertainty, const Rows& rows, const Sizes& sizes) {
    double sum = 0, expected = 0;
    for (std::size_t d = 0; d < rows.size(); ++d) {
        sum += squaresOf(uncertainty, d, residual(drives, uncertainty, rows, d), sizes);
        expected += uncertainty.noise[d].expected;
    }
    return expected > 0 ? std::max(1.0, std::sqrt(sum / expected)) : 1;
}

}  // namespace tread::diagnose::model
