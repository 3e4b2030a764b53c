// The diagnosis replays drives with longer steps than those in which a car moves: that must not look like an effect.
#include <gtest/gtest.h>

#include <cmath>

#include "blind/drives/drives.h"
#include "blind/drives/measure.h"
#include "diagnose/catalogue/effect.h"
#include "diagnose/model/problem.h"
#include "diagnose/model/replays.h"
#include "diagnose/model/uncertainty.h"
#include "planted/planted.h"
#include "recording/diagnosis_file.h"
#include "recording/subject.h"

namespace tread::step_test {
namespace {

using blind::drives::caseDrives;
using blind::drives::Drive;
using blind::drives::DriveSet;
using blind::drives::measure;
using blind::world::Truth;
using diagnose::catalogue::effectCatalogue;
using diagnose::model::Deviation;
using diagnose::model::endsOf;
using diagnose::model::kEffectStep;
using diagnose::model::Problem;
using diagnose::model::problemOf;
using diagnose::model::Replays;
using diagnose::model::Rows;
using diagnose::model::squaresOf;
using diagnose::model::Uncertainty;
using recording::DiagnosisFile;
using recording::Recorded;
using recording::Recording;
using recording::Subject;

constexpr double kFineStep = 0.001;  // s
constexpr double kMostNats = 0.5;    // of the 5 that an effect needs
constexpr double kMostOff = 0.1;     // of a column: a fit corrects it along its steps

// Turns, braking and driving at the limit, as a diagnosis repeats them.
struct Drives {
    DiagnosisFile file;
    Recorded recorded;
    Problem problem;

    Drives() {
        Subject nominal;
        nominal.vehicle = planted::nominalCar();
        for (const Drive& drive : caseDrives(DriveSet::all)) {
            const bool wanted = drive.name.starts_with("step_steer_80") || drive.name.starts_with("braking_in_turn") ||
                                drive.name.starts_with("acceleration") || drive.name.starts_with("slow_ramp");
            if (!wanted) continue;
            Recording& recording = file.recordings.emplace_back();
            recording.name = drive.name;
            Truth truth;
            truth.car = nominal;
            recorded.logs.push_back(measure(truth, drive, 1));
        }
        problem = problemOf(nominal, file, recorded, effectCatalogue(), {});
    }

    Rows rows(const Deviation& at, double step) const {
        Replays replays = problem.replays;
        replays.replayer.step = step;
        return sensitivities(replays, problem.drives, at, {.parameters = {}}).rows;
    }
    Uncertainty uncertainty() const {
        const Deviation origin = problem.replays.origin();
        return uncertaintyAt(problem.replays, problem.drives, origin, rows(origin, file.step), endsOf(problem.drives));
    }
};

TEST(Step, OfReplaysLooksLikeNoEffectWhateverTheCarHas) {
    const Drives drives;
    const Problem& problem = drives.problem;
    ASSERT_EQ(problem.drives.size(), 4u);
    const Deviation origin = problem.replays.origin();
    const Uncertainty uncertainty = drives.uncertainty();
    for (std::size_t e = 0; e < problem.effects.size(); ++e) {
        const std::string& name = problem.effects[e].name;
        Deviation at = origin;
        for (const Eigen::Index k : problem.knobs[e]) at(k) = problem.replays.parameters[k].highest >= 1 ? 1 : -1;
        const Rows usual = drives.rows(at, drives.file.step), fine = drives.rows(at, kFineStep);
        double squares = 0;
        for (std::size_t d = 0; d < usual.size(); ++d) {
            ASSERT_EQ(usual[d].size(), fine[d].size()) << name;
            ASSERT_GT(fine[d].size(), 0) << name;
            squares += squaresOf(uncertainty, d, uncertainty.noise[d].over(usual[d] - fine[d]), uncertainty.sizes);
        }
        EXPECT_LT(0.5 * squares, kMostNats) << name;
    }
}

// Columns of the effects that these drives show, from replays with twice the usual step.
TEST(Step, OfTheReplaysBehindAColumnHardlyChangesIt) {
    const Drives drives;
    const Problem& problem = drives.problem;
    std::vector<Eigen::Index> knobs;
    for (const std::vector<Eigen::Index>& of_effect : problem.knobs)
        knobs.insert(knobs.end(), of_effect.begin(), of_effect.end());
    const auto about = [&](double step) {
        Replays replays = problem.replays;
        replays.replayer.step = step;
        return sensitivities(replays, problem.drives, problem.replays.origin(),
                             {.parameters = knobs, .step = kEffectStep});
    };
    const diagnose::model::Sensitivities usual = about(drives.file.step), fine = about(kFineStep);
    const Uncertainty uncertainty = drives.uncertainty();
    int shown = 0;
    for (const Eigen::Index knob : knobs) {
        double off = 0, whole = 0;
        for (std::size_t d = 0; d < problem.drives.size(); ++d) {
            const auto squares = [&](const Eigen::VectorXd& column) {
                return squaresOf(uncertainty, d, uncertainty.noise[d].over(column), uncertainty.sizes);
            };
            off += squares(usual.columns[d].col(knob) - fine.columns[d].col(knob));
            whole += squares(fine.columns[d].col(knob));
        }
        if (0.5 * whole < diagnose::kSettings.effect) continue;
        ++shown;
        EXPECT_LT(off, kMostOff * kMostOff * whole) << problem.replays.parameters[knob].path();
    }
    EXPECT_GT(shown, 50);
}

}  // namespace
}  // namespace tread::step_test
