// Fits of a car that is linear in its numbers, against the closed form in the full covariance of all rows.
#include "diagnose/select/fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "diagnose/diagnose.h"
#include "diagnose/select/search.h"
#include "diagnose/settings.h"
#include "inference/bounded_step.h"
#include "shared/linear_car.h"

namespace tread::diagnose_fit_test {
namespace {

using diagnose::catalogue::Direction;
using diagnose::catalogue::Effect;
using diagnose::model::Disturbed;
using diagnose::model::Imperfection;
using diagnose::model::nominalCar;
using diagnose::model::Part;
using diagnose::model::Problem;
using diagnose::model::problemOf;
using diagnose::model::Sizes;
using diagnose::select::calibrate;
using diagnose::select::Calibration;
using diagnose::select::Candidate;
using diagnose::select::Fit;
using diagnose::select::fitted;
using diagnose::select::screen;
using diagnose::select::search;
using diagnose::select::Search;
using diagnose::select::SizePrior;
using linear_car::kMisread;
using simple_car::effect;

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

const diagnose::Progress kQuiet = [](double, const std::string&) {};

constexpr double kStartSpeed = 0.1;  // m/s, of what is not known of the speed at the start

constexpr double kOfReadings = 0.5;  // prior standard deviation of the logarithm of the size of errors of readings

// Nats: a fit has converged when the next step promises less. In most of these cases, the last step promises less than
// the second number.
constexpr double kEnds = 0.2, kLastStep = 0.05;

// The parameters of the problem: wheelbase (a nuisance), ratio, drag, and the model's imperfections along the last two.
constexpr Index kWheelbase = 0, kRatio = 1, kDrag = 2, kKnobs = 2;

Problem problemOfTwo(const simple_car::Case& made, Direction of_drag = Direction::either) {
    Effect drag = effect("drag", "aero.drag_area");
    drag.knobs.front().direction = of_drag;
    return problemOf(made.nominal, made.file, made.recorded, {effect("ratio", "steering.ratio"), drag},
                     linear_car::options());
}

// Free parameters of a fit that are numbers of the car.
std::vector<Index> numbersOf(const Fit& fit) {
    std::vector<Index> free(fit.free.begin(), fit.free.begin() + fit.numbers());
    return diagnose::model::joined(free, fit.knobs);
}

// Their covariance.
MatrixXd covarianceOfNumbers(const Fit& fit) {
    std::vector<Index> places;
    for (Index i = 0; i < std::ssize(fit.free); ++i)
        if (i < fit.numbers() || i >= fit.nuisances()) places.push_back(i);
    return fit.covariance(places, places);
}

// All rows of the drives over their noise: what is measured beyond the nominal car, its sensitivities in units of the
// priors, and the covariance of noise, of the speed at the start and of the errors of the gyro's readings.
struct Dense {
    VectorXd residual;
    MatrixXd columns, covariance;
    std::array<MatrixXd, kMisread.size()> misread;

    Dense(const Calibration& car, const VehicleParams& nominal) {
        Index rows = 0;
        for (const auto& drive : car.drives()) rows += drive.rows();
        residual.resize(rows), columns.resize(rows, 3);
        misread.fill(MatrixXd::Zero(rows, rows));
        MatrixXd starts = MatrixXd::Zero(rows, std::ssize(car.drives()));
        Index first = 0;
        for (std::size_t d = 0; d < car.drives().size(); ++d) {
            const recording::RecordedDrive& drive = car.drives()[d];
            const auto over = [&](const VectorXd& plain) {
                return linear_car::weighted(drive, car.uncertainty.noise[d], plain);
            };
            residual.segment(first, drive.rows()) = over(drive.measured - linear_car::nominalRows(drive, nominal));
            const auto put = [&](auto column, double by, linear_car::Wave wave) {
                column.segment(first, drive.rows()) = by * over(linear_car::rowsOf(drive, wave));
            };
            put(columns.col(kWheelbase), 0.02 * nominal.wheelbase / std::sqrt(3), linear_car::ofWheelbase);
            put(columns.col(kRatio), 0.1 * nominal.steering.ratio, linear_car::ofRatio);
            put(columns.col(kDrag), 0.1 * nominal.aero.drag_area, linear_car::ofDrag);
            put(starts.col(d), kStartSpeed * nominal.steering.play, linear_car::ofSpeed);
            const auto here = linear_car::misread(drive, car.uncertainty.noise[d], car.about.about.rows[d]);
            for (std::size_t i = 0; i < here.size(); ++i)
                misread[i].block(first, first, drive.rows(), drive.rows()) = here[i];
            first += drive.rows();
        }
        covariance = MatrixXd::Identity(rows, rows) + starts * starts.transpose();
    }

