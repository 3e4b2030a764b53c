#include "diagnose/select/fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/threads/parallel.h"
#include "diagnose/model/remainder.h"
#include "inference/bounded_step.h"

namespace tread::diagnose::select {
namespace {

// Trial steps of a fit, and those after which the columns of the knobs are computed again at the latest.
constexpr int kMostTrials = 14, kTrialsBeforeRenewal = 6;
// Distance from the calibrated car, units, from which a fit that goes on starts with columns of the knobs at its point.
constexpr double kFarFromCalibrated = 0.5;
// Trial steps before a fit may stop early, and times the gain of its linear model, or of the last change of its sizes,
// that it may still make.
constexpr int kTrialsBeforeStopping = 2;
constexpr double kOptimism = 3;
constexpr double kEnough = 0.2;  // nats; the fit has converged when the next step promises less
// A response is rough to within a few nats, since wheels lock and shifts come at instants. A fit also ends after two
// failed steps in succession that promise less than this.
constexpr double kRough = 2;
constexpr int kMostFailed = 2;
constexpr double kFirstDamping = 1;          // least damping after a failed step, in units of the prior's information
constexpr double kDamped = 5, kEased = 0.2;  // factors on the damping after a poor and after a good step
constexpr double kPoor = 0.1, kGood = 0.5;   // shares of what a step promised
constexpr double kTooShort = 1e-6;  // squared units; a shorter step would amplify rounding errors in Broyden's update

// Information of the prior of an effect's size where it takes no part: a standard deviation of 20 typical sizes, so
// that what the data do not determine stays bounded.
constexpr double kLeastPrior = 1.0 / 400;

// Times that sizes and point are fitted in turn, steps towards the sizes in each, and the change of the logarithm of a
// size below which they have settled.
constexpr int kMostTurns = 6, kSizeStepsOfTurn = 3;
constexpr double kTurnSettled = 0.1;

// Gives the imperfections of a fit other sizes; the rows stay. Returns the factors on its columns and the residual.
Eigen::VectorXd scaled(Fit& fit, const Replays& replays, const model::Imperfection& sizes) {
    const Eigen::Index all = std::ssize(fit.free);
    Eigen::VectorXd factors = Eigen::VectorXd::Ones(all + 1);
    for (Eigen::Index i = 0; i < std::ssize(fit.imperfections); ++i) {
        const Eigen::Index knob = replays.parameters[fit.imperfections[i]].imperfection_of;
        const auto part = static_cast<std::size_t>(model::partOf(replays.parameters[knob].path()));
        factors(fit.numbers() + i) = sizes[part] / fit.imperfection[part];
    }
    fit.imperfection = sizes;
    if (fit.imperfections.empty()) return factors;
    fit.at(fit.free).array() /= factors.head(all).array();
    for (std::size_t d = 0; d < fit.columns.size(); ++d) {
        fit.columns[d] = (fit.columns[d] * factors.head(all).asDiagonal()).eval();
        inference::scaleColumns(fit.products[d], factors);
    }
    return factors;
}

// A fit on its way, with the products of its columns beside the remainder of its sizes.
struct Moving {
    Fit fit;
    std::vector<inference::MarginalProducts> marginal;  // per drive
    double damping = 0;
};

// The problem of one fit, apart from the point.
struct Fitter {
    const Replays& replays;
    Drives drives;
    const Uncertainty& uncertainty;
    std::vector<Eigen::Index> knobs, free, imperfections;
    std::vector<Eigen::Index> places;              // of `free` in the linearisation
    inference::Bounds bounds;                      // of `free`
    std::vector<model::Part> parts;                // of each imperfection
    std::vector<Eigen::MatrixXd> by_imperfection;  // per drive: change of the rows per typical size

    // Marginalises the remainder of the present sizes.
    void marginalise(Moving& now) const {
        std::vector<std::optional<inference::MarginalProducts>> all(drives.size());
        inParallel(drives.size(), replays.threads, [&](std::size_t d) {
            const DriveProducts& products = now.fit.products[d];
            all[d].emplace(products, inference::metricOf(products.disturbances, uncertainty.sizesOf(d, now.fit.sizes)));
        });
        now.marginal.clear();
        for (auto& one : all) now.marginal.push_back(std::move(*one));
    }

    std::size_t part(Eigen::Index i) const { return static_cast<std::size_t>(parts[i]); }
    Eigen::VectorXd each(const model::Imperfection& sizes) const {
        Eigen::VectorXd all(std::ssize(imperfections));
        for (Eigen::Index i = 0; i < all.size(); ++i) all(i) = sizes[part(i)];
        return all;
    }

