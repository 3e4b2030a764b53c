#include "diagnose/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "diagnose/reference.h"
#include "identify/parallel.h"

namespace tread {
namespace {

constexpr double kSizeSpread = 0.5;  // of the logarithm of a size about that of the usual one
constexpr double kLargestFactor = 3;
constexpr int kSweeps = 6;
constexpr double kWorthDriving = 0.1;  // squared signal over noise of a nuisance of usual size
constexpr double kNegligible = 0.01;   // nats that a nuisance of usual size makes of difference
constexpr double kBetweenDays = 0.2;   // of its tolerances, that a car differs by from itself on another day

// Drives in which a nuisance makes a difference: only there is it worth a new look.
std::vector<std::vector<bool>> worthDriving(const Study& study) {
    const Ground& about = study.calibrated;
    std::vector<std::vector<bool>> worth(about.nuisances.size(), std::vector<bool>(about.grams.size()));
    for (std::size_t d = 0; d < about.grams.size(); ++d) {
        const Gram gram = whitened(about.grams[d], study.uncertainty.sizesOf(d, study.uncertainty.sizes));
        for (std::size_t i = 0; i < worth.size(); ++i)
            worth[i][d] = gram.products(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) > kWorthDriving;
    }
    return worth;
}

}  // namespace

std::vector<RecordedDrive> drivesOf(Bench& bench, const DiagnosisFile& file, const Recorded& recorded, bool held_out) {
    std::vector<RecordedDrive> drives, references;
    std::vector<Recording> before;
    before.reserve(file.recordings.size());  // drives point at their recordings
    for (std::size_t i = 0; i < file.recordings.size(); ++i) {
        const Recording& recording = file.recordings[i];
        if (recording.hold_out != held_out) continue;
        const bool compared = !recording.reference.empty();
        drives.push_back(recordedDrive(
            recording, compared ? withChannelsOf(recorded.logs[i], recorded.references[i]) : recorded.logs[i], file));
        before.push_back(referenceOf(recording));
        references.push_back(compared ? recordedDrive(before.back(), recorded.references[i], file) : RecordedDrive{});
    }
    inParallel(drives.size(), bench.threads, [&](std::size_t i) {
        if (references[i].rows() > 0) lessReference(bench, drives[i], references[i]);
    });
    return drives;
}

void begin(Bench& bench, const Subject& nominal, const DiagnosisFile& file, const Recorded& recorded,
           const DiagnoseOptions& options) {
    bench.nominal = nominal;
    bench.step = file.step;
    bench.simulate = options.simulate;
    bench.threads = options.threads;
    bench.cache = options.cache;
    bench.drives = drivesOf(bench, file, recorded, false);
    if (bench.drives.empty())
        throw std::invalid_argument("every recording is held out, expected at least one from which to learn");
}

void addParameters(Study& study, const DiagnosisFile& file, const std::vector<Effect>& effects) {
    Bench& bench = study.bench;
    bench.parameters = nuisances(bench.nominal, file.tolerances, bench.compared() ? kBetweenDays : 1);
    for (std::size_t i = 0; i < bench.parameters.size(); ++i) study.nuisances.push_back(static_cast<Eigen::Index>(i));
    for (const Effect& effect : effects) {
        std::vector<Eigen::Index> knobs;
        for (Parameter& parameter : knobsOf(effect, bench.nominal)) {
            knobs.push_back(static_cast<Eigen::Index>(bench.parameters.size()));
            bench.parameters.push_back(std::move(parameter));
        }
        if (knobs.empty()) continue;
        study.effects.push_back(effect);
        study.knobs.push_back(std::move(knobs));
    }
}

Linearised aboutNominal(Study& study, const std::function<void(double, const std::string&)>& progress) {
    Linearised about = linearised(study.bench, study.bench.origin(), {.parameters = study.nuisances},
                                  [&](double share) { progress(share, "sensitivities to tolerances"); });
    expectDriven(study.bench, about);
    study.nominal = about.rows;
    for (const Eigen::MatrixXd& columns : about.columns)
        study.allowed.emplace_back(columns(Eigen::all, study.nuisances).rowwise().norm());
    study.uncertainty = uncertaintyOf(study.bench, study.bench.origin(), study.nominal);
    return about;
}

void expectDriven(const Bench& bench, const Linearised& about) {
    for (std::size_t d = 0; d < about.rows.size(); ++d) {
        if (about.rows[d].size() == 0)
            throw std::invalid_argument(
                fmt::format("recording {}: the nominal car cannot be driven so", bench.drives[d].name));
    }
}

std::vector<Eigen::Index> thatMatter(const Study& study, const Linearised& about) {
    std::vector<double> matter(study.nuisances.size(), 0);
    for (std::size_t d = 0; d < about.columns.size(); ++d) {
        const Eigen::MatrixXd columns = study.uncertainty.noise[d].over(about.columns[d](Eigen::all, study.nuisances));
        const Gram gram = whitened(driveGram(columns, study.uncertainty.directions[d]),
                                   study.uncertainty.sizesOf(d, study.uncertainty.sizes));
        for (std::size_t i = 0; i < matter.size(); ++i)
            matter[i] += 0.5 * gram.products(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i));
    }
    std::vector<Eigen::Index> kept;
    for (std::size_t i = 0; i < matter.size(); ++i)
        if (matter[i] > kNegligible) kept.push_back(study.nuisances[i]);
    return kept;
}