    // The same with errors of readings and imperfections of these sizes: those of the fit along each of its knobs that
    // does not move.
    Dense with(const Sizes& sizes, const Imperfection& imperfection, const Fit& fit) const {
        Dense all = *this;
        for (std::size_t i = 0; i < misread.size(); ++i)
            all.covariance += std::pow(sizes[placeOf(kMisread[i])], 2) * misread[i];
        for (const Index i : fit.imperfections) {
            const Index knob = i - kKnobs;
            const double size = imperfection[static_cast<std::size_t>(knob == kRatio ? Part::steering : Part::body)];
            all.covariance += size * size * columns.col(knob) * columns.col(knob).transpose();
        }
        return all;
    }
    Dense as(const Fit& fit) const { return with(fit.sizes, fit.imperfection, fit); }
    static double ofPrior(double size, double spread = 1) { return -0.5 * std::pow(std::log(size) / spread, 2); }
    static double ofPriors(const Fit& fit) { return ofPriors(fit.sizes) + ofPriors(fit.imperfection); }
    static double ofPriors(const Sizes& sizes) {
        double sum = 0;
        for (const Disturbed kind : kMisread) sum += ofPrior(sizes[placeOf(kind)], kOfReadings);
        return sum;
    }
    // About a common size, and this about the usual one; the likeliest common size, found by trying.
    static double ofPriors(const Imperfection& sizes) {
        double most = -kInfinity;
        for (double log_common = -3; log_common < 3; log_common += 1e-4) {
            double sum = ofPrior(std::exp(log_common), diagnose::kSettings.imperfection_spread);
            for (const double size : sizes)
                sum += ofPrior(size / (diagnose::kSettings.imperfection * std::exp(log_common)),
                               diagnose::kSettings.part_spread);
            most = std::max(most, sum);
        }
        return most;
    }

    MatrixXd posterior(const std::vector<Index>& free) const {
        const MatrixXd some = columns(Eigen::all, free);
        const MatrixXd information = some.transpose() * covariance.inverse() * some;
        return (MatrixXd::Identity(std::ssize(free), std::ssize(free)) + information).inverse();
    }
    VectorXd best(const std::vector<Index>& free) const {
        return posterior(free) * columns(Eigen::all, free).transpose() * covariance.inverse() * residual;
    }
    double logEvidence(const std::vector<Index>& free) const {
        const MatrixXd some = columns(Eigen::all, free), all = covariance + some * some.transpose();
        const Eigen::LLT<MatrixXd> factor(all);
        return -0.5 * residual.dot(factor.solve(residual)) - MatrixXd(factor.matrixL()).diagonal().array().log().sum();
    }
};

simple_car::Case someCase(double ratio, double drag, std::uint64_t seed = 3) {
    VehicleParams truth = linear_car::nominal();
    truth.steering.play = 1;
    truth.steering.ratio *= ratio;
    truth.aero.drag_area *= drag;
    truth.wheelbase *= 1.01;
    return linear_car::recorded(truth, seed);
}

void expectSame(const VectorXd& found, const VectorXd& expected, double within) {
    ASSERT_EQ(found.size(), expected.size());
    EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), within) << found.transpose() << "; " << expected.transpose();
}

// As near to the best point as a fit goes once the errors of readings have their last sizes.
void expectNear(const VectorXd& found, const VectorXd& best, const MatrixXd& posterior) {
    ASSERT_EQ(found.size(), best.size());
    const VectorXd off = found - best;
    EXPECT_LT(0.5 * off.dot(posterior.llt().solve(off)), kEnds) << found.transpose() << "; " << best.transpose();
}

