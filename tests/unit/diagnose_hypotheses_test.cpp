// The posterior over sets of causes, against an enumeration of all hypotheses by the equations of
// src/diagnose/README.md: three effects in two drives, whose signatures do not overlap.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "diagnose/select/posterior.h"
#include "shared/linear_drives.h"

namespace tread {
namespace {

using diagnose::model::Problem;
using diagnose::select::Calibration;
using diagnose::select::Candidate;
using diagnose::select::Hypothesis;
using diagnose::select::Posterior;
using diagnose::select::posterior;
using diagnose::select::Search;
using linear_drives::LinearDrive;

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Row e of a drive shows effect e alone, with `slopes`; the last row is noise.
LinearDrive driveOf(const VectorXd& slopes, const VectorXd& measured) {
    LinearDrive drive{MatrixXd(4, 0), MatrixXd::Zero(4, 3), measured, MatrixXd(4, 0)};
    drive.effects.diagonal() = slopes;
    return drive;
}

struct ThreeEffects {
    std::vector<LinearDrive> drives{driveOf(VectorXd{{3, 2, 1}}, VectorXd{{4.1, 1.5, 0.4, 3}}),
                                    driveOf(VectorXd{{2, 4, 3}}, VectorXd{{1.9, 4.8, 2.2, -2}})};
    Problem problem = linear_drives::problemOf(drives);
    Calibration car = linear_drives::calibrationOf(problem, drives);
    Search found;

