#include "diagnose/select/together.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "diagnose/model/remainder.h"
#include "diagnose/select/calibration.h"
#include "diagnose/settings.h"
#include "recording/sliding.h"

namespace tread::diagnose::select {
namespace {

constexpr std::array kTrials{-4.0, -2.0, -1.0, 1.0, 2.0, 4.0};  // typical sizes at which an effect is tried
constexpr double kWorth = 0.5;                                  // s of further drive that are worth a new linearisation
constexpr std::size_t kMostEffects = 3;  // effects that are fitted: those with the longest trials
constexpr int kMostParts = 3;            // fits of one effect, each to a longer part of the drives

struct TrialOfEffect {
    std::size_t effect;
    Deviation at;
    double time;  // s, sum over the drives
};

// s, until which each drive can be compared with the car at a point.
std::vector<double> endsAt(Drives drives, const Rows& rows) {
    std::vector<double> ends;
    for (std::size_t d = 0; d < drives.size(); ++d)
        ends.push_back(std::min({drives[d].until, recording::slideApart(drives[d], rows[d]), drives[d].duration()}));
    return ends;
}

double sumOf(const std::vector<double>& ends) {
    return std::accumulate(ends.begin(), ends.end(), 0.0);
}

// Drives that end because car and model slide apart.
std::vector<bool> cut(const Calibration& car) {
    std::vector<bool> those;
    for (std::size_t d = 0; d < car.drives().size(); ++d) {
        const recording::RecordedDrive& drive = car.drives()[d];
        those.push_back(car.uncertainty.until[d] < std::min(drive.until, drive.duration()));
    }
    return those;
}

std::vector<recording::RecordedDrive> cutDrives(const Calibration& car) {
    const std::vector<bool> those = cut(car);
    std::vector<recording::RecordedDrive> drives;
    for (std::size_t d = 0; d < those.size(); ++d)
        if (those[d]) drives.push_back(car.drives()[d]);
    return drives;
}

// The trial of an effect that keeps car and model together longest.
std::optional<TrialOfEffect> bestTrial(const Calibration& car, Drives cut, std::size_t effect) {
    std::optional<TrialOfEffect> best;
    for (const Eigen::Index knob : car.problem.knobs[effect]) {
        const Parameter& parameter = car.problem.replays.parameters[knob];
        for (const double size : kTrials) {
            Deviation at = car.fit.at;
            at(knob) = std::clamp(size, parameter.lowest, parameter.highest);
            const std::optional<Rows> rows = model::rowsAt(car.problem.replays, cut, at);
            if (!rows) continue;
            const double time = sumOf(endsAt(cut, *rows));
            if (!best || time > best->time) best = TrialOfEffect{effect, std::move(at), time};
        }
    }
    return best;
}

// Effects worth a fit, longest trial first.
std::vector<TrialOfEffect> trials(const Calibration& car) {
    const std::vector<recording::RecordedDrive> cut = cutDrives(car);
    std::vector<TrialOfEffect> worth;
    if (cut.empty()) return worth;
    const std::optional<Rows> here = model::rowsAt(car.problem.replays, cut, car.fit.at);
    if (!here) return worth;
    const double now = sumOf(endsAt(cut, *here));
    for (std::size_t e = 0; e < car.problem.effects.size(); ++e) {
        if (!car.problem.effects[e].at_limit) continue;
        std::optional<TrialOfEffect> best = bestTrial(car, cut, e);
        if (best && best->time > now + kWorth) worth.push_back(std::move(*best));
    }
    std::stable_sort(worth.begin(), worth.end(),
                     [](const TrialOfEffect& a, const TrialOfEffect& b) { return a.time > b.time; });
    if (worth.size() > kMostEffects) worth.resize(kMostEffects);
    return worth;
}

// Fits an effect, from the point of a trial, to all that is compared there. Drives that were not cut are told as about
// the car. Nothing when the fit slides away from the car sooner than the trial did, or explains no more than the car
// without the effect, which is asked of the first fit only.
std::optional<Fit> fitAt(const Calibration& car, const TrialOfEffect& trial, bool first) {
    const Problem& problem = car.problem;
    const Drives drives = problem.drives;
    const std::vector<Eigen::Index>& nuisances = car.about.nuisances;
    const std::vector<bool> renewed = cut(car);
    model::Sensitivities about = model::sensitivities(
        problem.replays, drives, trial.at,
        {.parameters = nuisances, .worth = model::onlyIn(renewed, nuisances.size()), .elsewhere = &car.about.about});
    if (std::any_of(about.rows.begin(), about.rows.end(), [](const Eigen::VectorXd& rows) { return rows.size() == 0; }))
        return std::nullopt;
    Uncertainty uncertainty = model::uncertaintyAt(problem.replays, drives, trial.at, about.rows, model::endsOf(drives),
                                                   &car.uncertainty, renewed);
    uncertainty.sizes = car.fit.sizes;
    const double time = sumOf(endsAt(drives, about.rows));
    const Linearisation here = model::linearisation(std::move(about), nuisances, problem.knobs[trial.effect],
                                                    uncertainty, problem.replays.threads);
    std::optional<Fit> with =
        fitted(problem.replays, drives, uncertainty, here, problem.knobs[trial.effect], {trial.at});
    if (!with || sumOf(endsAt(drives, with->rows)) < time - kWorth) return std::nullopt;
    if (first) {
        const std::optional<Fit> without = fitted(problem.replays, drives, uncertainty, here, {}, {car.fit.at});
        if (without && with->log_evidence < without->log_evidence + kSettings.effect) return std::nullopt;
    }
    return with;
}

// Fits an effect as long as its fit keeps car and model together for longer than the trial did.
std::optional<Fit> settled(const Calibration& car, TrialOfEffect trial) {
    std::optional<Fit> best;
    double time = 0;
    for (int round = 0; round < kMostParts; ++round) {
        std::optional<Fit> fit = fitAt(car, trial, round == 0);
        if (!fit) break;
        const double now = sumOf(endsAt(car.drives(), fit->rows));
        const bool longer = now > time + kWorth;
        time = now;
        trial.at = fit->at;
        best = std::move(fit);
        if (!longer) break;
    }
    return best;
}

}  // namespace

std::optional<Together> keptTogether(const Calibration& car) {
    std::optional<Fit> longest;
    std::map<std::size_t, Deviation> tried;
    double time = sumOf(endsAt(car.drives(), car.fit.rows)) + kWorth;
    for (const TrialOfEffect& trial : trials(car)) {
        std::optional<Fit> fit = settled(car, trial);
        if (!fit) continue;
        tried[trial.effect] = fit->at;
        const double now = sumOf(endsAt(car.drives(), fit->rows));
        if (now > time) time = now, longest = std::move(fit);
    }
    if (!longest) return std::nullopt;
    Together together{.at = longest->at, .further = {}, .tried = std::move(tried)};
    const std::vector<double> before = endsAt(car.drives(), car.fit.rows), after = endsAt(car.drives(), longest->rows);
    for (std::size_t d = 0; d < before.size(); ++d) together.further.push_back(after[d] > before[d]);
    return together;
}

}  // namespace tread::diagnose::select