TEST(Fit, OfALinearCarIsRidgeRegressionInTheFullCovariance) {
    const simple_car::Case made = someCase(0.96, 1.06);
    const Problem problem = problemOfTwo(made);
    const Calibration car = calibrate(problem, nominalCar(problem, kQuiet), kQuiet);
    ASSERT_EQ(car.about.nuisances, std::vector<Index>{kWheelbase});
    const Dense steady(car, made.nominal.vehicle);
    for (const std::vector<Index>& knobs : {std::vector<Index>{}, {kRatio}, {kDrag}, {kRatio, kDrag}}) {
        const std::optional<Fit> fit =
            fitted(problem.replays, problem.drives, car.uncertainty, car.about, knobs, {problem.replays.origin()});
        ASSERT_TRUE(fit);
        EXPECT_TRUE(fit->converged);
        const std::vector<Index> free = diagnose::model::joined({kWheelbase}, knobs);
        EXPECT_EQ(numbersOf(*fit), free);
        EXPECT_EQ(fit->imperfections.size() + knobs.size(), kKnobs) << "along each knob that does not move";
        const Dense dense = steady.as(*fit);
        expectNear(fit->at(free), dense.best(free), dense.posterior(free));
        expectSame(covarianceOfNumbers(*fit).reshaped(), dense.posterior(free).reshaped(), 1e-8);
        EXPECT_NEAR(fit->log_evidence, dense.logEvidence(free) + Dense::ofPriors(*fit), kLastStep);
    }
}

// The linear car with a number that acts the more the further it is from the nominal one.
double curved(double number, double nominal) {
    const double off = number / nominal - 1;
    return nominal * (1 + off + 5 * off * std::abs(off));
}
void driveCurvedRatio(const VehicleParams& car, const Scenario& scenario, const Recorder& recorder,
                      const Pushing& pushing) {
    VehicleParams acting = car;
    acting.steering.ratio = curved(car.steering.ratio, linear_car::nominal().steering.ratio);
    linear_car::drive(acting, scenario, recorder, pushing);
}
void driveCurvedWheelbase(const VehicleParams& car, const Scenario& scenario, const Recorder& recorder,
                          const Pushing& pushing) {
    VehicleParams acting = car;
    acting.wheelbase = curved(car.wheelbase, linear_car::nominal().wheelbase);
    linear_car::drive(acting, scenario, recorder, pushing);
}

// Drives of such a car that is not nominal, and the calibrated car, for one effect.
struct CurvedCar {
    simple_car::Case made;
    Problem problem;
    Calibration car;

    CurvedCar(double ratio, double wheelbase, const recording::Simulate& simulate, const Effect& one)
        : made(linear_car::recorded(truth(ratio, wheelbase), 3, simulate)),
          problem(problemOf(made.nominal, made.file, made.recorded, {one}, optionsWith(simulate))),
          car(calibrate(problem, nominalCar(problem, kQuiet), kQuiet)) {}
    CurvedCar(const CurvedCar&) = delete;  // the parts refer to each other
    CurvedCar& operator=(const CurvedCar&) = delete;

    static VehicleParams truth(double ratio, double wheelbase) {
        VehicleParams truth = linear_car::nominal();
        truth.steering.play = 1;
        truth.steering.ratio *= ratio, truth.wheelbase *= wheelbase;
        return truth;
    }
    static diagnose::Options optionsWith(const recording::Simulate& simulate) {
        diagnose::Options options = linear_car::options();
        options.simulate = simulate;
        return options;
    }
    std::optional<Fit> fittedFrom(const diagnose::select::Start& start) const {
        return fitted(problem.replays, problem.drives, car.uncertainty, car.about, problem.knobs[0], start);
    }
};

