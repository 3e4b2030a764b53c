// The posterior over sets of causes and the doubt about their signatures, against an enumeration of all hypotheses by
// the equations of src/diagnose/README.md: three effects in two drives, whose signatures do not overlap.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "diagnose/select/posterior.h"
#include "shared/linear_drives.h"

namespace tread::diagnose_hypotheses_test {
namespace {

using diagnose::model::Problem;
using diagnose::select::Calibration;
using diagnose::select::Candidate;
using diagnose::select::Hypothesis;
using diagnose::select::Posterior;
using diagnose::select::posterior;
using diagnose::select::Search;
using linear_drives::doubtAgainst;
using linear_drives::LinearDrive;

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Row e of a drive shows effect e alone, with `slopes`; the last row is noise.
LinearDrive driveOf(const VectorXd& slopes, const VectorXd& measured) {
    LinearDrive drive{MatrixXd(4, 0), MatrixXd::Zero(4, 3), measured, MatrixXd(4, 0)};
    drive.effects.diagonal() = slopes;
    return drive;
}

std::vector<LinearDrive> usualDrives() {
    return {driveOf(VectorXd{{3, 2, 1}}, VectorXd{{4.1, 1.5, 0.4, 3}}),
            driveOf(VectorXd{{2, 4, 3}}, VectorXd{{1.9, 4.8, 2.2, -2}})};
}

// Candidates of some sets, the best first. Their evidences are as given, not those of the drives.
struct ThreeEffects {
    std::vector<LinearDrive> drives;
    Problem problem;
    Calibration car;
    Search found;

    explicit ThreeEffects(std::vector<LinearDrive> told = usualDrives())
        : drives(std::move(told)),
          problem(linear_drives::problemOf(drives)),
          car(linear_drives::calibrationOf(problem, drives)) {
        add({0, 1}, 14.5);
        add({0, 1, 2}, 16);
        add({0}, 8.2);
        add({1}, 6.7);
        add({}, 0);
        found.candidates.push_back({.effects = {2}, .log_evidence = 1.3, .fit = {}, .fitted = false});
    }
    void add(const std::vector<std::size_t>& effects, double evidence) {
        found.candidates.push_back(linear_drives::candidateOf(car, effects));
        found.candidates.back().log_evidence = evidence;
    }

    // Fitted sizes and squares that are left, row by row: no matrix is needed.
    double sizeOf(std::size_t effect) const {
        double information = 1, gradient = 0;
        for (const LinearDrive& drive : drives) {
            const double slope = drive.effects(effect, effect);
            information += slope * slope, gradient += slope * drive.measured(effect);
        }
        return gradient / information;
    }
    double leftOf(const std::vector<std::size_t>& effects) const {
        double squares = 0;
        for (const LinearDrive& drive : drives) {
            VectorXd left = drive.measured;
            for (const std::size_t e : effects) left(e) -= drive.effects(e, e) * sizeOf(e);
            squares += left.squaredNorm();
        }
        return squares;
    }
    // (D30) with one channel. What a set changes in a drive, and the difference to another set, are sums over effects.
    double doubted(const std::vector<std::size_t>& effects, const std::vector<std::size_t>& rival) const {
        double sum = 0, believed = 0;
        for (const LinearDrive& drive : drives) {
            double changed = 0, differing = 0;
            for (std::size_t e = 0; e < 3; ++e) {
                const bool here = std::ranges::count(effects, e) > 0, there = std::ranges::count(rival, e) > 0;
                const double squared = std::pow(drive.effects(e, e) * sizeOf(e), 2);
                if (here) changed += squared;
                if (here != there) differing += squared;
            }
            sum += differing, believed += differing / (1 + 0.05 * 0.05 * changed);
        }
        return believed > 0 ? sum / believed : 1;
    }
};

using Probabilities = std::map<std::string, double>;  // of sets: "01"

std::string nameOf(const std::vector<std::size_t>& effects) {
    std::string name;
    for (const std::size_t e : effects) name += std::to_string(e);
    return name;
}

// (D28) and (D29).
Probabilities enumerated(const ThreeEffects& three, double birge, const std::vector<bool>& possible) {
    constexpr double kOne = 0.75 / (1 + 1.0 / 3 + 1.0 / 9);
    // Three single effects, three pairs, one set of three.
    const std::vector<double> prior{0.25, kOne / 3, kOne / 3 / 3, kOne / 9};
    const std::vector<Candidate>& all = three.found.candidates;
    double best = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (possible[i]) best = std::max(best, all[i].log_evidence);
    Probabilities weight;
    double sum = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!possible[i]) continue;
        const double divisor = all[i].fitted ? three.doubted(all[i].effects, {0, 1}) * birge : birge;
        sum += weight[nameOf(all[i].effects)] =
            prior[all[i].effects.size()] * std::exp((all[i].log_evidence - best) / divisor);
    }
    for (auto& [name, value] : weight) value /= sum;
    return weight;
}