    // Evidences are as given, not those of the drives.
    ThreeEffects() {
        const auto add = [&](std::vector<std::size_t> effects, double evidence, bool fitted) {
            Candidate one = linear_drives::candidateOf(car, effects);
            one.log_evidence = evidence, one.fitted = fitted;
            if (!fitted) one.fit = {};
            found.candidates.push_back(std::move(one));
        };
        add({0, 1}, 14.5, true);
        add({0, 1, 2}, 16, true);
        add({0}, 8.2, true);
        add({1}, 6.7, true);
        add({}, 0, true);
        add({2}, 1.3, false);  // screened only
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
    // (D37) to (D39), of drives that are independent: each has its own value along the fitted direction. Two drives:
    // one degree of freedom.
    double resembles(const std::vector<std::size_t>& effects, double evidence, bool compared) const {
        double length = 0, prior = 0;
        for (const std::size_t e : effects) {
            const double size = sizeOf(e);
            length += size * size, prior += 0.5 * size * size * 0.75 - std::log(2);
        }
        double weights = 0, weighted = 0, squares = 0;
        for (const LinearDrive& drive : drives) {
            double weight = 0, gradient = 0;
            for (const std::size_t e : effects) {
                const double slope = drive.effects(e, e), size = sizeOf(e), along = size / std::sqrt(length);
                weight += slope * slope * along * along;
                gradient += slope * along * (drive.measured(e) - slope * size);
            }
            weights += weight, weighted += gradient, squares += gradient * gradient / weight;
        }
        const double q = squares - weighted * weighted / weights, w = length * weights;
        const double narrow = 1 + std::pow(compared ? 0.25 : 0.1, 2) * w / 2, wide = 1 + 0.25 * w / 2;
        const double varied = 0.5 * q * (1 / narrow - 1 / wide) - 0.5 * std::log(wide / narrow);
        const double counted = varied > 0 ? std::max(0.0, varied - 0.04 * evidence) : varied;
        return (compared ? 0 : prior) + counted;
    }
};

using Probabilities = std::map<std::string, double>;  // of hypotheses: "01", "01 resembled", "unknown"

std::string nameOf(const std::vector<std::size_t>& effects) {
    std::string name;
    for (const std::size_t e : effects) name += std::to_string(e);
    return name;
}

// (D28) to (D32). `doubted`: nats of each effect after the first that do not count, (D30).
Probabilities enumerated(const ThreeEffects& three, double birge, double doubted, double unknown, bool compared) {
    // Three single effects, three pairs, one set of three.
    const std::vector<double> prior{0.25, 0.45 / 3, 0.15 / 3, 0.05}, alike{0, 0.05 / 3, 0.05 / 3, 0.3};
    Probabilities weight;
    double strongest = -1e9;
    for (const Candidate& one : three.found.candidates) {
        const std::size_t n = one.effects.size();
        const double evidence = one.log_evidence - (n > 1 ? static_cast<double>(n - 1) * doubted : 0);
        strongest = std::max(strongest, evidence);
        weight[nameOf(one.effects)] = prior[n] * std::exp(evidence / birge);
        if (n == 0 || !one.fitted) continue;
        const double gain = three.resembles(one.effects, one.log_evidence, compared);
        weight[nameOf(one.effects) + " resembled"] = 0.1 * alike[n] * std::exp((evidence + gain) / birge);
    }
    weight["unknown"] = 0.1 * std::exp((strongest + unknown - 6) / birge);
    double sum = 0;
    for (const auto& [name, value] : weight) sum += value;
    for (auto& [name, value] : weight) value /= sum;
    return weight;
}

Probabilities told(const Posterior& posterior) {
    Probabilities all;
    for (const Hypothesis& one : posterior.hypotheses) {
        const std::string name = one.candidate ? nameOf(one.candidate->effects) : "unknown";
        all[one.look_alike ? name + " resembled" : name] = one.probability;
    }
    return all;
}

void expectSame(const Probabilities& found, const Probabilities& expected) {
    EXPECT_EQ(found.size(), expected.size());
    for (const auto& [name, value] : expected) {
        ASSERT_TRUE(found.contains(name)) << name;
        EXPECT_NEAR(found.at(name), value, 1e-12) << name;
    }
}

TEST(Hypotheses, AreAsProbableAsTheirPriorsAndEvidenceSay) {
    const ThreeEffects three;
    // The best set, of two effects, leaves this of two drives of four rows.
    const double birge = three.leftOf({0, 1}) / 8;
    ASSERT_GT(birge, 1.2);
    for (const double unknown : {-3.0, 5.0, 20.0}) {
        const Posterior found = posterior(three.car, three.found, unknown);
        EXPECT_NEAR(found.birge_ratio, birge, 1e-12);
        const Probabilities expected = enumerated(three, birge, 0.002 * 14.5, unknown, false);
        expectSame(told(found), expected);
        EXPECT_NEAR(found.of(0), expected.at("0") + expected.at("01") + expected.at("012"), 1e-12);
        EXPECT_NEAR(found.of(2), expected.at("2") + expected.at("012"), 1e-12);
        EXPECT_NEAR(found.ofUnknown(),
                    expected.at("unknown") + expected.at("0 resembled") + expected.at("1 resembled") +
                        expected.at("01 resembled") + expected.at("012 resembled"),
                    1e-12);
        for (const auto& [name, probability] : expected) EXPECT_GT(probability, 1e-9) << name << " must be seen";
    }
}

// With references, a model of another structure: more nats of further effects are doubted, any size is as good as
// another, and values may vary more.
TEST(Hypotheses, OfDrivesWithReferencesDoubtFurtherEffectsMore) {
    ThreeEffects three;
    for (recording::RecordedDrive& drive : three.problem.drives) drive.runs = 2;
    const double birge = three.leftOf({0, 1}) / 8;
    expectSame(told(posterior(three.car, three.found, 2)), enumerated(three, birge, 0.15 * 14.5, 2, true));
}

TEST(Hypotheses, DriveInWhichAnEffectHasAnotherValueSpeaksForAnUnknownCause) {
    ThreeEffects three;
    three.drives[1].measured(0) = -6;  // the first drive asks for 1.4, the second for -3
    three.problem = linear_drives::problemOf(three.drives);
    three.found.candidates = {linear_drives::candidateOf(three.car, {0}), linear_drives::candidateOf(three.car, {})};
    for (Candidate& one : three.found.candidates) one.log_evidence = one.effects.empty() ? 0 : 8.2;
    EXPECT_GT(three.resembles({0}, 8.2, false), 0);
    expectSame(told(posterior(three.car, three.found, -3)), enumerated(three, three.leftOf({0}) / 8, 0, -3, false));
}

}  // namespace
}  // namespace tread