// Where the columns of the calibrated car are wrong by now, no steps are tried with them.
TEST(Fit, ThatGoesOnFarFromTheCalibratedCarUsesColumnsOfItsOwnPoint) {
    const CurvedCar curved_car(0.8, 1, driveCurvedRatio, effect("ratio", "steering.ratio"));
    const Problem& problem = curved_car.problem;
    const std::optional<Fit> first = curved_car.fittedFrom({problem.replays.origin()});
    ASSERT_TRUE(first);
    ASSERT_GT(std::abs(first->at(kRatio)), 1);
    const auto simulationsFrom = [&](const diagnose::select::Start& start) {
        const int before = problem.replays.simulations.value();
        const std::optional<Fit> again = curved_car.fittedFrom(start);
        EXPECT_TRUE(again);
        EXPECT_NEAR(again->at(kRatio), first->at(kRatio), 0.05);
        return problem.replays.simulations.value() - before;
    };
    diagnose::select::Start with_other_nuisances = endOf(*first);
    with_other_nuisances.at(kWheelbase) += 2;
    with_other_nuisances.at(kRatio) *= 0.8;
    diagnose::select::Start not_an_end = with_other_nuisances;
    not_an_end.is_end = false;
    EXPECT_LT(simulationsFrom(with_other_nuisances), simulationsFrom(not_an_end));
}

TEST(Fit, ThatWillNotReachTheLeastEvidenceStopsEarlyAndOtherwiseItIsTheSame) {
    const CurvedCar curved_car(0.7, 1, driveCurvedRatio, effect("ratio", "steering.ratio"));
    const Problem& problem = curved_car.problem;
    const auto fittedFor = [&](double least) {
        const int before = problem.replays.simulations.value();
        std::optional<Fit> fit = curved_car.fittedFrom({.at = problem.replays.origin(), .least = least});
        return std::pair(fit.value(), problem.replays.simulations.value() - before);
    };
    const auto [whole, simulations] = fittedFor(-kInfinity);
    const auto [reached, as_many] = fittedFor(whole.log_evidence - 1);
    EXPECT_EQ(reached.at, whole.at);
    EXPECT_EQ(reached.log_evidence, whole.log_evidence);
    EXPECT_EQ(as_many, simulations);
    const auto [stopped, fewer] = fittedFor(1e9);
    EXPECT_LT(fewer, simulations);
    EXPECT_LT(stopped.log_evidence, whole.log_evidence);
    EXPECT_FALSE(stopped.converged);
}

TEST(Fit, WithColumnsOfItsPointHasTheCovarianceOfThese) {
    const simple_car::Case made = someCase(0.96, 1.06);
    const Problem problem = problemOfTwo(made);
    const Calibration car = calibrate(problem, nominalCar(problem, kQuiet), kQuiet);
    Fit fit =
        fitted(problem.replays, problem.drives, car.uncertainty, car.about, {kRatio, kDrag}, {problem.replays.origin()})
            .value();
    const VectorXd at = fit.at;
    for (MatrixXd& columns : fit.columns) columns *= 1.5;
    fit.covariance /= 2.25;
    fit = withColumnsOfItsPoint(problem.replays, problem.drives, car.uncertainty, car.about, fit);
    EXPECT_EQ(fit.at, at);
    const Dense dense = Dense(car, made.nominal.vehicle).as(fit);
    const std::vector<Index> free{kWheelbase, kRatio, kDrag};
    expectSame(covarianceOfNumbers(fit).reshaped(), dense.posterior(free).reshaped(), 1e-8);
    EXPECT_NEAR(fit.log_evidence, dense.logEvidence(free) + Dense::ofPriors(fit), kLastStep);
}

