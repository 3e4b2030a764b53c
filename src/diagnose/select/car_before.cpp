#include "diagnose/select/car_before.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string_view>

#include "diagnose/model/gap.h"
#include "diagnose/model/remainder.h"
#include "diagnose/select/fit.h"
#include "diagnose/select/left_out.h"
#include "diagnose/settings.h"
#include "recording/reference.h"

namespace tread::diagnose::select {
namespace {

constexpr std::array<std::string_view, 4> kStructure{"tyre.", "tyre_surroundings.", "suspension.", "steering."};
constexpr int kMostFitsBefore = 4;     // fits, each about the point of the one before
constexpr double kBeforeSettled = 15;  // nats; a fit that gains less is the last ...
constexpr double kLowers = 0.7;        // ... unless it lowers the Birge ratio by this factor, and with it the noise
constexpr double kOpen = 0.5;          // share of its standard deviation that a fit leaves of a number that stays open

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
    for (model::Parameter& one : model::nuisancesOfTheWind(nominal, file.tolerances, drives))
        all.parameters.push_back(std::move(one));
    all.nuisances.resize(all.parameters.size());
    std::iota(all.nuisances.begin(), all.nuisances.end(), 0);
    return all;
}

// Numbers of the tyres that the fit leaves at least half as uncertain as they were.
std::vector<recording::KnownWithin> leftOpen(const std::map<std::string, answer::NuisanceEstimate>& moved) {
    std::vector<recording::KnownWithin> open;
    for (const auto& [path, estimate] : moved)
        if (path.find(".tyre.") != std::string::npos && isOfTheStructure(path) &&
            estimate.sd > kOpen * estimate.prior_sd)
            open.push_back({path, 0, std::sqrt(3.0) * estimate.sd});
    return open;
}

// Root of the squared error with which the other drives predict one, beyond noise, over its squared motion: the change
// of each channel since the start (D45b). `uncertainty`: that of the fit; `noise`: its noise in units of that of the
// recordings. A prediction that is worse than the nominal car predicts nothing.
double shareNotPredicted(const model::Problem& problem, const model::Uncertainty& uncertainty, double noise,
                         const Fit& fit, const Rows& nominal) {
    const model::Drives drives = problem.drives;
    const std::vector<Eigen::VectorXd> off =
        residualsLeftOut(drives, uncertainty, problem.replays.parameters, fit, problem.replays.threads);
    double left = 0, moved = 0;
    for (std::size_t d = 0; d < off.size(); ++d) {
        Eigen::VectorXd motion = drives[d].measured;
        for (const recording::ObservedChannel& channel : drives[d].channels) {
            const double start = motion(channel.first_row);
            motion.segment(channel.first_row, channel.rows()).array() -= start;
        }
        const double of_nominal = model::residual(drives, uncertainty, nominal, d).squaredNorm();
        const double of_noise = uncertainty.noise[d].expected / (noise * noise);
        left += std::min(off[d].squaredNorm(), of_nominal) - of_noise;
        moved += uncertainty.noise[d].over(motion).squaredNorm();
    }
    return moved > 0 ? std::sqrt(std::max(0.0, left) / moved) : 0;
}

// Fits in turn with new linearisations.
std::optional<Fit> settledFit(const model::Problem& problem, const Progress& progress, CarBefore& told) {
    answer::GapLevels& gap = told.gap;
    model::Deviation at = problem.replays.origin();
    std::optional<Fit> found;
    std::optional<model::Uncertainty> last;
    std::optional<Linearisation> linear;
    Rows nominal;
    for (int round = 0; round < kMostFitsBefore; ++round) {
        const auto tell = [&](double share) {
            progress((round + share) / kMostFitsBefore, "fitting the car before the change");
        };
        model::Sensitivities about =
            linear ? model::nuisancesAt(problem.replays, problem.drives, at, nullptr, *linear, *last, tell)
                   : model::sensitivities(problem.replays, problem.drives, at, {.parameters = problem.nuisances}, tell);
        if (round == 0) model::expectDriven(problem.drives, about);
        model::Uncertainty uncertainty =
            model::uncertaintyAt(problem.replays, problem.drives, at, about.rows, model::endsOf(problem.drives),
                                 round > 1 ? &*last : nullptr);
        uncertainty.sizes = model::sizesAt(problem.drives, uncertainty, about.rows, problem.replays.threads);
        const model::Uncertainty plain = uncertainty;
        // The structure of the model is wrong: what it leaves is larger than noise, and lasts.
        const double ratio = model::birgeRatio(problem.drives, uncertainty, about.rows, uncertainty.sizes);
        const double larger = ratio * std::sqrt(kErrorLasts / recording::kBlock);
        for (model::RowNoise& noise : uncertainty.noise) noise.deviation *= larger;
        const std::vector<Eigen::Index> relevant =
            linear ? linear->nuisances
                   : model::relevantNuisances(problem.nuisances, about, uncertainty, problem.replays.threads);
        const Rows before = about.rows;
        linear = model::linearisation(std::move(about), relevant, {}, uncertainty, problem.replays.threads);
        std::optional<Fit> fit = fitted(problem.replays, problem.drives, uncertainty, *linear, {}, {at});
        last = std::move(uncertainty);
        if (!fit) break;
        if (round == 0) gap.nominal = levelOf(problem.drives, plain, before), nominal = before;
        gap.calibrated = levelOf(problem.drives, plain, fit->rows);
        told.structure_error = shareNotPredicted(problem, *last, larger, *fit, nominal);
        at = fit->at;
        found = std::move(*fit);
        const double left = model::birgeRatio(problem.drives, plain, found->rows, plain.sizes);
        if (found->gained < kBeforeSettled && left > kLowers * ratio) break;
    }
    return found;
}

}  // namespace

