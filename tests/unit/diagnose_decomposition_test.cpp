// The parts of a gap, on a car of two waves that overlap, against sums of squares by hand.
#include "diagnose/explain/decomposition.h"

#include <gtest/gtest.h>

#include <cmath>

#include "shared/linear_car.h"

namespace tread::diagnose_decomposition_test {
namespace {

using diagnose::answer::Decomposition;
using diagnose::answer::Diagnosis;
using diagnose::answer::Part;
using diagnose::explain::decompose;
using diagnose::model::Deviation;
using diagnose::model::nominalCar;
using diagnose::model::Problem;
using diagnose::select::Calibration;
using diagnose::select::Candidate;
using diagnose::select::Fit;
using diagnose::select::HeldOut;
using diagnose::select::Judgement;
using diagnose::select::Search;

using Eigen::Index;
using Eigen::VectorXd;

const diagnose::Progress kQuiet = [](double, const std::string&) {};

// Parameters: steering ratio and wheelbase are effects, drag is uncertain.
constexpr Index kDrag = 0, kRatio = 1, kLength = 2;
constexpr double kLengthSize = 0.03;  // typical size of the change of the wheelbase: its plausible range

const diagnose::catalogue::Effect kLengthens{
    "length", "", "", {{.paths = {"wheelbase"}, .typical = kLengthSize, .relative = true}}};

// A point: drag, ratio and length in units of their priors, and no imperfection along the last two.
Deviation at(double drag, double ratio, double length) {
    return VectorXd{{drag, ratio, length, 0, 0}};
}
const Deviation kCalibrated = at(0.6, 0, 0), kAnswer = at(0.2, -0.35, 0.2), kNominal = at(0, 0, 0);

// Two drives of a car that has another ratio and another length: both make waves of the same frequency. No push and no
// speed at the start does anything to it, so that the floor is the noise.
struct Driven {
    simple_car::Case made;
    Problem problem;
    Calibration car;
    HeldOut held_out;
    Search found;

    explicit Driven(std::size_t drives = 2, bool hold_out = false)
        : made(recorded(drives, hold_out)),
          problem(diagnose::model::problemOf(made.nominal, made.file, made.recorded,
                                             {simple_car::effect("ratio", "steering.ratio"), kLengthens},
                                             linear_car::options())),
          car(diagnose::select::calibrate(problem, nominalCar(problem, kQuiet), kQuiet)),
          held_out(diagnose::select::heldOut(car)) {
        found.candidates = {{.effects = {0, 1}, .log_evidence = 30, .fit = fitAt(kAnswer), .fitted = true}};
        found.candidates.push_back({.effects = {}, .log_evidence = 0, .fit = fitAt(kCalibrated), .fitted = true});
    }
    static simple_car::Case recorded(std::size_t drives, bool hold_out) {
        VehicleParams truth = linear_car::nominal();
        truth.steering.ratio *= 0.94;
        truth.wheelbase *= 1 + 0.7 * kLengthSize;
        simple_car::Case all = linear_car::recorded(truth, 3);
        all.file.tolerances = {{.path = "*"}, {.path = "aero.drag_area", .relative = 0.1}};
        all.file.recordings.resize(drives);
        all.recorded.logs.resize(drives);
        all.file.recordings.back().hold_out = hold_out;
        return all;
    }
    static Fit fitAt(const Deviation& point) {
        Fit fit;
        fit.free = {kDrag, kRatio, kLength};
        fit.knobs = {kRatio, kLength};
        fit.at = point;
        return fit;
    }