// A wheelbase that differs and one that is not known exactly do the same: however clearly the drives show their sum,
// they leave the difference to the priors. The response is curved, and the step of the two differs.
TEST(Fit, ColumnOfAnEffectThatMovesAnUncertainNumberIsThatOfThisNumber) {
    const CurvedCar curved_car(1, 1.2, driveCurvedWheelbase, effect("wheelbase", "wheelbase"));
    const Problem& problem = curved_car.problem;
    const Calibration& car = curved_car.car;
    constexpr Index kOther = 1;
    const Fit fit = curved_car.fittedFrom({problem.replays.origin()}).value();
    const Fit again =
        withColumnsOfItsPoint(problem.replays, problem.drives, car.uncertainty, *linearisedAt(car, fit), fit);
    ASSERT_EQ(again.free, (std::vector<Index>{kWheelbase, kOther}));
    const double times =
        problem.replays.parameters[kOther].moves.front().by / problem.replays.parameters[kWheelbase].moves.front().by;
    for (const MatrixXd& columns : again.columns) {
        ASSERT_GT(columns.norm(), 10) << "clear in the drives";
        expectSame(columns.col(1), times * columns.col(0), 1e-9 * columns.norm());
    }
    // What is left of the priors if the drives show times * effect + number exactly.
    EXPECT_GE(again.covariance(1, 1), 1 / (1 + times * times));
}

TEST(Fit, KnobThatMayOnlyGrowStaysAtItsLimitWhenLessIsTrue) {
    const simple_car::Case made = someCase(0.95, 0.93);
    const Problem problem = problemOfTwo(made, Direction::up);
    const Calibration car = calibrate(problem, nominalCar(problem, kQuiet), kQuiet);
    const std::optional<Fit> fit = fitted(problem.replays, problem.drives, car.uncertainty, car.about, {kRatio, kDrag},
                                          {problem.replays.origin()});
    ASSERT_TRUE(fit);
    const Dense dense = Dense(car, made.nominal.vehicle).as(*fit);
    ASSERT_LT(dense.best({kWheelbase, kRatio, kDrag})(2), -0.5);
    EXPECT_EQ(fit->at(kDrag), 0);
    const std::vector<Index> others{kWheelbase, kRatio};
    expectNear(fit->at(others), dense.best(others), dense.posterior(others));
}

// With a standard deviation of 20 typical sizes in place of one, and the nuisance as before.
TEST(Fit, WithoutThePriorOfSizesIsMaximumLikelihoodButForALeastPrior) {
    const simple_car::Case made = someCase(0.8, 1.25);
    const Problem problem = problemOfTwo(made);
    const Calibration car = calibrate(problem, nominalCar(problem, kQuiet), kQuiet);
    const Dense steady(car, made.nominal.vehicle);
    const std::vector<Index> free{kWheelbase, kRatio, kDrag};
    struct Best {
        MatrixXd covariance;
        VectorXd point;
    };
    const auto best = [&](const Fit& fit, double of_knobs) {
        const Dense dense = steady.as(fit);
        const MatrixXd weighted = dense.columns.transpose() * dense.covariance.inverse();
        const VectorXd prior{{1, of_knobs, of_knobs}};
        const MatrixXd covariance = MatrixXd(weighted * dense.columns + MatrixXd(prior.asDiagonal())).inverse();
        return Best{covariance, covariance * weighted * dense.residual};
    };
    const std::optional<Fit> ranked = fitted(problem.replays, problem.drives, car.uncertainty, car.about,
                                             {kRatio, kDrag}, {problem.replays.origin()}),
                             released = fitted(problem.replays, problem.drives, car.uncertainty, car.about,
                                               {kRatio, kDrag}, {problem.replays.origin()}, SizePrior::none);
    ASSERT_TRUE(ranked && released);
    const Best as_ranked = best(*ranked, 1), as_released = best(*released, 1 / 400.0);
    expectNear(ranked->at(free), as_ranked.point, as_ranked.covariance);
    expectNear(released->at(free), as_released.point, as_released.covariance);
    expectSame(covarianceOfNumbers(*released).reshaped(), as_released.covariance.reshaped(), 1e-8);
    const VectorXd likeliest = best(*released, 0).point;
    const VectorXd pulled = best(*released, 1).point;
    for (const Index knob : {kRatio, kDrag})
        EXPECT_LT(std::abs(as_released.point(knob) - likeliest(knob)), 0.01 * std::abs(pulled(knob) - likeliest(knob)));
}

