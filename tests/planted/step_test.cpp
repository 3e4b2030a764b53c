// The diagnosis replays drives with longer steps than those in which a car moves: that must not look like an effect.
#include <gtest/gtest.h>

#include <cmath>

#include "blind/drives.h"
#include "blind/measure.h"
#include "diagnose/catalogue/effect.h"
#include "diagnose/model/problem.h"
#include "diagnose/model/replays.h"
#include "diagnose/options.h"
#include "planted/planted.h"
#include "recording/diagnosis_file.h"
#include "recording/recorded_drive.h"

namespace tread {
namespace {

using diagnose::catalogue::effectCatalogue;
using diagnose::model::Deviation;
using diagnose::model::Rows;
using recording::DiagnosisFile;
using recording::recordedDrive;
using recording::Recording;

constexpr double kFineStep = 0.001;  // s
constexpr double kMostNats = 0.5;    // of the 5 that an effect needs

// A car that is equipped with an effect, in turns, in braking and at the limit, on the bench of a diagnosis.
TEST(Step, OfReplaysLooksLikeNoEffectWhateverTheCarHas) {
    Study study;
    Bench& bench = study.bench;
    bench.nominal.vehicle = planted::nominalCar();
    bench.simulate = diagnose::Options{}.simulate;
    DiagnosisFile file;
    file.recordings.reserve(4);
    for (const Drive& drive : blindDrives(DriveSet::all)) {
        const bool wanted = drive.name.starts_with("step_steer_80") || drive.name.starts_with("braking_in_turn") ||
                            drive.name.starts_with("acceleration") || drive.name.starts_with("slow_ramp");
        if (!wanted) continue;
        Recording& recording = file.recordings.emplace_back();
        recording.name = drive.name;
        const Truth truth{.car = bench.nominal, .low_pass = {}, .push = {}};
        bench.drives.push_back(recordedDrive(recording, measure(truth, drive, 1), file));
    }
    ASSERT_EQ(bench.drives.size(), 4u);
    addParameters(study, file, effectCatalogue());
    const auto rows = [&](const Deviation& at, double step) {
        bench.step = step;
        return linearised(bench, at, {.parameters = {}}).rows;
    };
    study.uncertainty = uncertaintyOf(bench, bench.origin(), rows(bench.origin(), file.step));
    for (std::size_t e = 0; e < study.effects.size(); ++e) {
        Deviation at = bench.origin();
        for (const Eigen::Index k : study.knobs[e])
            at(k) = bench.parameters[static_cast<std::size_t>(k)].highest >= 1 ? 1 : -1;
        const Rows usual = rows(at, file.step), fine = rows(at, kFineStep);
        double squares = 0;
        for (std::size_t d = 0; d < usual.size(); ++d) {
            ASSERT_EQ(usual[d].size(), fine[d].size()) << study.effects[e].name;
            ASSERT_GT(fine[d].size(), 0) << study.effects[e].name;
            squares += squaresOf(study.uncertainty, d, study.uncertainty.noise[d].over(usual[d] - fine[d]));
        }
        EXPECT_LT(0.5 * squares, kMostNats) << study.effects[e].name;
    }
}

}  // namespace
}  // namespace tread