    // Squares over the noise that the car at a point leaves in a drive.
    double left(const recording::RecordedDrive& drive, const VectorXd& noise, const Deviation& point) const {
        const VehicleParams& nominal = made.nominal.vehicle;
        const VectorXd rows =
            linear_car::nominalRows(drive, nominal) +
            0.1 / std::sqrt(3) * point(kDrag) * nominal.aero.drag_area * linear_car::rowsOf(drive, linear_car::ofDrag) +
            0.1 * point(kRatio) * nominal.steering.ratio * linear_car::rowsOf(drive, linear_car::ofRatio) +
            kLengthSize * point(kLength) * nominal.wheelbase * linear_car::rowsOf(drive, linear_car::ofWheelbase);
        return (drive.measured - rows).cwiseQuotient(noise).squaredNorm();
    }
    double left(std::size_t d, const Deviation& point) const {
        return left(problem.drives[d], car.uncertainty.noise[d].deviation, point);
    }
    double leftInAll(const Deviation& point) const {
        double sum = 0;
        for (std::size_t d = 0; d < problem.drives.size(); ++d) sum += left(d, point);
        return sum;
    }
    double rows() const {
        double sum = 0;
        for (const auto& drive : problem.drives) sum += static_cast<double>(drive.rows());
        return sum;
    }
    Diagnosis decomposed(const Candidate& named, const Deviation& answer) const {
        Diagnosis diagnosis;
        diagnose::select::Closeness closeness = diagnose::select::closenessOf(car, named.effects, answer);
        closeness.with.at = answer;
        decompose(diagnosis, car, Judgement{&named, fitAt(answer), std::move(closeness), {}, {}}, held_out);
        return diagnosis;
    }
    // The closest car with one of the changes.
    Deviation closestWith(Index knob) const { return diagnose::select::closestTo(car, kNominal, {knob})->at; }
    Diagnosis decomposed() const { return decomposed(found.candidates.front(), kAnswer); }
};

double sumOf(const Decomposition& parts) {
    return parts.tolerances.share + parts.causes.share + parts.remainder.share + parts.noise.share;
}

TEST(Decomposition, PartsAreDifferencesOfSquaresAndSumToOne) {
    const Driven driven;
    const Decomposition parts = driven.decomposed().training;
    const double nominal = driven.leftInAll(driven.problem.replays.origin()),
                 none = driven.leftInAll(driven.car.closest.at), answer = driven.leftInAll(kAnswer),
                 rows = driven.rows();
    ASSERT_GT(answer, rows) << "the answer is not the truth";
    EXPECT_NEAR(parts.gap, nominal / rows, 1e-9);
    EXPECT_NEAR(parts.tolerances.share, (nominal - none) / nominal, 1e-9);
    EXPECT_NEAR(parts.causes.share, (none - answer) / nominal, 1e-9);
    EXPECT_NEAR(parts.remainder.share, (answer - rows) / nominal, 1e-9);
    EXPECT_NEAR(parts.noise.share, rows / nominal, 1e-9);
    EXPECT_NEAR(sumOf(parts), 1, 1e-12);
    EXPECT_TRUE(driven.decomposed().held_out.each.empty());
}

TEST(Decomposition, OfTheTruthLeavesNoiseOnly) {
    const Driven driven;
    const Deviation truth = at(0, -0.6, 0.7);
    const double nominal = driven.leftInAll(driven.problem.replays.origin()), answer = driven.leftInAll(truth);
    const Decomposition parts = driven.decomposed(driven.found.candidates.front(), truth).training;
    const double rows = driven.rows();
    EXPECT_NEAR(parts.noise.share, std::min(answer, rows) / nominal, 1e-9);
    EXPECT_NEAR(parts.remainder.share, std::max(0.0, answer - rows) / nominal, 1e-9);
    EXPECT_LT(parts.remainder.share, 0.02);
    EXPECT_NEAR(sumOf(parts), 1, 1e-12);
}

// What both explain counts for the one that comes first.
// The drag is 40 % too large, which is 6.9 standard deviations; its tolerance ends at the root of three.
TEST(Decomposition, TolerancesExplainNoMoreThanTheyAllow) {
    VehicleParams truth = linear_car::nominal();
    truth.aero.drag_area *= 1.4;
    simple_car::Case made = linear_car::recorded(truth, 3);
    made.file.tolerances = {{.path = "*"}, {.path = "aero.drag_area", .relative = 0.1}};
    const Problem problem = diagnose::model::problemOf(
        made.nominal, made.file, made.recorded, {simple_car::effect("ratio", "steering.ratio")}, linear_car::options());
    const Calibration car = diagnose::select::calibrate(problem, nominalCar(problem, kQuiet), kQuiet);
    EXPECT_NEAR(car.closest.at(kDrag), std::sqrt(3.0), 1e-12);
    EXPECT_GT(car.fit.at(kDrag), 3) << "the likeliest car goes beyond";
}

TEST(Decomposition, OverlappingCausesExplainMoreFirstThanLast) {
    const Driven driven;
    const Decomposition parts = driven.decomposed().training;
    const double nominal = driven.leftInAll(driven.problem.replays.origin()),
                 none = driven.leftInAll(driven.car.closest.at), answer = driven.leftInAll(kAnswer);
    ASSERT_EQ(parts.each.size(), 2u);
    EXPECT_EQ(parts.each[0].name, "ratio");
    EXPECT_EQ(parts.each[1].name, "length");
    const double ratio = driven.leftInAll(driven.closestWith(kRatio)),
                 length = driven.leftInAll(driven.closestWith(kLength));
    EXPECT_NEAR(parts.each[0].first.share, (none - ratio) / nominal, 1e-4);
    EXPECT_NEAR(parts.each[0].last.share, (length - answer) / nominal, 1e-4);
    EXPECT_NEAR(parts.each[1].first.share, (none - length) / nominal, 1e-4);
    EXPECT_NEAR(parts.each[1].last.share, (ratio - answer) / nominal, 1e-4);
    EXPECT_NEAR(parts.each[0].first.share + parts.each[1].last.share, parts.causes.share, 1e-12);
}

// The prior holds the drag alone, and hardly.
TEST(Decomposition, NoCarNearTheClosestLeavesLess) {
    const Driven driven;
    const Deviation closest = driven.closestWith(kRatio);
    EXPECT_EQ(closest(kLength), 0);
    for (const double off : {-0.3, 0.3}) {
        EXPECT_LT(driven.leftInAll(closest), driven.leftInAll(at(closest(kDrag) + off, closest(kRatio), 0)));
        EXPECT_LT(driven.leftInAll(closest), driven.leftInAll(at(closest(kDrag), closest(kRatio) + off, 0)));
    }
}

// The closest car at fixed changes: only what is uncertain moves.
TEST(Decomposition, KnobsThatDoNotTakePartStay) {
    const Driven driven;
    const Deviation closest = diagnose::select::closestTo(driven.car, kAnswer, {})->at;
    EXPECT_EQ(closest(kRatio), kAnswer(kRatio));
    EXPECT_EQ(closest(kLength), kAnswer(kLength));
    EXPECT_NE(closest(kDrag), kAnswer(kDrag));
}

TEST(Decomposition, OfASingleCauseIsTheSameFirstAndLast) {
    const Driven driven;
    const Candidate ratio{.effects = {0}, .log_evidence = 20, .fit = Driven::fitAt(kAnswer), .fitted = true};
    const Decomposition parts = driven.decomposed(ratio, kAnswer).training;
    ASSERT_EQ(parts.each.size(), 1u);
    EXPECT_NEAR(parts.each[0].first.share, parts.causes.share, 1e-12);
    EXPECT_NEAR(parts.each[0].last.share, parts.causes.share, 1e-12);
}

TEST(Decomposition, OfNoCauseIsToleranceRemainderAndNoise) {
    const Driven driven;
    const Decomposition parts = driven.decomposed(driven.found.candidates.back(), driven.car.closest.at).training;
    EXPECT_EQ(parts.causes.share, 0);
    EXPECT_TRUE(parts.each.empty());
    EXPECT_NEAR(sumOf(parts), 1, 1e-12);
}

void expectPoint(const Part& part) {
    EXPECT_EQ(part.low, part.share);
    EXPECT_EQ(part.high, part.share);
}

TEST(Decomposition, HasIntervalsBetweenItsDrives) {
    const Driven driven;
    const Decomposition parts = driven.decomposed().training;
    // Drives are drawn with replacement: one of them twice in half of the samples.
    const auto share = [&](std::size_t d) {
        return (driven.left(d, driven.car.closest.at) - driven.left(d, kAnswer)) /
               driven.left(d, driven.problem.replays.origin());
    };
    EXPECT_NEAR(parts.causes.low, std::min(share(0), share(1)), 1e-9);
    EXPECT_NEAR(parts.causes.high, std::max(share(0), share(1)), 1e-9);
    EXPECT_LT(parts.causes.low, parts.causes.high);
}

TEST(Decomposition, OfOneDriveHasNoIntervals) {
    const Decomposition parts = Driven(1).decomposed().training;
    for (const Part& part : {parts.tolerances, parts.causes, parts.remainder, parts.noise}) expectPoint(part);
    for (const auto& cause : parts.each) expectPoint(cause.first), expectPoint(cause.last);
}

TEST(Decomposition, OfDrivesHeldOutIsThatOfTheSamePointsInThem) {
    const Driven driven(2, true);
    const Diagnosis diagnosis = driven.decomposed();
    const auto left = [&](const Deviation& point) {
        return driven.left(driven.problem.held_out.front(), driven.held_out.uncertainty.noise.front().deviation, point);
    };
    const double nominal = left(driven.problem.replays.origin()), none = left(driven.car.closest.at),
                 answer = left(kAnswer), ratio = left(driven.closestWith(kRatio));
    const Decomposition& parts = diagnosis.held_out;
    EXPECT_NEAR(parts.tolerances.share, (nominal - none) / nominal, 1e-9);
    EXPECT_NEAR(parts.causes.share, (none - answer) / nominal, 1e-9);
    ASSERT_EQ(parts.each.size(), 2u);
    EXPECT_NEAR(parts.each[0].first.share, (none - ratio) / nominal, 1e-4);
    EXPECT_NEAR(sumOf(parts), 1, 1e-12);
    EXPECT_NE(parts.causes.share, diagnosis.training.causes.share);
}

}  // namespace
}  // namespace tread::diagnose_decomposition_test
