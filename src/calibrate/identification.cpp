#include "calibrate/identification.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "base/fields/numbers.h"
#include "base/text/number_text.h"
#include "base/text/pattern.h"
#include "base/yaml/session.h"
#include "calibrate/identification_text.h"
#include "diagnose/explain/how_far.h"
#include "diagnose/explain/where.h"
#include "recording/reference.h"

namespace tread::calibrate {
namespace {

namespace model = diagnose::model;
namespace select = diagnose::select;
namespace explain = diagnose::explain;
using model::Deviation;
using model::Parameter;
using model::Problem;
using model::Rows;
using recording::Subject;
using select::Fit;

constexpr int kRounds = 6;             // largest number of rounds of linearisation and fit
constexpr double kSettled = 0.1;       // prior standard deviations; the rounds end when no chosen number moves further
constexpr double kUndetermined = 0.9;  // posterior over prior standard deviation, from which a number is not determined
constexpr double kNearBound = 1e-6;    // units
const std::string kChosen = "fitted numbers";

bool isChosen(const recording::DiagnosisFile& file, const std::string& path) {
    return std::any_of(file.fit.begin(), file.fit.end(), [&](const std::string& one) { return matches(one, path); });
}

// Throws LoadError for requested numbers that cannot be fitted.
void judgeChoice(const recording::DiagnosisFile& file, const Subject& nominal,
                 const std::vector<Parameter>& uncertain) {
    std::vector<tread::Problem> problems;
    const auto add = [&](std::size_t i, std::string text) {
        problems.push_back({"", 0, 0, "fit." + std::to_string(i), std::move(text)});
    };
    if (file.fit.empty())
        problems.push_back(
            {"", 0, 0, "fit",
             "found no number to fit, expected paths such as front.tyre.lambda.Ky under fit or after --fit"});
    Subject subject = nominal;
    const std::vector<Number> all = numbers(subject);
    for (std::size_t i = 0; i < file.fit.size(); ++i) {
        const std::string& path = file.fit[i];
        if (std::none_of(all.begin(), all.end(), [&](const Number& n) { return matches(path, n.path); }))
            add(i, "found " + quote(path) +
                       ", expected a number that this car has; `tread describe vehicle` lists the paths");
        else if (std::none_of(uncertain.begin(), uncertain.end(),
                              [&](const Parameter& p) { return matches(path, p.path()); }))
            add(i, "found " + quote(path) + ", expected a number with a tolerance; add one under tolerances: {path: " +
                       path + ", absolute: ...}");
    }
    throwIfAny(std::move(problems));
}

// The chosen numbers become the knobs of a single effect; all other tolerances are nuisances.
model::Differences differencesOf(const recording::DiagnosisFile& file, const Subject& nominal, model::Drives drives) {
    model::Differences all;
    all.parameters = model::nuisances(nominal, file.tolerances);
    judgeChoice(file, nominal, all.parameters);
    for (Parameter& one : model::nuisancesOfTheWind(nominal, file.tolerances, drives))
        all.parameters.push_back(std::move(one));
    all.effects = {diagnose::catalogue::Effect{.name = kChosen, .question = {}, .source = {}, .knobs = {}}};
    all.knobs.resize(1);
    for (Eigen::Index i = 0; i < std::ssize(all.parameters); ++i)
        (!all.parameters[i].only && isChosen(file, all.parameters[i].path()) ? all.knobs[0] : all.nuisances)
            .push_back(i);
    return all;
}

// A fit with its linearisation. Noise and disturbances are multiplied by the Birge ratio, so that a model with
// structural errors is not forced onto what it cannot explain. While the car is still far off, this keeps the fit near
// the prior.
struct Round {
    model::Uncertainty uncertainty;            // about the point of the linearisation
    model::Uncertainty larger;                 // the same with noise times the Birge ratio, used in the fit
    model::Linearisation about, about_larger;  // whitened with `uncertainty` and with `larger`
    double birge_ratio = 1;
    Fit fit;
};

// Everything except the fit. `relevant`: nuisances to use; null: they are selected here.
Round roundAt(const Problem& problem, model::Sensitivities about, std::vector<double> until,
              const std::vector<Eigen::Index>* relevant) {
    const int threads = problem.replays.threads;
    Round round;
    round.uncertainty = model::uncertaintyAt(problem.replays, problem.drives, about.at, about.rows, std::move(until));
    const std::vector<Eigen::Index> kept =
        relevant ? *relevant : model::relevantNuisances(problem.nuisances, about, round.uncertainty, threads);
    round.about = model::linearisation(about, kept, problem.allKnobs(), round.uncertainty, threads);
    round.uncertainty.sizes = select::sizesWithAllFree(
        problem, round.uncertainty, model::productsWithResidual(problem.drives, round.about, round.uncertainty));
    round.birge_ratio = model::birgeRatio(problem.drives, round.uncertainty, about.rows, round.uncertainty.sizes);
    round.larger = round.uncertainty;
    for (model::RowNoise& noise : round.larger.noise) noise.deviation *= round.birge_ratio;
    round.about_larger = model::linearisation(std::move(about), kept, problem.allKnobs(), round.larger, threads);
    return round;
}

// The last round, and the nominal car of the first.
struct Settled {
    Round round;
    Rows nominal;  // rows of the nominal car
    bool settled = false;
};

// Alternates fits and linearisations about them until the chosen numbers hardly move.
std::optional<Settled> settled(const Problem& problem, const diagnose::Progress& progress) {
    const std::vector<Eigen::Index>& knobs = problem.knobs[0];
    std::vector<Eigen::Index> wanted = model::joined(problem.nuisances, knobs), relevant;
    std::vector<double> until = model::endsOf(problem.drives);
    std::optional<Settled> result;
    Deviation at = problem.replays.origin();
    Rows nominal;
    for (int i = 0; i < kRounds; ++i) {
        model::Sensitivities about =
            model::sensitivities(problem.replays, problem.drives, at, {.parameters = wanted},
                                 [&](double share) { progress((i + share) / kRounds, "sensitivities"); });
        if (i == 0) model::expectDriven(problem.drives, about);
        else if (std::any_of(about.rows.begin(), about.rows.end(), [](const auto& r) { return r.size() == 0; })) break;
        if (i == 0) nominal = about.rows;
        Round round = roundAt(problem, std::move(about), until, i == 0 ? nullptr : &relevant);
        until = round.uncertainty.until;
        relevant = round.about.nuisances;
        if (i == 0) wanted = model::joined(relevant, knobs);
        std::optional<Fit> fit =
            select::fitted(problem.replays, problem.drives, round.larger, round.about_larger, knobs, {at});
        if (!fit) break;
        const double moved = (fit->at - at)(knobs).cwiseAbs().maxCoeff();
        at = fit->at;
        round.fit = std::move(*fit);
        result = Settled{std::move(round), nominal, i > 0 && moved < kSettled};
        if (result->settled) break;
    }
    return result;
}

FittedNumber numberOf(const Parameter& parameter, double units, double sd) {
    const Parameter::Move& one = parameter.moves.front();
    const double low = one.nominal + parameter.lowest * one.by, high = one.nominal + parameter.highest * one.by;
    return {.path = one.path,
            .value = one.nominal + units * one.by,
            .sd = sd * std::abs(one.by),
            .nominal = one.nominal,
            .prior_sd = std::abs(one.by),
            .lowest = std::min(low, high),
            .highest = std::max(low, high),
            .z = units,
            .at_bound = units < parameter.lowest + kNearBound || units > parameter.highest - kNearBound,
            .determined = sd < kUndetermined};
}

void tellNumbers(Identification& found, const Problem& problem, const Fit& fit) {
    for (Eigen::Index i = 0; i < std::ssize(fit.free); ++i) {
        const Parameter& parameter = problem.replays.parameters[fit.free[i]];
        const double units = fit.at(fit.free[i]), sd = std::sqrt(fit.covariance(i, i));
        if (i < fit.nuisances())
            found.gap.nuisance[parameter.name()] = diagnose::select::numberOf(fit, problem.replays, i);
        else found.numbers.push_back(numberOf(parameter, units, sd));
    }
}

// Correlations, condition and least determined mixture of the numbers (D52).
void tellShape(Identification& found, const Problem& problem, const Round& round) {
    const Fit& fit = round.fit;
    const Eigen::Index knobs = std::ssize(found.numbers), nuisances = fit.nuisances();
    const Eigen::MatrixXd left = fit.covariance.bottomRightCorner(knobs, knobs);
    for (Eigen::Index i = 0; i < knobs; ++i) {
        std::vector<double> row;
        for (Eigen::Index j = 0; j < knobs; ++j) row.push_back(left(i, j) / std::sqrt(left(i, i) * left(j, j)));
        found.correlation.push_back(std::move(row));
    }
    const model::NormalEquations sum =
        model::normalEquations(round.larger, fit.products, round.larger.sizes, problem.replays.threads);
    const Eigen::MatrixXd seen = inference::withoutFirst(sum, nuisances).products.topLeftCorner(knobs, knobs);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> shape(seen);
    const double least = shape.eigenvalues()(0), most = shape.eigenvalues()(knobs - 1);
    found.condition = least > 0 ? most / least : kInfinity;
    for (Eigen::Index i = 0; i < knobs; ++i) found.weakest[found.numbers[i].path] = shape.eigenvectors()(i, 0);
}

// Stages of the gap: the nominal car, the chosen numbers alone, and all fitted numbers.
void tellGap(Identification& found, const Problem& problem, Settled settled) {
    Round& round = settled.round;
    Deviation alone = problem.replays.origin();
    for (const Eigen::Index k : round.fit.knobs) alone(k) = round.fit.at(k);
    select::Calibration car{
        problem, std::move(settled.nominal), {}, std::move(round.uncertainty), std::move(round.about), {}, {}};
    car.fit.at = problem.replays.origin();
    found.gap.causes = {kChosen};
    found.gap.where = explain::whereItLies(car, explain::missingForce(car));
    explain::howFar(found.gap, car, select::heldOut(car), {alone, round.fit});
}

}  // namespace

Identification identificationOf(const Subject& nominal, recording::DiagnosisFile file, recording::Recorded recorded,
                                const diagnose::Options& options) {
    const auto started = std::chrono::steady_clock::now();
    Identification found;
    found.of_references = recording::beforeTheChange(file, recorded);
    const Problem problem = model::problemOf(
        nominal, file, recorded, [&](model::Drives drives) { return differencesOf(file, nominal, drives); }, options);
    std::optional<Settled> result = settled(problem, diagnose::partOf(options.progress, 0, 0.9));
    if (!result)
        throw SimulationError(
            "the simulation of the nominal car in the recordings fails; check the vehicle file and the recorded inputs",
            0);

    found.converged = result->settled;
    found.birge_ratio = result->round.birge_ratio;
    tellNumbers(found, problem, result->round.fit);
    tellShape(found, problem, result->round);
    tellGap(found, problem, std::move(*result));
    const diagnose::answer::HowFar& how_far = found.gap.how_far;
    found.better = how_far.in_sample ? how_far.training.calibrated < how_far.training.nominal
                                     : how_far.held_out.calibrated < how_far.held_out.nominal;
    options.progress(1, "done");
    found.gap.simulations = problem.replays.simulations.value();
    found.gap.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    found.answer = found.gap.answer = identificationInWords(found);
    return found;
}

}  // namespace tread::calibrate
