#include "diagnose/identification.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "base/number_text.h"
#include "base/numbers.h"
#include "base/pattern.h"
#include "base/yaml_session.h"
#include "diagnose/how_far.h"
#include "diagnose/identification_text.h"
#include "diagnose/reference.h"
#include "diagnose/where.h"

namespace tread {
namespace {

constexpr int kRounds = 6;             // of fitting and linearising at the fit
constexpr double kSettled = 0.1;       // prior standard deviations that a round moved the numbers
constexpr double kUndetermined = 0.9;  // of the prior's standard deviation that the drives leave
constexpr double kNearBound = 1e-6;    // units
const std::string kChosen = "fitted numbers";

using Progress = std::function<void(double, const std::string&)>;

bool isChosen(const DiagnosisFile& file, const std::string& path) {
    return std::any_of(file.fit.begin(), file.fit.end(), [&](const std::string& one) { return matches(one, path); });
}

// What is asked for and cannot be fitted.
void judgeChoice(const DiagnosisFile& file, const Subject& nominal, const std::vector<Parameter>& uncertain) {
    std::vector<Problem> problems;
    const auto add = [&](std::size_t i, std::string text) {
        problems.push_back({"", 0, 0, "fit." + std::to_string(i), std::move(text)});
    };
    if (file.fit.empty())
        problems.push_back({"", 0, 0, "fit", "found no number to fit, expected paths, e.g. front.tyre.lambda.Ky"});
    Subject subject = nominal;
    const std::vector<Number> all = numbers(subject);
    for (std::size_t i = 0; i < file.fit.size(); ++i) {
        const std::string& path = file.fit[i];
        if (std::none_of(all.begin(), all.end(), [&](const Number& n) { return matches(path, n.path); }))
            add(i, "found " + quote(path) + ", a number that this car does not have");
        else if (std::none_of(uncertain.begin(), uncertain.end(),
                              [&](const Parameter& p) { return matches(path, p.name()); }))
            add(i, "found " + quote(path) +
                       ", of which nothing says how well it is known; say it under tolerances: {path: " + path +
                       ", absolute: ...}");
    }
    throwIfAny(std::move(problems));
}

// The chosen numbers are the knobs of the only effect; all other tolerances are nuisances.
void addParameters(Study& study, const DiagnosisFile& file) {
    Bench& bench = study.bench;
    bench.parameters = nuisances(bench.nominal, file.tolerances);
    judgeChoice(file, bench.nominal, bench.parameters);
    study.effects = {Effect{.name = kChosen, .question = {}, .source = {}, .knobs = {}}};
    study.knobs.resize(1);
    for (std::size_t i = 0; i < bench.parameters.size(); ++i) {
        const bool chosen = isChosen(file, bench.parameters[i].name());
        (chosen ? study.knobs[0] : study.nuisances).push_back(static_cast<Eigen::Index>(i));
    }
}

// The study about a point: what is uncertain there, and the sensitivities made ready for a fit. So that a model that
// cannot be right is not forced onto what it cannot explain, all that is uncertain in the recordings is taken as larger
// by as much as it leaves; while the car is still far off, that keeps the fit near what is known before.
struct Round {
    Uncertainty uncertainty;  // larger by `left_over` than the study's
    Ground ground;
    double left_over = 1;
};
Round roundAt(Study& study, Linearised about, const std::vector<Eigen::Index>* matter) {
    study.uncertainty = uncertaintyOf(study.bench, about.at, about.rows);
    const std::vector<Eigen::Index> kept = matter ? *matter : thatMatter(study, about);
    study.calibrated = ground(about, kept, study.uncertainty);
    study.uncertainty.sizes = disturbanceSizes(study, everything(study, study.calibrated));
    Round round{study.uncertainty, {}, leftOver(study, about.rows)};
    for (RowNoise& noise : round.uncertainty.noise) noise.deviation *= round.left_over;
    round.ground = ground(std::move(about), kept, round.uncertainty);
    return round;
}

struct Settled {
    Fit fit;
    Round round;
    bool settled = false;
};

std::vector<Eigen::Index> together(const std::vector<Eigen::Index>& some, const std::vector<Eigen::Index>& more) {
    std::vector<Eigen::Index> all;
    all.reserve(some.size() + more.size());
    for (const auto* list : {&some, &more})
        for (const Eigen::Index one : *list) all.push_back(one);
    return all;
}

// Fits, and looks at all sensitivities anew where the fit is, until it stays.
std::optional<Settled> settled(Study& study, const Progress& progress) {
    const std::vector<Eigen::Index>& knobs = study.knobs[0];
    Wanted wanted{.parameters = together(study.nuisances, knobs)};
    std::optional<Settled> result;
    Deviation at = study.bench.origin();
    for (int i = 0; i < kRounds; ++i) {
        Linearised about = linearised(study.bench, at, wanted,
                                      [&](double share) { progress((i + share) / kRounds, "sensitivities"); });
        if (i == 0) expectDriven(study.bench, about);
        else if (std::any_of(about.rows.begin(), about.rows.end(), [](const auto& r) { return r.size() == 0; })) break;
        if (i == 0) study.nominal = about.rows;
        Round round = roundAt(study, std::move(about), i == 0 ? nullptr : &study.calibrated.nuisances);
        if (i == 0) wanted.parameters = together(round.ground.nuisances, knobs);
        std::optional<Fit> fit = fitted(study.bench, round.uncertainty, round.ground, knobs, at);
        if (!fit) break;
        const double moved = (fit->at - at)(knobs).cwiseAbs().maxCoeff();
        at = fit->at;
        result = Settled{std::move(*fit), std::move(round), i > 0 && moved < kSettled};
        if (result->settled) break;
    }
    return result;
}

void tellNumbers(Identification& found, const Study& study, const Fit& fit) {
    const auto n = static_cast<Eigen::Index>(fit.free.size()), first = n - static_cast<Eigen::Index>(fit.knobs.size());
    for (Eigen::Index i = 0; i < n; ++i) {
        const Eigen::Index p = fit.free[static_cast<std::size_t>(i)];
        const Parameter& parameter = study.bench.parameters[static_cast<std::size_t>(p)];
        const Parameter::Move& one = parameter.moves.front();
        const double units = fit.at(p), sd = std::sqrt(fit.covariance(i, i));
        if (i < first) {
            found.gap.nuisance[one.path] = {one.nominal + units * one.by, sd * std::abs(one.by), units};
            continue;
        }
        const double low = one.nominal + parameter.lowest * one.by, high = one.nominal + parameter.highest * one.by;
        found.numbers.push_back(
            {.path = one.path,
             .value = one.nominal + units * one.by,
             .sd = sd * std::abs(one.by),
             .nominal = one.nominal,
             .prior_sd = std::abs(one.by),
             .lowest = std::min(low, high),
             .highest = std::max(low, high),
             .z = units,
             .at_bound = units < parameter.lowest + kNearBound || units > parameter.highest - kNearBound,
             .determined = sd < kUndetermined});
    }
}

// How the numbers hang together.
void tellShape(Identification& found, const Gram& gram, const Eigen::MatrixXd& covariance) {
    const auto knobs = static_cast<Eigen::Index>(found.numbers.size()), nuisances = covariance.cols() - knobs;
    const Eigen::MatrixXd left = covariance.bottomRightCorner(knobs, knobs);
    for (Eigen::Index i = 0; i < knobs; ++i) {
        std::vector<double> row;
        for (Eigen::Index j = 0; j < knobs; ++j) row.push_back(left(i, j) / std::sqrt(left(i, i) * left(j, j)));
        found.correlation.push_back(std::move(row));
    }
    std::vector<Eigen::Index> out(static_cast<std::size_t>(nuisances));
    std::iota(out.begin(), out.end(), 0);
    const Eigen::MatrixXd seen = marginalised(gram, out).products.block(nuisances, nuisances, knobs, knobs);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> shape(seen);
    const double least = shape.eigenvalues()(0), most = shape.eigenvalues()(knobs - 1);
    found.condition = least > 0 ? most / least : kInfinity;
    for (Eigen::Index i = 0; i < knobs; ++i)
        found.weakest[found.numbers[static_cast<std::size_t>(i)].path] = shape.eigenvectors()(i, 0);
}

// The stages of the gap: a diagnosis whose only effect is the chosen numbers, and which knows nothing besides.
void tellGap(Identification& found, Study& study, Fit fit, std::vector<RecordedDrive> held_out) {
    Fit alone = fit;
    alone.at = study.bench.origin();
    for (const Eigen::Index k : fit.knobs) alone.at(k) = fit.at(k);
    if (std::optional<Rows> rows = rowsAt(study.bench, alone.at)) alone.rows = std::move(*rows);
    Search search;
    search.candidates.push_back({.effects = {0}, .fit = std::move(fit), .fitted = true});
    search.candidates.push_back({.effects = {}, .fit = std::move(alone), .fitted = true});
    found.gap.causes = {kChosen};
    found.gap.where = whereItLies(study, missingForce(study));
    howFar(found.gap, study, search, std::move(held_out));
}

}  // namespace

Identification identify(const Subject& nominal, DiagnosisFile file, Recorded recorded, const DiagnoseOptions& options) {
    const auto started = std::chrono::steady_clock::now();
    Identification found;
    found.of_references = beforeTheChange(file, recorded);
    Study study;
    begin(study.bench, nominal, file, recorded, options);
    std::vector<RecordedDrive> held_out = drivesOf(study.bench, file, recorded, true);
    addParameters(study, file);
    std::optional<Settled> result =
        settled(study, [&](double done, const std::string& what) { options.progress(0.9 * done, what); });
    if (!result) throw SimulationError("the nominal car cannot be driven in the recordings", 0);

    found.converged = result->settled;
    found.left_over = result->round.left_over;
    const Gram gram = total(result->fit.grams, result->round.uncertainty, result->round.uncertainty.sizes);
    tellNumbers(found, study, result->fit);
    tellShape(found, gram, result->fit.covariance);
    tellGap(found, study, std::move(result->fit), std::move(held_out));
    const HowFar& how_far = found.gap.how_far;
    found.better = how_far.in_sample ? how_far.training.calibrated < how_far.training.nominal
                                     : how_far.held_out.calibrated < how_far.held_out.nominal;
    options.progress(1, "done");
    found.gap.simulations = study.bench.simulations;
    found.gap.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    found.answer = found.gap.answer = identificationInWords(found);
    return found;
}

}  // namespace tread