    // Rows of the model with its imperfections (D16b).
    Rows imperfect(Rows rows, const Deviation& at, const model::Imperfection& sizes) const {
        const Eigen::VectorXd by = each(sizes).cwiseProduct(at(imperfections));
        for (std::size_t d = 0; d < rows.size(); ++d) rows[d] += by_imperfection[d] * by;
        return rows;
    }

    // Gives the imperfections other sizes; the rows stay.
    void scale(Moving& now, const model::Imperfection& sizes) const {
        const Eigen::VectorXd factors = scaled(now.fit, replays, sizes);
        for (inference::MarginalProducts& one : now.marginal) one.scaleColumns(factors);
    }

    // Negative log posterior of a point, up to constants (D20). `squares`: of what it leaves, of each drive.
    double misfit(const Moving& now, const std::vector<double>& squares, const Deviation& at) const {
        double sum = at(free).squaredNorm();
        if (now.fit.prior == SizePrior::none) sum -= (1 - kLeastPrior) * at(knobs).squaredNorm();
        return 0.5 * std::accumulate(squares.begin(), squares.end(), sum);
    }

    // Squares that the fit leaves at its point: among its products.
    static std::vector<double> squaresOf(const Moving& now) {
        std::vector<double> squares;
        for (const inference::MarginalProducts& one : now.marginal)
            squares.push_back(one.equations().products.bottomRightCorner(1, 1).value());
        return squares;
    }

    std::vector<double> squaresOf(const Moving& now, const Rows& rows) const {
        std::vector<double> squares(rows.size());
        inParallel(rows.size(), replays.threads, [&](std::size_t d) {
            const Eigen::VectorXd left = model::residual(drives, uncertainty, rows, d);
            squares[d] =
                inference::squaresIn(now.marginal[d].metric(), left, uncertainty.directions[d].transpose() * left);
        });
        return squares;
    }

    // Computes the columns of the knobs again by finite differences.
    void renewKnobs(Moving& now) const {
        Fit& fit = now.fit;
        const Renewed renewed = columnsToRenew(fit.numbers());
        const std::vector<Eigen::MatrixXd> of_knobs =
            model::columnsAt(replays, drives, fit.at, renewed.knobs, model::kEffectStep);
        const std::vector<Eigen::MatrixXd> of_nuisances =
            model::columnsAt(replays, drives, fit.at, renewed.nuisances, model::kNuisanceStep);
        const std::vector<Eigen::Index> all = placesOf(model::joined(renewed.nuisances, knobs));
        inParallel(drives.size(), replays.threads, [&](std::size_t d) {
            Eigen::MatrixXd& columns = fit.columns[d];
            columns(Eigen::all, placesOf(renewed.knobs)) = uncertainty.noise[d].over(of_knobs[d]);
            columns(Eigen::all, placesOf(renewed.nuisances)) = uncertainty.noise[d].over(of_nuisances[d]);
            for (const Mixed& one : renewed.mixed) {
                auto column = columns.col(placeOf(one.knob));
                column.setZero();
                for (const model::Share& share : one.shares) column += share.units * columns.col(placeOf(share.of));
            }
            inference::replaceColumns(fit.products[d], columns, model::residual(drives, uncertainty, fit.rows, d), all,
                                      uncertainty.directions[d]);
            now.marginal[d].replaceColumns(fit.products[d], all);
        });
    }

    // A knob that only mixes nuisances.
    struct Mixed {
        Eigen::Index knob;
        std::vector<model::Share> shares;
    };
    struct Renewed {
        std::vector<Eigen::Index> knobs, nuisances;
        std::vector<Mixed> mixed;
    };

    // Columns of knobs that only mix nuisances follow from the columns of these, which are renewed instead: the data
    // cannot tell the one from the others. `numbers`: of the nuisances that are numbers, the first of `free`.
    Renewed columnsToRenew(Eigen::Index numbers) const {
        const std::vector<Eigen::Index> nuisances(free.begin(), free.begin() + numbers);
        Renewed renewed;
        for (const Eigen::Index knob : knobs) {
            std::vector<model::Share> shares = model::mixture(replays.parameters[knob], replays.parameters, nuisances);
            for (const model::Share& share : shares) renewed.nuisances.push_back(share.of);
            if (shares.empty()) renewed.knobs.push_back(knob);
            else renewed.mixed.push_back({knob, std::move(shares)});
        }
        std::sort(renewed.nuisances.begin(), renewed.nuisances.end());
        const auto end = std::unique(renewed.nuisances.begin(), renewed.nuisances.end());
        renewed.nuisances.erase(end, renewed.nuisances.end());
        return renewed;
    }