Linearised nuisancesAt(Study& study, const Deviation& at, const std::function<void(double)>& progress) {
    return linearised(
        study.bench, at,
        {.parameters = study.calibrated.nuisances, .worth = worthDriving(study), .elsewhere = &study.calibrated.about},
        progress);
}

Eigen::MatrixXd knobsAndResidual(const Study& study, const Linearised& about, const Rows& rows, std::size_t drive) {
    const std::vector<Eigen::Index> knobs = study.allKnobs();
    Eigen::MatrixXd all(rows[drive].size(), static_cast<Eigen::Index>(knobs.size()) + 1);
    all.leftCols(all.cols() - 1) = study.uncertainty.noise[drive].over(about.columns[drive](Eigen::all, knobs));
    all.rightCols(1) = residual(study.bench, study.uncertainty, rows, drive);
    return all;
}

std::vector<DriveGram> everything(const Study& study, const Ground& ground) {
    std::vector<DriveGram> grams;
    for (std::size_t d = 0; d < ground.grams.size(); ++d) {
        grams.push_back(extended(ground.grams[d], ground.columns[d], study.uncertainty.directions[d],
                                 knobsAndResidual(study, ground.about, ground.about.rows, d)));
    }
    return grams;
}

double leftOver(const Study& study, const Rows& rows) {
    double sum = 0, expected = 0;
    for (std::size_t d = 0; d < rows.size(); ++d) {
        sum += squaresOf(study.uncertainty, d, residual(study.bench, study.uncertainty, rows, d));
        expected += study.uncertainty.noise[d].expected;
    }
    return expected > 0 ? std::max(1.0, std::sqrt(sum / expected)) : 1;
}

std::array<double, kDisturbances> disturbanceSizes(const Study& study, const std::vector<DriveGram>& grams) {
    std::array<double, kDisturbances> logs{};
    std::vector<Eigen::Index> free(static_cast<std::size_t>(grams.front().columns.cols() - 1));
    std::iota(free.begin(), free.end(), 0);
    const auto sizes = [](const std::array<double, kDisturbances>& of) {
        std::array<double, kDisturbances> result{};
        for (std::size_t i = 0; i < of.size(); ++i) result[i] = std::exp(of[i]);
        return result;
    };
    // What is doubted is not taken back by smaller sizes.
    std::vector<DriveGram> plain = grams;
    for (std::size_t d = 0; d < plain.size(); ++d) {
        const double doubt = study.bench.drives[d].doubt();
        plain[d].columns *= doubt * doubt;
        plain[d].mixed *= doubt;
    }
    const auto merit = [&](const std::array<double, kDisturbances>& of) {
        double prior = 0;
        for (const double one : of) prior += 0.5 * one * one / (kSizeSpread * kSizeSpread);
        const Gram gram = total(plain, study.uncertainty, sizes(of));
        return logEvidence(gram, gram.products.cols() - 1, free) - prior;
    };
    double best = merit(logs), step = 0.6;
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        bool moved = false;
        for (double& one : logs) {
            for (const double by : {step, -step}) {
                const double before = one;
                if (std::abs(before + by) > std::log(kLargestFactor)) continue;
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
    return sizes(logs);
}

}  // namespace tread