// Covariance of all rows by disturbances of one kind, of the usual size.
MatrixXd covarianceBy(Disturbed kind, const Calibration& car, Index rows) {
    MatrixXd all = MatrixXd::Zero(rows, rows);
    Index first = 0;
    for (std::size_t d = 0; d < car.drives().size(); ++d) {
        const std::vector<Disturbed>& kinds = car.uncertainty.disturbing[d].kinds;
        const MatrixXd& directions = car.uncertainty.directions[d];
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            const VectorXd column = directions.col(static_cast<Index>(i));
            if (kinds[i] == kind) all.block(first, first, column.size(), column.size()) += column * column.transpose();
        }
        first += directions.rows();
    }
    return all;
}

// `short_of`: nats by which the point of a fit may fall short of the best one.
void expectSizesOfTheLargestEvidence(const simple_car::Case& made, double short_of) {
    diagnose::Options options = linear_car::options();
    options.simulate = linear_car::drivePushed;
    const Problem problem = problemOf(made.nominal, made.file, made.recorded,
                                      {effect("ratio", "steering.ratio"), effect("drag", "aero.drag_area")}, options);
    const Calibration car = calibrate(problem, nominalCar(problem, kQuiet), kQuiet);
    const Dense plain(car, made.nominal.vehicle);
    const MatrixXd pushed = covarianceBy(Disturbed::roll, car, plain.residual.size());
    for (const std::vector<Index>& knobs : {std::vector<Index>{}, {kRatio, kDrag}}) {
        const std::vector<Index> free = diagnose::model::joined({kWheelbase}, knobs);
        const std::optional<Fit> fit =
            fitted(problem.replays, problem.drives, car.uncertainty, car.about, knobs, {problem.replays.origin()});
        ASSERT_TRUE(fit);
        const auto merit = [&](const Sizes& sizes, const Imperfection& imperfection) {
            Dense dense = plain.with(sizes, imperfection, *fit);
            const double roll = sizes[placeOf(Disturbed::roll)];
            dense.covariance += roll * roll * pushed;
            return dense.logEvidence(free) + Dense::ofPrior(roll) + Dense::ofPriors(sizes) +
                   Dense::ofPriors(imperfection);
        };
        const Sizes& sizes = fit->sizes;
        const Imperfection& imperfection = fit->imperfection;
        const double here = merit(sizes, imperfection);
        EXPECT_NEAR(fit->log_evidence, here, short_of);
        double most = -kInfinity;
        for (const Disturbed kind : {Disturbed::roll, kMisread[0], kMisread[1], kMisread[2]}) {
            for (double log_size = -3.5; log_size < 5; log_size += 0.05) {
                Sizes other = sizes;
                other[placeOf(kind)] = std::exp(log_size);
                most = std::max(most, merit(other, imperfection));
            }
        }
        for (double log_factor = -2; log_factor < 2; log_factor += 0.05) {
            for (const Part part : {Part::steering, Part::body}) {
                Imperfection of_part = imperfection;
                double& of_this = of_part[static_cast<std::size_t>(part)];
                of_this *= std::exp(log_factor);
                if (of_this <= diagnose::kSettings.largest_imperfection) most = std::max(most, merit(sizes, of_part));
            }
        }
        // All parts together, which the size common to them holds less than each by itself.
        for (double log_factor = -2; log_factor < 2; log_factor += 0.05) {
            Imperfection all = imperfection;
            for (double& of_part : all) of_part *= std::exp(log_factor);
            if (*std::max_element(all.begin(), all.end()) <= diagnose::kSettings.largest_imperfection)
                most = std::max(most, merit(sizes, all));
        }
        EXPECT_LT(most - here, kLastStep);
        for (const Disturbed kind :
             {Disturbed::longitudinal, Disturbed::lateral, Disturbed::steering, Disturbed::roll_error})
            EXPECT_EQ(fit->sizes[placeOf(kind)], 1) << nameOf(kind) << " changes nothing in the rows";
    }
}

TEST(Fit, HasTheSizesOfTheLargestEvidenceAndTheirPriorInIt) {
    expectSizesOfTheLargestEvidence(someCase(0.95, 1.06), kLastStep);  // the largest imperfections
    expectSizesOfTheLargestEvidence(someCase(0.995, 1.01), kEnds);
}