    std::vector<Eigen::Index> placesOf(const std::vector<Eigen::Index>& parameters) const {
        std::vector<Eigen::Index> all;
        for (const Eigen::Index parameter : parameters) all.push_back(placeOf(parameter));
        return all;
    }

    Eigen::Index placeOf(Eigen::Index parameter) const {
        return std::find(free.begin(), free.end(), parameter) - free.begin();
    }

    // Broyden's update: corrects the columns along a step by the change of rows that it caused (D19).
    void learn(Moving& now, const Rows& after, Eigen::VectorXd step) const {
        Fit& fit = now.fit;
        step.segment(fit.numbers(), std::ssize(imperfections)).setZero();  // the model is linear in these
        if (step.squaredNorm() < kTooShort) return;
        inParallel(drives.size(), replays.threads, [&](std::size_t d) {
            const Eigen::VectorXd change = uncertainty.noise[d].over(after[d] - fit.of_car[d]);
            const Eigen::VectorXd by = (change - fit.columns[d] * step) / step.squaredNorm();
            const inference::ColumnProducts products = inference::productsOfColumn(
                by, fit.columns[d], model::residual(drives, uncertainty, fit.rows, d), uncertainty.directions[d]);
            inference::updateByRankOne(fit.products[d], products, step);
            now.marginal[d].updateByRankOne(products, step);
            fit.columns[d] += by * step.transpose();
        });
    }

