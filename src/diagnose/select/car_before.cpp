#include "diagnose/select/car_before.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string_view>

#include "diagnose/model/gap.h"
#include "diagnose/model/remainder.h"
#include "diagnose/select/fit.h"
#include "diagnose/settings.h"
#include "recording/reference.h"

namespace tread::diagnose::select {
namespace {

constexpr std::array<std::string_view, 4> kStructure{"tyre.", "tyre_surroundings.", "suspension.", "steering."};
// s, time over which an error of the model's structure lasts: of the rows within it, one counts.
constexpr double kErrorLasts = 1;
constexpr int kMostRounds = 2;   // fits, each about the point of the one before
constexpr double kSettled = 15;  // nats; a fit that gains less is the last

// True for numbers that no data sheet tells: of tyres, suspension, steering, driveline and brakes.
bool isOfTheStructure(const std::string& path) {
    if (path.ends_with(".Re") || path.ends_with(".Ro")) return false;
    return std::any_of(kStructure.begin(), kStructure.end(),
                       [&](std::string_view part) { return path.find(part) != std::string::npos; });
}

// The tolerances of the file. Numbers of the structure that an effect of the catalogue moves are besides known only to
// within its typical size.
std::vector<recording::KnownWithin> tolerancesWithEffects(const model::Subject& nominal,
                                                          const recording::DiagnosisFile& file,
                                                          const std::vector<catalogue::Effect>& effects) {
    std::map<std::string, double> variances;
    for (const model::Parameter& known : model::nuisances(nominal, file.tolerances))
        variances[known.path()] = std::pow(known.moves.front().by, 2);
    std::vector<recording::KnownWithin> all = file.tolerances;
    for (const catalogue::Effect& effect : effects) {
        for (const model::Parameter& knob : model::knobsOf(effect, nominal)) {
            if (knob.lowest == 0 || knob.highest == 0) continue;
            for (const model::Parameter::Move& move : knob.moves) {
                if (!isOfTheStructure(move.path)) continue;
                double& variance = variances[move.path] += move.by * move.by;
                all.push_back({.path = move.path, .relative = 0, .absolute = std::sqrt(3 * variance)});
            }
        }
    }
    return all;
}

model::Differences everything(const model::Subject& nominal, const recording::DiagnosisFile& file,
                              const std::vector<catalogue::Effect>& effects, model::Drives drives) {
    model::Differences all;
    all.parameters = model::nuisances(nominal, tolerancesWithEffects(nominal, file, effects));
    for (model::Parameter& one : model::nuisancesOfEachDrive(nominal, file.tolerances, drives))
        all.parameters.push_back(std::move(one));
    all.nuisances.resize(all.parameters.size());
    std::iota(all.nuisances.begin(), all.nuisances.end(), 0);
    return all;
}

// Tolerances of the file, and in their place for each fitted number: what the fit leaves open, and what changes from
// day to day (D45a).
std::vector<recording::KnownWithin> tolerancesAfter(const model::Subject& nominal, const recording::DiagnosisFile& file,
                                                    const std::map<std::string, answer::NuisanceEstimate>& moved) {
    std::map<std::string, double> between_days;  // standard deviations
    for (const model::Parameter& known : model::nuisances(nominal, file.tolerances, kSettings.between_days))
        between_days[known.path()] = known.moves.front().by;
    std::vector<recording::KnownWithin> all = file.tolerances;
    for (const auto& [path, estimate] : moved)
        all.push_back({path, 0, std::sqrt(3.0) * std::hypot(estimate.sd, between_days[path])});
    return all;
}

// Fits in turn with new linearisations.
std::optional<Fit> settledFit(const model::Problem& problem, const Progress& progress, answer::GapLevels& gap) {
    model::Deviation at = problem.replays.origin();
    std::optional<Fit> found;
    for (int round = 0; round < kMostRounds; ++round) {
        model::Sensitivities about = model::sensitivities(
            problem.replays, problem.drives, at, {.parameters = problem.nuisances},
            [&](double share) { progress((round + share) / kMostRounds, "fitting the car before the change"); });
        if (round == 0) model::expectDriven(problem.drives, about);
        model::Uncertainty uncertainty =
            model::uncertaintyAt(problem.replays, problem.drives, at, about.rows, model::endsOf(problem.drives));
        uncertainty.sizes = model::sizesAt(problem.drives, uncertainty, about.rows, problem.replays.threads);
        const model::Uncertainty plain = uncertainty;
        // The structure of the model is wrong: what it leaves is larger than noise, and lasts.
        const double ratio = model::birgeRatio(problem.drives, uncertainty, about.rows, uncertainty.sizes);
        for (model::RowNoise& noise : uncertainty.noise)
            noise.deviation *= ratio * std::sqrt(kErrorLasts / recording::kBlock);
        const std::vector<Eigen::Index> relevant = model::relevantNuisances(problem.nuisances, about, uncertainty);
        const Rows before = about.rows;
        const Linearisation linear = model::linearisation(std::move(about), relevant, uncertainty);
        std::optional<Fit> fit = fitted(problem.replays, problem.drives, uncertainty, linear, {}, at);
        if (!fit) break;
        if (round == 0) gap.nominal = levelOf(problem.drives, plain, before);
        gap.calibrated = levelOf(problem.drives, plain, fit->rows);
        at = fit->at;
        found = std::move(*fit);
        if (found->gained < kSettled) break;
    }
    return found;
}

}  // namespace

std::optional<CarBefore> carBefore(const model::Subject& nominal, const recording::DiagnosisFile& file,
                                   const recording::Recorded& recorded, const std::vector<catalogue::Effect>& effects,
                                   const Options& options, const Progress& progress) {
    recording::DiagnosisFile before = file;
    recording::Recorded logs = recorded;
    if (!recording::beforeTheChange(before, logs)) return std::nullopt;
    const model::Problem problem = model::problemOf(
        nominal, before, logs, [&](model::Drives drives) { return everything(nominal, file, effects, drives); },
        options);
    CarBefore result{nominal, {}, {}, {}};
    const std::optional<Fit> fit = settledFit(problem, progress, result.gap);
    if (!fit) return std::nullopt;
    for (Eigen::Index i = 0; i < std::ssize(fit->free); ++i) {
        const model::Parameter& parameter = problem.replays.parameters[fit->free[i]];
        const double units = fit->at(fit->free[i]), sd = std::sqrt(fit->covariance(i, i));
        if (parameter.only) continue;  // not of the car
        model::move(result.car, parameter, units);
        const model::Parameter::Move& one = parameter.moves.front();
        result.moved[one.path] = {one.nominal + units * one.by, sd * std::abs(one.by), units};
    }
    result.tolerances = tolerancesAfter(nominal, file, result.moved);
    return result;
}

}  // namespace tread::diagnose::select