TEST(Fit, WithUsualImperfectionsIsTheSameCarAndTheEvidenceOfTheseSizes) {
    const simple_car::Case made = someCase(0.95, 1.06);
    const Problem problem = problemOfTwo(made);
    const Calibration car = calibrate(problem, nominalCar(problem, kQuiet), kQuiet);
    const Dense dense(car, made.nominal.vehicle);
    const Fit usual = withUsualImperfections(car.fit, problem.replays);
    ASSERT_GT(diagnose::model::changeOf(car.fit.imperfection, usual.imperfection), 0.5);
    EXPECT_EQ(usual.imperfection, diagnose::model::usualImperfection());
    for (std::size_t d = 0; d < usual.rows.size(); ++d) {
        EXPECT_EQ(usual.rows[d], car.fit.rows[d]);
        expectSame(usual.columns[d] * usual.at(usual.free), car.fit.columns[d] * car.fit.at(usual.free), 1e-12);
    }
    const auto evidence = [&](const Fit& fit) {
        const inference::QuadraticModel here = quadraticAt(fit, car.uncertainty);
        const inference::Bounds bounds = diagnose::model::boundsOf(problem.replays.parameters, fit.free);
        return inference::logEvidence(here, inference::boundedStep(here, 0, bounds));
    };
    const auto closed = [&](const Fit& fit) { return dense.as(fit).logEvidence(numbersOf(fit)); };
    EXPECT_NEAR(evidence(usual) - evidence(car.fit), closed(usual) - closed(car.fit), kLastStep);
}

const Candidate* candidate(const Search& found, const std::vector<std::size_t>& effects) {
    for (const Candidate& one : found.candidates)
        if (one.effects == effects) return &one;
    return nullptr;
}

TEST(Search, OfTwoEffectsThatAreBothTrueFindsBothWithTheEvidenceOfTheClosedForm) {
    const simple_car::Case made = someCase(0.85, 1.15);
    const Problem problem = problemOfTwo(made);
    const Calibration car = calibrate(problem, nominalCar(problem, kQuiet), kQuiet);
    const Dense dense(car, made.nominal.vehicle);
    const Search found = search(car, screen(car), kQuiet);
    std::vector<std::size_t> best = found.best().effects;
    std::sort(best.begin(), best.end());
    ASSERT_EQ(best, (std::vector<std::size_t>{0, 1}));
    const auto evidence = [&](const Fit& fit) {
        return dense.as(fit).logEvidence(numbersOf(fit)) + Dense::ofPriors(fit);
    };
    const double none = evidence(found.none().fit);
    EXPECT_NEAR(found.best().log_evidence, evidence(found.best().fit) - none, kLastStep);
    for (const Index one : {kRatio, kDrag}) {
        const Candidate* single = candidate(found, {static_cast<std::size_t>(one - kRatio)});
        ASSERT_TRUE(single);
        EXPECT_NEAR(single->log_evidence, evidence(single->fit) - none, kEnds);
        EXPECT_LT(single->log_evidence, found.best().log_evidence - 2 * diagnose::kSettings.effect)
            << "alone it does not explain the rows";
    }
    EXPECT_EQ(found.none().log_evidence, 0);
}

// A tenth of a typical change of the steering ratio. The drives show it with many nats against a car that is exactly as
// nominal, but no car is.
TEST(Search, SmallEffectIsAnImperfectionHoweverClearlyTheDrivesShowIt) {
    const simple_car::Case made = someCase(0.95, 1);
    Effect ratio = effect("ratio", "steering.ratio");
    ratio.knobs.front().typical = 0.5;
    const Problem problem = problemOf(made.nominal, made.file, made.recorded, {ratio}, linear_car::options());
    const Calibration car = calibrate(problem, nominalCar(problem, kQuiet), kQuiet);
    diagnose::model::Linearisation exact = car.about;
    exact.imperfections.clear();
    const auto evidence = [&](const diagnose::model::Linearisation& about, const std::vector<Index>& knobs) {
        return fitted(problem.replays, problem.drives, car.uncertainty, about, knobs, {problem.replays.origin()})
            ->log_evidence;
    };
    EXPECT_GT(evidence(exact, {kRatio}) - evidence(exact, {}), 10);
    EXPECT_LT(evidence(car.about, {kRatio}) - evidence(car.about, {}), 2);
}

