// Nuisances of one drive only: the wind differs from drive to drive, and a common wind is a mixture of these.

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "diagnose/model/problem.h"
#include "shared/simple_car.h"

namespace tread::diagnose_each_drive_test {
namespace {

using diagnose::model::Deviation;
using diagnose::model::mixture;
using diagnose::model::nuisancesOfTheWind;
using diagnose::model::Parameter;
using diagnose::model::Problem;
using diagnose::model::problemOf;
using diagnose::model::Sensitivities;

// The simple car, slowed by head wind and turned by side wind.
void driveInWind(const VehicleParams& car, const Scenario& scenario, const Recorder& recorder, const Pushing&) {
    const std::vector<Column> columns = recordedColumns(scenario.log.channels);
    recorder.begin(columns);
    const auto rows = static_cast<int>(*scenario.phases.back().until.duration / scenario.step) + 1;
    for (int k = 0; k <= rows; ++k) {
        const double t = k * scenario.step;
        std::vector<double> row(columns.size(), 0);
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (columns[i].name == "time") row[i] = t;
            if (columns[i].name == "chassis.vx")
                row[i] = scenario.start.speed - 0.01 * car.aero.drag_area * (10 - scenario.wind.x) * t;
            if (columns[i].name == "chassis.yaw_rate") row[i] = 0.01 * scenario.wind.y;
        }
        recorder.row(row);
    }
}

Problem windy(simple_car::Case& made, const std::vector<diagnose::catalogue::Effect>& effects = {}) {
    const VehicleParams truth = made.nominal.vehicle;
    made = simple_car::recorded(truth, {simple_car::slalom(15), simple_car::slalom(20)}, 1, driveInWind);
    diagnose::Options options = simple_car::options();
    options.simulate = driveInWind;
    return problemOf(made.nominal, made.file, made.recorded, effects, options);
}

TEST(Wind, HasAPartOfTheDayAndOneOfEachDriveAlone) {
    simple_car::Case made;
    const Problem problem = windy(made);
    std::vector<Parameter> winds = nuisancesOfTheWind(made.nominal, {}, problem.drives);
    ASSERT_EQ(winds.size(), 6u) << "two components of the day and in two drives";
    EXPECT_EQ(winds[0].name(), "wind.x");
    EXPECT_TRUE(winds[0].of_the_day);
    EXPECT_EQ(winds[1].name(), "wind.x in drive 1");
    EXPECT_NEAR(std::hypot(winds[0].moves.front().by, winds[1].moves.front().by), 1.5, 0.01)
        << "standard deviation, m/s";
    for (const std::size_t d : {0u, 1u}) EXPECT_TRUE(winds[0].concerns(problem.drives[d]));
    EXPECT_TRUE(winds[1].concerns(problem.drives[0]));
    EXPECT_FALSE(winds[1].concerns(problem.drives[1]));
    EXPECT_TRUE(nuisancesOfTheWind(made.nominal, {{"wind.*", 0, 0}}, problem.drives).empty())
        << "a file can say that the wind is known";

    Deviation at = problem.replays.origin();
    for (Eigen::Index i = 0; i < at.size(); ++i)
        if (problem.replays.parameters[i].name() == "wind.y in drive 2") at(i) = 2;
    EXPECT_EQ(problem.replays.subjectAt(at, problem.drives[0]).wind.y, 0);
    EXPECT_NEAR(problem.replays.subjectAt(at, problem.drives[1]).wind.y, 2 * 1.5 * std::sqrt(0.5), 0.01);
}

TEST(Wind, OfADriveChangesTheRowsOfThatDriveAloneAndCostsNoReplayOfTheOthers) {
    simple_car::Case made;
    const Problem problem = windy(made);
    std::vector<Eigen::Index> winds;
    for (Eigen::Index i = 0; i < std::ssize(problem.replays.parameters); ++i)
        if (problem.replays.parameters[i].only) winds.push_back(i);
    ASSERT_EQ(winds.size(), 4u);
    const int before = problem.replays.simulations.value();
    const Sensitivities about =
        sensitivities(problem.replays, problem.drives, problem.replays.origin(), {.parameters = winds});
    EXPECT_EQ(problem.replays.simulations.value() - before, 2 * 2 + 4)
        << "each drive with the usual step and a coarse one, and each wind in its drive";
    const std::vector<Eigen::MatrixXd> alone =
        columnsAt(problem.replays, problem.drives, problem.replays.origin(), winds, diagnose::model::kNuisanceStep);
    for (std::size_t d = 0; d < 2; ++d) EXPECT_EQ(alone[d], about.columns[d](Eigen::all, winds)) << d;
    EXPECT_EQ(problem.replays.simulations.value() - before, 2 * 2 + 4 + 2 + 4) << "no drive with the usual step";
    for (const Eigen::Index p : winds) {
        const Parameter& wind = problem.replays.parameters[p];
        for (std::size_t d = 0; d < 2; ++d) {
            const auto& channels = problem.drives[d].channels;
            const auto yaw = std::find_if(channels.begin(), channels.end(),
                                          [](const auto& c) { return c.name == "chassis.yaw_rate"; });
            const Eigen::VectorXd column = about.columns[d].col(p);
            if (!wind.concerns(problem.drives[d])) EXPECT_TRUE(column.isZero(0)) << wind.name();
            else if (wind.path() == "wind.y")
                EXPECT_NEAR(column(yaw->first_row + 5), 0.01 * wind.moves.front().by, 1e-9) << wind.name();
            else EXPECT_GT(column.norm(), 0) << wind.name();
        }
    }
}

TEST(Wind, OfAnEffectIsThatOfTheDayOrThoseOfAllDrives) {
    simple_car::Case made;
    const Problem problem =
        windy(made, {{"wind", "", "", {{.paths = {"wind.x"}, .typical = 4}, {.paths = {"wind.y"}, .typical = 4}}}});
    const auto& all = problem.replays.parameters;
    ASSERT_EQ(problem.knobs.size(), 1u);
    std::vector<Eigen::Index> nuisances = problem.nuisances;
    const auto expectSameWind = [&](std::size_t parts, const char* why) {
        for (const Eigen::Index knob : problem.knobs[0]) {
            const auto shares = mixture(all[knob], all, nuisances);
            ASSERT_EQ(shares.size(), parts) << why;
            for (const auto& share : shares) {
                EXPECT_EQ(all[share.of].path(), all[knob].path());
                EXPECT_NEAR(share.units * all[share.of].moves.front().by, 4, 1e-12);
            }
        }
    };
    expectSameWind(1, "that of the day");
    std::erase_if(nuisances, [&](Eigen::Index i) { return all[i].of_the_day; });
    expectSameWind(2, "one of each drive");
    std::erase_if(nuisances, [&](Eigen::Index i) { return all[i].name() == "wind.x in drive 2"; });
    EXPECT_TRUE(mixture(all[problem.knobs[0][0]], all, nuisances).empty())
        << "the wind of one drive is not the other's";
}

}  // namespace
}  // namespace tread::diagnose_each_drive_test