    void moveTo(Moving& now, const Deviation& at, Rows of_car) const {
        Fit& fit = now.fit;
        fit.at = at, fit.of_car = std::move(of_car);
        fit.rows = imperfect(fit.of_car, at, fit.imperfection);
        inParallel(drives.size(), replays.threads, [&](std::size_t d) {
            const Eigen::VectorXd left = model::residual(drives, uncertainty, fit.rows, d);
            const inference::ColumnProducts products =
                inference::productsOfColumn(left, fit.columns[d], left, uncertainty.directions[d]);
            inference::replaceLast(fit.products[d], products);
            now.marginal[d].replaceLast(products);
        });
    }
};

Fitter fitterOf(const Replays& replays, Drives drives, const Uncertainty& uncertainty,
                const Linearisation& linearisation, const std::vector<Eigen::Index>& imperfections,
                const std::vector<Eigen::Index>& knobs) {
    Fitter fitter{replays, drives, uncertainty, knobs, {}, {}, {}, {}, {}, {}};
    std::vector<Eigen::Index> moving;  // knobs along which the model is imperfect
    for (const Eigen::Index i : imperfections) {
        const Eigen::Index knob = replays.parameters[i].imperfection_of;
        if (std::find(knobs.begin(), knobs.end(), knob) != knobs.end()) continue;
        fitter.imperfections.push_back(i), moving.push_back(knob);
        fitter.parts.push_back(model::partOf(replays.parameters[knob].path()));
    }
    for (const Eigen::MatrixXd& columns : linearisation.about.columns)
        fitter.by_imperfection.emplace_back(columns(Eigen::all, moving));
    fitter.free = model::joined(model::joined(linearisation.nuisances, fitter.imperfections), knobs);
    fitter.bounds = model::boundsOf(replays.parameters, fitter.free);
    for (const Eigen::Index column : model::joined(model::joined(linearisation.nuisances, moving), knobs)) {
        const auto place = std::find(linearisation.parameters.begin(), linearisation.parameters.end(), column);
        fitter.places.push_back(place - linearisation.parameters.begin());
    }
    return fitter;
}

// `sum`: of the products of all drives beside their remainder.
inference::QuadraticModel quadraticOf(const Fit& fit, const model::NormalEquations& sum) {
    const Eigen::Index knobs = std::ssize(fit.knobs);
    inference::QuadraticModel model = inference::quadraticModel(sum, fit.at(fit.free));
    if (fit.prior == SizePrior::none && knobs > 0) {
        // Takes the prior of the knobs out of what the model adds to information and gradient.
        model.information.diagonal().tail(knobs).array() -= 1 - kLeastPrior;
        model.gradient.tail(knobs) += (1 - kLeastPrior) * model.at.tail(knobs);
    }
    return model;
}

inference::QuadraticModel quadraticOf(const Moving& now) {
    model::NormalEquations sum;
    for (const inference::MarginalProducts& one : now.marginal) sum = std::move(sum) + one.equations();
    return quadraticOf(now.fit, sum);
}

// What a step promised and what it gained, nats.
struct Trial {
    double promised, gained;
};

// Tries the next step of a fit, if it promises enough, and goes there if the misfit falls. The columns learn from it.
Trial tryStep(Moving& now, const Fitter& fitter) {
    Fit& fit = now.fit;
    const inference::QuadraticModel here = quadraticOf(now);
    const Eigen::VectorXd step = inference::boundedStep(here, now.damping, fitter.bounds);
    const double promised = inference::gainOf(here, step);
    if (promised < kEnough) return {promised, 0};
    const double before = fitter.misfit(now, Fitter::squaresOf(now), fit.at);
    Deviation next = fit.at;
    next(fit.free) = here.at + step;
    std::optional<Rows> there = model::rowsAt(fitter.replays, fitter.drives, next);
    if (there) fitter.learn(now, *there, step);
    const auto squaresThere = [&] { return fitter.squaresOf(now, fitter.imperfect(*there, next, fit.imperfection)); };
    const double after = there ? fitter.misfit(now, squaresThere(), next) : kInfinity;
    const double gained = before - after;
    if (gained > 0) fitter.moveTo(now, next, std::move(*there)), fit.gained += gained;
    if (gained > kGood * promised) now.damping *= kEased;
    else if (gained <= kPoor * promised) now.damping = std::max(kFirstDamping, kDamped * now.damping);
    return {promised, gained};
}

// Tells when a fit has converged.
class Convergence {
public:
    bool reachedBy(const Trial& trial) {
        failed_ = trial.gained < kEnough && trial.promised < kRough ? failed_ + 1 : 0;
        return trial.promised < kEnough || failed_ == kMostFailed;
    }

private:
    int failed_ = 0;
};

double logEvidenceOf(const Fit& fit, const inference::QuadraticModel& here) {
    return inference::logEvidence(here, Eigen::VectorXd::Zero(std::ssize(fit.free))) +
           model::logPrior(fit.sizes, model::kWidePrior) + model::logPrior(fit.imperfection);
}

// Whether the fit stays below this ln Z even if it gains several times what its linear model promises.
bool staysBelow(double least, const Moving& now, const Fitter& fitter) {
    if (least == -kInfinity) return false;
    const inference::QuadraticModel here = quadraticOf(now);
    const double promised = inference::gainOf(here, inference::boundedStep(here, 0, fitter.bounds));
    return logEvidenceOf(now.fit, here) + kOptimism * promised < least;
}

// Moves the fit to the maximum of the posterior with its sizes: updates point, rows, columns and products. False when
// it stopped early because with these sizes it would stay below `least`.
bool climb(Moving& now, const Fitter& fitter, bool renewed, double least) {
    Convergence convergence;
    for (int trial = 0; trial < kMostTrials; ++trial) {
        const bool hopeless = trial >= kTrialsBeforeStopping && staysBelow(least, now, fitter);
        if (hopeless && renewed) return false;
        const bool due = !renewed && (hopeless || trial == kTrialsBeforeRenewal);
        now.fit.converged = !due && convergence.reachedBy(tryStep(now, fitter));
        if (now.fit.converged && renewed) break;
        if (!now.fit.converged && !due) continue;
        fitter.renewKnobs(now);
        renewed = true, now.damping = 0, convergence = {};
    }
    return true;
}

// Sizes of the imperfections closer to the largest evidence (D26b).
model::Imperfection improved(const Fit& fit, const Fitter& fitter, const inference::QuadraticModel& here) {
    const Eigen::Index all = std::ssize(fit.free);
    const Eigen::MatrixXd covariance =
        inference::factorOfPriorAnd(here.information).solve(Eigen::MatrixXd::Identity(all, all));
    model::ImperfectionsLeft left;
    for (Eigen::Index i = 0; i < std::ssize(fit.imperfections); ++i) {
        const Eigen::Index place = fit.numbers() + i;
        const std::size_t part = fitter.part(i);
        left.squares[part] += here.at(place) * here.at(place);
        left.determined[part] += 1 - covariance(place, place);
        left.present[part] = true;
    }
    return model::improved(fit.imperfection, left);
}

// Moves the imperfections of a fit to their best point beside its numbers. The model is linear in them.
void moveImperfections(Moving& now, const Fitter& fitter) {
    const inference::QuadraticModel here = quadraticOf(now);
    const Eigen::Index first = now.fit.numbers(), n = std::ssize(now.fit.imperfections);
    const Eigen::VectorXd gradient = (here.gradient - here.at).segment(first, n);
    Deviation at = now.fit.at;
    at(now.fit.imperfections) +=
        inference::factorOfPriorAnd(here.information.block(first, first, n, n)).solve(gradient);
    fitter.moveTo(now, at, std::move(now.fit.of_car));
}

// Moves the sizes of the imperfections towards the largest evidence. True when they have settled.
bool resizeImperfections(Moving& now, const Fitter& fitter) {
    if (now.fit.imperfections.empty()) return true;
    const model::Imperfection before = now.fit.imperfection;
    for (int i = 0; i < kSizeStepsOfTurn; ++i) {
        const model::Imperfection last = now.fit.imperfection;
        fitter.scale(now, improved(now.fit, fitter, quadraticOf(now)));
        moveImperfections(now, fitter);
        if (model::changeOf(last, now.fit.imperfection) < kTurnSettled) break;
    }
    return model::changeOf(before, now.fit.imperfection) < kTurnSettled;
}

// Moves the sizes towards what the fit leaves at its point. True when they have settled.
bool resize(Moving& now, const Fitter& fitter) {
    const Sizes before = now.fit.sizes;
    const bool settled = resizeImperfections(now, fitter);
    for (int i = 0; i < kSizeStepsOfTurn; ++i) {
        const Sizes last = now.fit.sizes;
        now.fit.sizes =
            model::improvedSizes(last, model::leftBy(fitter.uncertainty, now.marginal, fitter.replays.threads));
        fitter.marginalise(now);
        if (model::changeOf(last, now.fit.sizes) < kTurnSettled) break;
    }
    return settled && model::changeOf(before, now.fit.sizes) < kTurnSettled;
}

// The model at the start of a fit, with the columns and products of the linearisation.
Moving startOf(const Fitter& fitter, const Linearisation& linearisation, const Start& start, Rows rows, SizePrior prior,
               Remainder remainder) {
    Moving now;
    Fit& fit = now.fit;
    fit.free = fitter.free, fit.knobs = fitter.knobs, fit.imperfections = fitter.imperfections;
    fit.imperfection = start.imperfection;
    fit.at = start.at;
    for (const Eigen::Index i : linearisation.imperfections)
        if (std::find(fit.imperfections.begin(), fit.imperfections.end(), i) == fit.imperfections.end()) fit.at(i) = 0;
    fit.of_car = std::move(rows);
    fit.rows = fitter.imperfect(fit.of_car, fit.at, fit.imperfection);
    fit.sizes = start.sizes.value_or(fitter.uncertainty.sizes), fit.prior = prior;
    if (remainder == Remainder::usual) fit.sizes.fill(1);
    Eigen::VectorXd factors = Eigen::VectorXd::Ones(std::ssize(fit.free));
    factors.segment(fit.numbers(), std::ssize(fit.imperfections)) = fitter.each(fit.imperfection);
    fit.columns.resize(fitter.drives.size()), fit.products.resize(fitter.drives.size());
    inParallel(fitter.drives.size(), fitter.replays.threads, [&](std::size_t d) {
        fit.columns[d] = linearisation.columns[d](Eigen::all, fitter.places) * factors.asDiagonal();
        fit.products[d] = inference::extended(inference::selected(linearisation.products[d], fitter.places, factors),
                                              fit.columns[d], fitter.uncertainty.directions[d],
                                              model::residual(fitter.drives, fitter.uncertainty, fit.rows, d));
    });
    fitter.marginalise(now);
    return now;
}

// The fit with covariance and evidence at its point.
Fit evaluated(Moving now) {
    const inference::QuadraticModel here = quadraticOf(now);
    const Eigen::Index n = std::ssize(now.fit.free);
    now.fit.covariance = inference::factorOfPriorAnd(here.information).solve(Eigen::MatrixXd::Identity(n, n));
    now.fit.log_evidence = logEvidenceOf(now.fit, here);
    return std::move(now.fit);
}

// Whether the columns of the knobs at the calibrated car are wrong for a fit that goes on from another one.
bool goesOnFarAway(const Start& start, const std::vector<Eigen::Index>& knobs) {
    double squares = 0;
    for (const Eigen::Index knob : knobs) squares += start.at(knob) * start.at(knob);
    return start.is_end && squares > kFarFromCalibrated * kFarFromCalibrated;
}

}  // namespace

Start anew(const Fit& fit) {
    Start start = endOf(fit);
    for (Eigen::Index i = 0; i < fit.nuisances(); ++i) start.at(fit.free[i]) = 0;
    return start;
}

Deviation drawn(const Replays& replays, const Fit& fit, Random& random) {
    Eigen::VectorXd normal(fit.covariance.rows());
    for (double& one : normal) one = random.normal();
    Deviation point = fit.at;
    point(fit.free) += fit.covariance.llt().matrixL() * normal;
    for (const Eigen::Index i : fit.free) {
        const model::Parameter& parameter = replays.parameters[i];
        point(i) = std::clamp(point(i), parameter.lowest, parameter.highest);
    }
    return point;
}

Fit withUsualImperfections(Fit fit, const Replays& replays) {
    scaled(fit, replays, model::usualImperfection());
    return fit;
}

answer::NuisanceEstimate numberOf(const Fit& fit, const Replays& replays, Eigen::Index i) {
    constexpr double kNear = 1e-6;  // units
    const Eigen::Index p = fit.free[i];
    const model::Parameter& parameter = replays.parameters[p];
    const model::Parameter::Move& first = parameter.moves.front();
    const auto [nominal, change] =
        parameter.quantity.empty() ? std::pair(first.nominal, first.by) : std::pair(0.0, parameter.quantity_by);
    const double units = fit.at(p), by = std::abs(change);
    return {.value = nominal + units * change,
            .sd = std::sqrt(fit.covariance(i, i)) * by,
            .nominal = nominal,
            .prior_sd = by,
            .z = units,
            .at_bound = units < parameter.lowest + kNear || units > parameter.highest - kNear};
}

inference::QuadraticModel quadraticAt(const Fit& fit, const Uncertainty& uncertainty) {
    return quadraticOf(fit, model::normalEquations(uncertainty, fit.products, fit.sizes, 1));
}

DriveProducts productsBeside(const Fit& fit, const Uncertainty& uncertainty, std::size_t drive,
                             const Eigen::MatrixXd& further) {
    return inference::extended(inference::firstColumns(fit.products[drive], std::ssize(fit.free)), fit.columns[drive],
                               uncertainty.directions[drive], further);
}

std::optional<Fit> fitted(const Replays& replays, Drives drives, const Uncertainty& uncertainty,
                          const Linearisation& linearisation, const std::vector<Eigen::Index>& knobs,
                          const Start& start, SizePrior prior, Remainder remainder) {
    std::optional<Rows> rows = model::rowsAt(replays, drives, start.at);
    if (!rows) return std::nullopt;
    const std::vector<Eigen::Index> imperfections =
        remainder == Remainder::estimated ? linearisation.imperfections : std::vector<Eigen::Index>{};
    const Fitter fitter = fitterOf(replays, drives, uncertainty, linearisation, imperfections, knobs);
    Moving now = startOf(fitter, linearisation, start, std::move(*rows), prior, remainder);
    if (goesOnFarAway(start, knobs)) fitter.renewKnobs(now);
    bool on_its_way = climb(now, fitter, knobs.empty(), start.least);
    for (int turn = 0; turn < kMostTurns && remainder == Remainder::estimated; ++turn) {
        const double before = logEvidenceOf(now.fit, quadraticOf(now));
        if (resize(now, fitter)) break;
        const double gained = logEvidenceOf(now.fit, quadraticOf(now)) - before;
        if (!on_its_way && staysBelow(start.least - kOptimism * gained, now, fitter)) break;
        on_its_way = climb(now, fitter, true, start.least);
    }
    return evaluated(std::move(now));
}

Fit withColumnsOfItsPoint(const Replays& replays, Drives drives, const Uncertainty& uncertainty,
                          const Linearisation& here, const Fit& fit) {
    const Fitter fitter = fitterOf(replays, drives, uncertainty, here, here.imperfections, fit.knobs);
    Moving now = startOf(fitter, here, endOf(fit), fit.of_car, fit.prior, Remainder::estimated);
    now.fit.gained = fit.gained, now.fit.converged = fit.converged;
    fitter.renewKnobs(now);
    return evaluated(std::move(now));
}

}  // namespace tread::diagnose::select