TEST(Search, OfOneTrueEffectAddsNoSecond) {
    for (const std::uint64_t seed : {3u, 4u, 5u}) {
        const simple_car::Case made = someCase(0.85, 1, seed);
        const Problem problem = problemOfTwo(made);
        const Calibration car = calibrate(problem, nominalCar(problem, kQuiet), kQuiet);
        const Search found = search(car, screen(car), kQuiet);
        const Candidate *single = candidate(found, {0}), *pair = candidate(found, {0, 1});
        ASSERT_TRUE(single);
        EXPECT_GT(single->log_evidence, 2 * diagnose::kSettings.effect);
        if (pair) {
            EXPECT_LT(pair->log_evidence, single->log_evidence + 5);
        }
    }
}

TEST(Search, CandidateThatWasOnlyScreenedIsFittedLater) {
    const simple_car::Case made = someCase(0.85, 1);
    const Problem problem = problemOfTwo(made);
    const Calibration car = calibrate(problem, nominalCar(problem, kQuiet), kQuiet);
    Search found = search(car, screen(car), kQuiet);
    const Candidate* single = candidate(found, {0});
    ASSERT_TRUE(single && single->fitted);
    Candidate screened{.effects = {0}, .log_evidence = 1, .fit = {}};
    ASSERT_TRUE(diagnose::select::fitScreened(car, found, screened));
    EXPECT_TRUE(screened.fitted);
    EXPECT_NEAR(screened.log_evidence, single->log_evidence, 1) << "that of the search is settled, too";
    EXPECT_NEAR(screened.fit.at(kRatio), single->fit.at(kRatio), 0.05);
}

// Yaw rate of this car is speed times angle over ratio times wheelbase: which of them is larger cannot be told.
TEST(Search, EffectAndItsTwinHaveTheSameEvidenceAndNeitherIsBlamedAlone) {
    simple_car::Case made = simple_car::recorded(16.83, simple_car::Case{}.nominal.vehicle.aero.drag_area, 3);
    made.file.tolerances = {{.path = "*"}};
    std::vector<Effect> effects{effect("ratio", "steering.ratio"), effect("wheelbase", "wheelbase"),
                                effect("drag", "aero.drag_area")};
    // Within what a wheelbase may plausibly differ by.
    for (Effect& one : effects) one.knobs.front().typical = 0.02;
    const Problem problem = problemOf(made.nominal, made.file, made.recorded, effects, simple_car::options());
    const Calibration car = calibrate(problem, nominalCar(problem, kQuiet), kQuiet);
    const auto screened = screen(car);
    EXPECT_GT(diagnose::select::cosine(problem, screened.products, 0, 1), 0.9999);
    const Search found = search(car, screened, kQuiet);
    const Candidate *ratio = candidate(found, {0}), *wheelbase = candidate(found, {1});
    ASSERT_TRUE(ratio && wheelbase);
    EXPECT_NEAR(ratio->log_evidence, wheelbase->log_evidence, kLastStep);
    EXPECT_EQ(candidate(found, {0, 1}), nullptr) << "a second one has nothing to explain";
    const auto d = diagnose::diagnosisOf(made.nominal, made.file, made.recorded, effects, simple_car::options());
    EXPECT_EQ(d.verdict, diagnose::answer::Verdict::ambiguous) << d.answer;
    ASSERT_EQ(d.causes.size(), 1u);
    ASSERT_EQ(d.alternatives.size(), 1u);
    EXPECT_NE(d.causes.front(), d.alternatives.front().front());
    // About even odds, the probability moves by a quarter of what the logarithm of the odds does.
    EXPECT_NEAR(d.effects[0].probability, d.effects[1].probability, kLastStep / 4);
    EXPECT_NEAR(d.effects[0].probability, 0.5, 0.05);
}

}  // namespace
}  // namespace tread::diagnose_fit_test