Probabilities told(const Posterior& posterior) {
    Probabilities all;
    for (const Hypothesis& one : posterior.hypotheses) all[nameOf(one.candidate->effects)] = one.probability;
    return all;
}

void expectSame(const Probabilities& found, const Probabilities& expected) {
    EXPECT_EQ(found.size(), expected.size());
    for (const auto& [name, value] : expected) {
        ASSERT_TRUE(found.contains(name)) << name;
        EXPECT_NEAR(found.at(name), value, 1e-12) << name;
        EXPECT_GT(value, 1e-9) << name << " must be seen";
    }
}

TEST(Hypotheses, AreAsProbableAsTheirPriorsAndEvidenceSay) {
    const ThreeEffects three;
    // The best set, of two effects, leaves this of two drives of four rows.
    const double birge = three.leftOf({0, 1}) / 8;
    ASSERT_GT(birge, 1.2);
    for (const std::vector<bool>& possible : {std::vector<bool>{true, true, true, true, true, true},
                                              {false, true, true, true, true, true},
                                              {true, false, true, false, true, true}}) {
        const Posterior found = posterior(three.car, three.found, possible);
        EXPECT_NEAR(found.variance_factor, birge, 1e-12);
        Probabilities expected = enumerated(three, birge, possible);
        expectSame(told(found), expected);
        EXPECT_NEAR(found.of(0), expected["0"] + expected["01"] + expected["012"], 1e-12);
        EXPECT_NEAR(found.of(2), expected["2"] + expected["012"], 1e-12);
        EXPECT_NEAR(found.ofNothing(), expected[""], 1e-12);
    }
}

TEST(Hypotheses, AreDoubtedInProportionToWhatTheyChangeWhereTheyDifferFromARival) {
    const ThreeEffects three;
    for (const Candidate& one : three.found.candidates) {
        for (const Candidate& rival : three.found.candidates) {
            if (!one.fitted || !rival.fitted) continue;
            EXPECT_NEAR(doubtAgainst(rival.fit, three.car, one.fit), three.doubted(one.effects, rival.effects), 1e-12)
                << nameOf(one.effects) << " against " << nameOf(rival.effects);
        }
    }
    EXPECT_GT(three.doubted({0}, {0, 1}), 1.01);
    EXPECT_EQ(three.doubted({}, {0, 1}), 1);
}

// An effect in another channel is no less certain beside a strong first one.
TEST(Hypotheses, AreNotDoubtedForWhatTheyChangeInOtherChannels) {
    const std::vector<LinearDrive> drives{driveOf(VectorXd{{100, 1, 2}}, VectorXd{{100, 5, 7, 0}})};
    Problem problem = linear_drives::problemOf(drives);
    problem.drives[0].channels = {{.name = "first", .measured = {}, .first_row = 0, .times = std::vector<double>(2)},
                                  {.name = "second", .measured = {}, .first_row = 2, .times = std::vector<double>(2)}};
    const Calibration car = linear_drives::calibrationOf(problem, drives);
    const auto first = linear_drives::fitOf(car, {0});
    const double size = 100 * 100 * 100 / (1 + 1e4);
    EXPECT_EQ(doubtAgainst(linear_drives::fitOf(car, {0, 2}), car, first), 1);
    EXPECT_NEAR(doubtAgainst(linear_drives::fitOf(car, {0, 1}), car, first), 1 + 0.0025 * size * size, 1e-9);
}

