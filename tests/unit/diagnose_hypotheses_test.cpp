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
    // (D37) to (D39), of drives that are independent: each has its own value along the fitted direction. Two drives:
    // one degree of freedom.
    double resembles(const std::vector<std::size_t>& effects, bool compared) const {
        double length = 0;
        for (const std::size_t e : effects) length += sizeOf(e) * sizeOf(e);
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
        return 0.5 * q * (1 / narrow - 1 / wide) - 0.5 * std::log(wide / narrow);
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
        const double gain = three.resembles(one.effects, compared);
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
        EXPECT_NEAR(found.variance_factor, birge, 1e-12);
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

TEST(Hypotheses, EffectThatHasAnotherValueInEachDriveIsRatherResembled) {
    // The first drive asks for 1.6, the second for 0.6; both know it well.
    ThreeEffects three({driveOf(VectorXd{{12, 2, 1}}, VectorXd{{19.2, 1, -1, 1}}),
                        driveOf(VectorXd{{10, 2, 1}}, VectorXd{{6, -1, 1, -1}})});
    three.found.candidates.clear();
    three.add({0}, 40);
    three.add({}, 0);
    EXPECT_GT(three.resembles({0}, false), 3);
    const Probabilities found = told(posterior(three.car, three.found, -3));
    expectSame(found, enumerated(three, three.leftOf({0}) / 8, 0, -3, false));
    EXPECT_GT(found.at("0 resembled") / found.at("0"), 2 / 90.0) << "of priors, 0.005 and 0.45, it is 1 / 90";
}

}  // namespace
}  // namespace tread
