// Where a gap lies and what force is missing, on rows whose energies are computed by hand.
#include "diagnose/explain/where.h"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <numbers>

#include "diagnose/explain/missing_force.h"
#include "inference/ornstein_uhlenbeck.h"
#include "shared/simple_car.h"

namespace tread::diagnose_where_test {
namespace {

using diagnose::answer::Shares;
using diagnose::answer::WhereItLies;
using diagnose::explain::MissingForce;
using diagnose::explain::missingForce;
using diagnose::explain::whereItLies;
using diagnose::model::Disturbed;
using diagnose::model::Problem;
using diagnose::select::Calibration;
using recording::kBlock;
using recording::RecordedDrive;
using recording::Recording;

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kSame = 1e-12;
constexpr double kPi = std::numbers::pi;

// Drives of which only what was measured matters: the nominal car does nothing.
struct Gaps {
    std::deque<Recording> recordings;
    Problem problem;
    Calibration car{problem, {}, {}, {}, {}, {}, {}};

    Gaps() { problem.replays.replayer.nominal = simple_car::Case{}.nominal; }

    // Channels with their rows one behind the other; `deviations`: of the noise of each channel.
    void add(const std::string& name, const std::vector<std::pair<std::string, VectorXd>>& channels,
             const std::vector<double>& deviations) {
        RecordedDrive& drive = problem.drives.emplace_back();
        drive.recording = &recordings.emplace_back();
        drive.name = name;
        diagnose::model::RowNoise& noise = car.uncertainty.noise.emplace_back();
        for (const auto& [channel, values] : channels) {
            std::vector<double> times;
            for (Index i = 0; i < values.size(); ++i) times.push_back((static_cast<double>(i) + 0.5) * kBlock);
            const Index first = drive.measured.size();
            drive.channels.push_back(
                {.name = channel, .measured = {}, .noise = 0, .first_row = first, .times = std::move(times)});
            drive.measured.conservativeResize(first + values.size());
            drive.measured.tail(values.size()) = values;
            noise.deviation.conservativeResize(first + values.size());
            noise.deviation.tail(values.size()).setConstant(deviations[noise.ends.size()]);
            noise.ends.push_back(first + values.size());
        }
        drive.time = {0, 100};
        drive.log = {{{"time", "s", drive.time}}};
        car.nominal.emplace_back(VectorXd::Zero(drive.rows()));
        car.uncertainty.sizes.fill(1);
        car.uncertainty.disturbing.emplace_back();
        car.uncertainty.directions.emplace_back(MatrixXd::Zero(drive.rows(), 1));
        car.about.columns.emplace_back(drive.rows(), 0);
    }
    Shares bandsOf(const VectorXd& values) {
        add("drive", {{"chassis.ay", values}}, {1});
        return whereItLies(car, {}).bands;
    }
};

TEST(Where, EnergyIsWhatIsLeftOverTheNoiseByChannelAndDrive) {
    Gaps gaps;
    // Over the noise: (1, 2, 3, 2) and (3, -1, 0, 1); (0.5, 1, 0, 1) and (4, 0, 2, 0).
    gaps.add("first", {{"chassis.ay", VectorXd{{0.1, 0.2, 0.3, 0.2}}}, {"chassis.vx", VectorXd{{6, -2, 0, 2}}}},
             {0.1, 2});
    gaps.add("second", {{"chassis.ay", VectorXd{{0.05, 0.1, 0, 0.1}}}, {"chassis.vx", VectorXd{{8, 0, 4, 0}}}},
             {0.1, 2});
    const WhereItLies where = whereItLies(gaps.car, {});
    // Squares less one a row: 18 - 4 = 14 and 11 - 4 = 7; 2.25 - 4 < 0 and 20 - 4 = 16.
    EXPECT_NEAR(where.channels.at("chassis.ay"), 14 / 37.0, kSame);
    EXPECT_NEAR(where.channels.at("chassis.vx"), 23 / 37.0, kSame);
    EXPECT_NEAR(where.recordings.at("first"), 21 / 37.0, kSame);
    EXPECT_NEAR(where.recordings.at("second"), 16 / 37.0, kSame);
    EXPECT_NEAR(where.channels_of_recording.at("first").at("chassis.vx"), 7 / 37.0, kSame);
    EXPECT_FALSE(where.channels_of_recording.at("second").contains("chassis.ay")) << "no more than noise";
}

// Rows share the energy of their channel in proportion to their squares.
TEST(Where, RegimesShareTheEnergyRowByRow) {
    Gaps gaps;
    gaps.add("drive", {{"chassis.vx", VectorXd{{3, 3, 6, 1}}}}, {1});
    RecordedDrive& drive = gaps.problem.drives.front();
    drive.time = {0.025, 0.075, 0.125, 0.175};
    drive.log = {{{"time", "s", drive.time},
                  {"chassis.ay", "m/s2", {0, -3, 5, 0}},
                  {"chassis.ax", "m/s2", {0, -9, -9, -2}},
                  {"driver.steering_wheel_angle", "rad", {0, 0, 0, 0}}}};
    const WhereItLies where = whereItLies(gaps.car, {});
    EXPECT_NEAR(where.regimes.at("gentle"), 9 / 55.0, kSame);
    EXPECT_NEAR(where.regimes.at("lateral acceleration 2 to 4 m/s2"), 9 / 55.0, kSame);
    EXPECT_NEAR(where.regimes.at("lateral acceleration above 4 m/s2"), 36 / 55.0, kSame);
    EXPECT_NEAR(where.regimes.at("braking above 1.5 m/s2"), 1 / 55.0, kSame);
    EXPECT_NEAR(where.phases.at("straight"), 1, kSame);
}

VectorXd wave(double frequency, double amplitude) {
    VectorXd rows(160);  // 8 s: whole periods of every eighth of a hertz
    for (Index i = 0; i < rows.size(); ++i)
        rows(i) = amplitude * std::sin(2 * kPi * frequency * kBlock * static_cast<double>(i));
    return rows;
}

TEST(Where, PureSineLiesInItsBandAlone) {
    const std::vector<std::pair<double, std::string>> bands{
        {0.125, "below 0.3 Hz"}, {0.5, "0.3 to 1 Hz"}, {1.25, "1 to 3 Hz"}, {6, "above 3 Hz"}};
    for (const auto& [frequency, band] : bands) EXPECT_NEAR(Gaps{}.bandsOf(wave(frequency, 10)).at(band), 1, kSame);
}

// Energy of n rows by Parseval: n a^2 / 2 of a sine, n a^2 of a constant and of rows that alternate (10 Hz).
TEST(Where, BandsShareTheEnergyOfWhatIsAddedUp) {
    VectorXd rows = wave(0.5, 4) + wave(1.25, 2);
    rows.array() += 3;
    for (Index i = 0; i < rows.size(); ++i) rows(i) += i % 2 == 0 ? 5 : -5;
    const Shares bands = Gaps{}.bandsOf(rows);
    EXPECT_NEAR(bands.at("below 0.3 Hz"), 9 / 44.0, kSame);
    EXPECT_NEAR(bands.at("0.3 to 1 Hz"), 8 / 44.0, kSame);
    EXPECT_NEAR(bands.at("1 to 3 Hz"), 2 / 44.0, kSame);
    EXPECT_NEAR(bands.at("above 3 Hz"), 25 / 44.0, kSame);
}

// A drive of 5 s in which each kind of force shows in a channel of its own, a usual size as one standard deviation of
// its noise; from 2.5 s on something pushes, in usual sizes.
MissingForce pushed(double longitudinal, double lateral, double yaw, double roll) {
    constexpr Index kHats = 21;
    const std::vector<std::string> names{"chassis.ax", "chassis.ay", "chassis.yaw_rate", "chassis.roll"};
    const std::vector<double> pushes{longitudinal, lateral, yaw, roll};
    std::vector<std::pair<std::string, VectorXd>> channels;
    for (std::size_t k = 0; k < names.size(); ++k) {
        VectorXd rows = VectorXd::Zero(kHats);
        rows.tail(kHats - 10).setConstant(pushes[k]);
        channels.emplace_back(names[k], rows);
    }
    Gaps gaps;
    gaps.add("drive", channels, {1, 1, 1, 1});
    // Every row a channel of its own to the smoothing.
    auto& noise = gaps.car.uncertainty.noise.front();
    noise.ends.clear();
    for (Index row = 1; row <= 4 * kHats; ++row) noise.ends.push_back(row);
    diagnose::model::Disturbances& disturbing = gaps.car.uncertainty.disturbing.front();
    const MatrixXd correlation_factor = inference::correlationFactor(kHats, 0.25, 0.5);
    MatrixXd& directions = gaps.car.uncertainty.directions.front();
    directions = MatrixXd::Zero(4 * kHats, 5 * kHats + 1);
    for (const Disturbed kind : diagnose::model::kDisturbedKinds) {
        const auto first = static_cast<Index>(placeOf(kind)) * kHats;
        disturbing.hats[placeOf(kind)] = {0.25, first, correlation_factor};
        for (Index hat = 0; hat < kHats; ++hat) {
            disturbing.kinds.push_back(kind);
            disturbing.times.push_back(0.25 * static_cast<double>(hat));
        }
        if (kind != Disturbed::steering) directions.block(first, first, kHats, kHats) = correlation_factor;
    }
    return missingForce(gaps.car);
}

TEST(MissingForce, IsOfTheKindThatPushesAndActsWhileItDoes) {
    const std::vector<std::array<double, 4>> pushes{{12, 0, 0, 0}, {0, 12, 0, 0}, {0, 0, -12, 0}, {0, 0, 0, 12}};
    const std::vector<std::string> kinds{"longitudinal", "lateral", "yaw", "roll"};
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        const auto [longitudinal, lateral, yaw, roll] = pushes[k];
        const MissingForce found = pushed(longitudinal, lateral, yaw, roll);
        EXPECT_NEAR(found.shares.at(kinds[k]), 1, kSame) << kinds[k];
        EXPECT_EQ(found.shares.size(), 4u);
        EXPECT_EQ(found.when.recording, "drive");
        EXPECT_GE(found.when.time, 2.5);
    }
}

TEST(MissingForce, OfAConstantPushAtAnAxleIsThatOfTheAxle) {
    const VehicleParams car = simple_car::Case{}.nominal.vehicle;
    const double a = car.front_axle_distance, b = car.wheelbase - a;
    const auto axles = [&](double force, double at) {  // N, m ahead of the centre of gravity
        const double lateral = force / usualSize(Disturbed::lateral, car);
        return pushed(0, lateral, force * at / usualSize(Disturbed::yaw, car), 0).axles;
    };
    EXPECT_NEAR(axles(900, a).at("front"), 1, 1e-9);
    EXPECT_NEAR(axles(900, -b).at("rear"), 1, 1e-9);
    EXPECT_NEAR(axles(900, 0).at("front"), b * b / (a * a + b * b), 1e-9) << "squares, by the lever";
}

TEST(MissingForce, WithoutAPushNoKindIsLikelierThanAnother) {
    const MissingForce found = pushed(0, 0, 0, 0);
    for (const auto& [kind, share] : found.shares) EXPECT_EQ(share, 0.25) << kind;
    EXPECT_EQ(found.axles.at("front"), 0.5);
}

}  // namespace
}  // namespace tread::diagnose_where_test