// Channels of one drive may err together, drives do not: an effect that changes two channels, or one channel of two
// drives.
TEST(Hypotheses, AreMoreDoubtfulInTwoChannelsOfADriveThanInTwoDrives) {
    const auto driveOfRows = [](const VectorXd& slopes) {
        return LinearDrive{MatrixXd(slopes.size(), 0), slopes, 100 * slopes, MatrixXd(slopes.size(), 0)};
    };
    const auto doubtOf = [](Problem problem, const std::vector<LinearDrive>& drives) {
        const Calibration car = linear_drives::calibrationOf(problem, drives);
        return doubtAgainst(linear_drives::fitOf(car, {}), car, linear_drives::fitOf(car, {0})) - 1;
    };
    const std::vector<LinearDrive> one{driveOfRows(VectorXd{{3, 4}})},
        two{driveOfRows(VectorXd{{3}}), driveOfRows(VectorXd{{4}})};
    Problem two_channels = linear_drives::problemOf(one);
    two_channels.drives[0].channels = {
        {.name = "first", .measured = {}, .first_row = 0, .times = std::vector<double>(1)},
        {.name = "second", .measured = {}, .first_row = 1, .times = std::vector<double>(1)}};
    const double squared = std::pow(100 * 25 / 26.0, 2);  // of the fitted size
    EXPECT_NEAR(doubtOf(two_channels, one), 0.0025 * 25 * squared, 1e-9 * squared);
    const double believed = 9 / (1 + 0.0025 * 9 * squared) + 16 / (1 + 0.0025 * 16 * squared);
    EXPECT_NEAR(doubtOf(linear_drives::problemOf(two), two), 25 / believed - 1, 1e-9 * squared);
}

// Errors of a strong signature in one channel do not hide a difference that another channel shows as well.
TEST(Hypotheses, AreDoubtedByErrorsWithTheCorrelationThatHidesMost) {
    const std::vector<LinearDrive> drives{
        {MatrixXd(2, 0), MatrixXd{{80, 6}, {20, 8}}, VectorXd{{86, 28}}, MatrixXd(2, 0), {}}};
    Problem problem = linear_drives::problemOf(drives);
    problem.drives[0].channels = {{.name = "first", .measured = {}, .first_row = 0, .times = std::vector<double>(1)},
                                  {.name = "second", .measured = {}, .first_row = 1, .times = std::vector<double>(1)}};
    const Calibration car = linear_drives::calibrationOf(problem, drives);
    const auto fit = linear_drives::fitOf(car, {0}), rival = linear_drives::fitOf(car, {0, 1});
    const VectorXd changed = fit.rows[0].cwiseAbs(), off = (rival.rows[0] - fit.rows[0]).cwiseAbs();
    double least = off.squaredNorm(), with_least = 0;
    for (int i = 0; i <= 20; ++i) {
        MatrixXd errors = 0.0025 * changed * changed.transpose();
        errors(0, 1) *= i / 20.0, errors(1, 0) *= i / 20.0;
        const double believed = off.dot((MatrixXd::Identity(2, 2) + errors).inverse() * off);
        if (believed < least) least = believed, with_least = i / 20.0;
    }
    EXPECT_GT(with_least, 0);
    EXPECT_LT(with_least, 1);
    const double doubted = doubtAgainst(rival, car, fit);
    EXPECT_NEAR(doubted, off.squaredNorm() / least, 1e-9 * doubted);
}

TEST(Hypotheses, AreHalfAsDoubtfulWhenTwoDrivesShareWhatIsExplained) {
    const auto doubtOf = [](const std::vector<double>& measured) {
        std::vector<LinearDrive> drives;
        for (const double one : measured) drives.push_back(driveOf(VectorXd{{1e4, 1, 1}}, VectorXd{{one, 0, 0, 0}}));
        const Problem problem = linear_drives::problemOf(drives);
        const Calibration car = linear_drives::calibrationOf(problem, drives);
        return doubtAgainst(linear_drives::fitOf(car, {}), car, linear_drives::fitOf(car, {0})) - 1;
    };
    const double half = 1e5 / std::sqrt(2);
    EXPECT_NEAR(doubtOf({half, half}) / doubtOf({1e5}), 0.5, 1e-6);
}