std::vector<recording::KnownWithin> tolerancesAfter(const model::Subject& nominal, const recording::DiagnosisFile& file,
                                                    const std::map<std::string, answer::NuisanceEstimate>& moved) {
    const auto tolerances = [&](double same) {
        std::map<std::string, double> of;
        for (const model::Parameter& known : model::nuisances(nominal, file.tolerances, same))
            of[known.path()] = std::sqrt(3.0) * known.moves.front().by;
        return of;
    };
    std::map<std::string, double> whole = tolerances(1), between_days = tolerances(kSettings.between_days);
    std::vector<recording::KnownWithin> all = file.tolerances;
    for (const auto& [path, estimate] : moved) {
        const bool beyond = std::abs(estimate.z) > std::sqrt(3.0);
        const double by = beyond ? std::abs(estimate.value - estimate.nominal) : 0;
        if (!file.before.empty())
            all.push_back(
                {path, 0,
                 std::hypot(std::sqrt(3.0) * estimate.sd, std::max(between_days[path], kSettings.between_days * by))});
        else if (by > whole[path]) all.push_back({path, 0, by});
    }
    return all;
}

std::optional<CarBefore> carBefore(const model::Subject& nominal, const recording::DiagnosisFile& file,
                                   const recording::Recorded& recorded, const std::vector<catalogue::Effect>& effects,
                                   const Options& options, const Progress& progress) {
    recording::DiagnosisFile before = file;
    recording::Recorded logs = recorded;
    if (!recording::beforeTheChange(before, logs)) return std::nullopt;
    // What is held out is the car after the change: all references tell what it was before.
    for (recording::Recording& one : before.recordings) one.hold_out = false;
    const model::Problem problem = model::problemOf(
        nominal, before, logs, [&](model::Drives drives) { return everything(nominal, file, effects, drives); },
        options);
    CarBefore result{.car = nominal, .moved = {}, .gap = {}, .tolerances = {}};
    const std::optional<Fit> fit = settledFit(problem, progress, result);
    if (!fit) return std::nullopt;
    for (Eigen::Index i = 0; i < std::ssize(fit->free); ++i) {
        const Eigen::Index p = fit->free[i];
        const model::Parameter& parameter = problem.replays.parameters[p];
        if (parameter.only || parameter.of_the_day) continue;  // not of the car
        model::move(result.car, parameter, fit->at(p));
        result.moved[parameter.path()] = numberOf(*fit, problem.replays, i);
    }
    result.left_open = leftOpen(result.moved);
    result.tolerances = tolerancesAfter(nominal, file, result.moved);
    return result;
}

}  // namespace tread::diagnose::select