// What disturbances could do as well does not count as explained.
TEST(Hypotheses, AreDoubtedInTheMetricOfTheirRemainder) {
    LinearDrive drive = driveOf(VectorXd{{3, 2, 1}}, VectorXd{{4.1, 1.5, 0.4, 3}});
    drive.disturbances = MatrixXd{{0.8}, {0.3}, {-0.5}, {1}};
    const std::vector<LinearDrive> drives{drive};
    const Problem problem = linear_drives::problemOf(drives);
    const Calibration car = linear_drives::calibrationOf(problem, drives, 2);
    const auto fit = linear_drives::fitOf(car, {0, 2});
    const MatrixXd metric =
        (MatrixXd::Identity(4, 4) + 4 * drive.disturbances * drive.disturbances.transpose()).inverse();
    const VectorXd explained = drive.effects * fit.at;
    EXPECT_NEAR(doubtAgainst(linear_drives::fitOf(car, {}), car, fit), 1 + 0.0025 * explained.dot(metric * explained),
                1e-12);
}

// Tolerances imitate a signature, not its error: that is a share of the whole signature. A drive counts by what they
// cannot imitate there.
TEST(Hypotheses, AreDoubtedForAllThatTheyChangeInDrivesThatTellThem) {
    std::vector<LinearDrive> drives{driveOf(VectorXd{{30, 1, 1}}, VectorXd{{31, 0, 0, 1}}),
                                    driveOf(VectorXd{{9, 1, 1}}, VectorXd{{8, 0, 0, 2}})};
    drives[0].nuisances = VectorXd{{28, 0, 0, 3}};
    drives[1].nuisances = VectorXd{{-1, 0, 0, 1}};
    const Problem problem = linear_drives::problemOf(drives);
    const Calibration car = linear_drives::calibrationOf(problem, drives);
    const auto fit = linear_drives::fitOf(car, {0});
    const double size = fit.at(fit.knobs.front());
    double mixed = 0, information = 1;
    for (const LinearDrive& drive : drives)
        mixed += drive.nuisances.col(0).dot(drive.effects.col(0)), information += drive.nuisances.squaredNorm();
    double own = 0, believed = 0;
    for (const LinearDrive& drive : drives) {
        const double squares = (drive.effects.col(0) - drive.nuisances * mixed / information).squaredNorm();
        own += squares, believed += squares / (1 + 0.0025 * drive.effects.col(0).squaredNorm() * size * size);
    }
    ASSERT_LT(own, 0.2 * (900 + 81)) << "tolerances imitate most of it";
    EXPECT_NEAR(doubtAgainst(linear_drives::fitOf(car, {}), car, fit), own / believed, 1e-12);
}

// The truth may resemble a rival as far as its signature is wrong: a share of 0.05 of 20 standard deviations is one of
// them, and an advantage of 12.5 nats, five standard deviations, shrinks to 12.5 / (1 + 1).
TEST(Hypotheses, RivalOfAStrongEffectKeepsTheProbabilityThatAWrongSignatureLeavesIt) {
    const std::vector<LinearDrive> drives{driveOf(VectorXd{{20, 20, 1}}, VectorXd{{20, 20, 0, 0}})};
    const Problem problem = linear_drives::problemOf(drives);
    const Calibration car = linear_drives::calibrationOf(problem, drives);
    Search found{{linear_drives::candidateOf(car, {0}), linear_drives::candidateOf(car, {1})}};
    found.candidates[0].log_evidence = 100, found.candidates[1].log_evidence = 87.5;
    found.candidates.push_back(linear_drives::candidateOf(car, {}));
    const Posterior result = posterior(car, found, {true, true, true});
    const double explained = std::pow(20 * 400 / 401.0, 2), birge = result.variance_factor;
    EXPECT_NEAR(std::log(result.of(0) / result.of(1)), 12.5 / (1 + 0.0025 * explained) / birge, 1e-9);
}

}  // namespace
}  // namespace tread::diagnose_hypotheses_test
