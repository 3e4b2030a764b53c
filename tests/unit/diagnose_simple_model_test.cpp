// The whole diagnosis on a car of two lines: fast, and its answer can be seen by eye.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>

#include "diagnose/answer/diagnosis.h"
#include "diagnose/answer/diagnosis_json.h"
#include "diagnose/catalogue/effect.h"
#include "diagnose/diagnose.h"
#include "diagnose/model/sensitivity_cache.h"
#include "diagnose/options.h"
#include "shared/scratch.h"
#include "shared/simple_car.h"

namespace tread::diagnose_simple_model_test {
namespace {

using diagnose::answer::Diagnosis;
using diagnose::answer::diagnosisJson;
using diagnose::answer::Estimate;
using diagnose::answer::Verdict;
using diagnose::catalogue::Direction;
using diagnose::catalogue::Effect;

using simple_car::effect;

Diagnosis diagnosed(double ratio, int threads) {
    const simple_car::Case made =
        simple_car::recorded(ratio, loadVehicle(sourceFile("vehicles/compact.yaml")).aero.drag_area, 3);
    return diagnose::diagnosisOf(made.nominal, made.file, made.recorded,
                                 {effect("ratio", "steering.ratio"), effect("drag", "aero.drag_area")},
                                 simple_car::options(threads));
}

TEST(DiagnosisOfASimpleCar, AnotherSteeringRatioIsNamedWithItsSize) {
    const Diagnosis d = diagnosed(14.5, 2);
    EXPECT_EQ(d.verdict, Verdict::explained) << d.answer;
    ASSERT_EQ(d.causes, std::vector<std::string>{"ratio"});
    const Estimate ratio = d.effects.front().parameters.at("steering.ratio");
    EXPECT_NEAR(ratio.value, 14.5, 3 * ratio.sd);
    EXPECT_GT(d.where.channels.at("chassis.yaw_rate"), 0.9);
}

// The mass of this car shows in nothing.
TEST(DiagnosisOfASimpleCar, OneOfTwoEffectsThatChangeTheSameIsNamed) {
    VehicleParams truth = simple_car::Case{}.nominal.vehicle;
    truth.steering.play = 3e-4;
    const simple_car::Case made =
        simple_car::recorded(truth, {simple_car::slalom(15), simple_car::slalom(20), simple_car::slalom(25)}, 3);
    const Effect play{"play", "", "", {{.paths = {"steering.play"}, .typical = 2e-4, .direction = Direction::up}}};
    Effect both = play;
    both.name = "both";
    both.knobs.front().paths.push_back("mass");
    const Diagnosis d =
        diagnose::diagnosisOf(made.nominal, made.file, made.recorded, {both, play}, simple_car::options());
    EXPECT_EQ(d.verdict, Verdict::explained) << d.answer;
    EXPECT_EQ(d.causes, std::vector<std::string>{"play"});
    EXPECT_TRUE(d.alternatives.empty());
}

TEST(DiagnosisOfASimpleCar, NominalCarHasNothingBeyondTolerance) {
    const Diagnosis d = diagnosed(16.5, 2);
    EXPECT_EQ(d.verdict, Verdict::nothing) << d.answer;
}

// Something that a ratio imitates in each drive alone, but not with one value in all.
TEST(DiagnosisOfASimpleCar, WhatChangesFromDriveToDriveIsUnknown) {
    const double drag = loadVehicle(sourceFile("vehicles/compact.yaml")).aero.drag_area;
    simple_car::Case made = simple_car::recorded(16.5, drag, 3);
    constexpr std::array<double, 3> kRatios{14, 19, 16.5};
    for (std::size_t d = 0; d < kRatios.size(); ++d)
        made.recorded.logs[d] = simple_car::recorded(kRatios[d], drag, 5).recorded.logs[d];
    const Diagnosis d = diagnose::diagnosisOf(made.nominal, made.file, made.recorded,
                                              {effect("ratio", "steering.ratio"), effect("drag", "aero.drag_area")},
                                              simple_car::options(2));
    EXPECT_EQ(d.verdict, Verdict::unknown) << d.answer;
    EXPECT_TRUE(d.causes.empty());
    EXPECT_GT(d.probability_of_unknown, 0.5);
}

// A control that acts on cars that are hardly more direct than their file says, and on no others.
void driveWithControl(const VehicleParams& car, const Scenario& scenario, const Recorder& recorder,
                      const Pushing& pushing) {
    VehicleParams controlled = car;
    if (car.steering.ratio > 15.5) controlled.wheelbase *= 1 + 0.2 * car.brakes.stability_control.authority_offset;
    simple_car::drive(controlled, scenario, recorder, pushing);
}

TEST(DiagnosisOfASimpleCar, WhatActsBeyondALimitIsNotPromisedToACarThatStaysWithinIt) {
    const Effect control{
        "control",
        "",
        "",
        {{.paths = {"brakes.stability_control.authority_offset"}, .typical = 1, .direction = Direction::up}}};
    diagnose::Options options = simple_car::options();
    options.simulate = driveWithControl;
    const auto promised = [&](double ratio) {
        simple_car::Case made = simple_car::recorded(ratio, 0.66, 3);
        made.file.tolerances = {{.path = "steering.ratio", .relative = 0.005}};
        return diagnose::diagnosisOf(made.nominal, made.file, made.recorded,
                                     {effect("ratio", "steering.ratio"), control}, options);
    };
    EXPECT_GT(promised(16.5).expected_evidence.at("control"), 100);
    const Diagnosis d = promised(14.5);
    EXPECT_EQ(d.causes, std::vector<std::string>{"ratio"}) << d.answer;
    EXPECT_LT(d.expected_evidence.at("control"), 1);
}

// An axle whose compliance makes the car understeer only when it is far from that of the file.
constexpr double kCompliance = 2e-6;

void driveWithCompliance(const VehicleParams& car, const Scenario& scenario, const Recorder& recorder,
                         const Pushing& pushing) {
    VehicleParams yielding = car;
    const double beyond = std::abs(car.front.suspension.steer_by_lateral_force) / kCompliance - 0.7;
    yielding.steering.play = 2e-4 * std::max(0.0, beyond);
    simple_car::drive(yielding, scenario, recorder, pushing);
}

// The calibrated car, whose ratio does what it can of the effect's work, shows nothing of the effect.
TEST(DiagnosisOfASimpleCar, WhatTheCalibratedCarDoesNotShowIsFoundWhenANumberMovedFarBeyondItsTolerance) {
    diagnose::Options options = simple_car::options();
    options.simulate = driveWithCompliance;
    VehicleParams truth = simple_car::Case{}.nominal.vehicle;
    truth.front.suspension.steer_by_lateral_force = 2.2 * kCompliance;
    const std::vector<Scenario> drives{simple_car::slalom(15), simple_car::slalom(20), simple_car::slalom(25)};
    simple_car::Case made = simple_car::recorded(truth, drives, 4, driveWithCompliance);
    made.nominal.vehicle.front.suspension.steer_by_lateral_force = 0;
    made.file.tolerances = {{.path = "steering.ratio", .relative = 0.01}};
    const Effect compliance{
        "compliance", "", "", {{.paths = {"front.suspension.steer_by_lateral_force"}, .typical = kCompliance}}};
    const Diagnosis d = diagnose::diagnosisOf(made.nominal, made.file, made.recorded,
                                              {effect("drag", "aero.drag_area"), compliance}, options);
    EXPECT_EQ(d.causes, std::vector<std::string>{"compliance"}) << d.answer;
    EXPECT_NEAR(std::abs(d.nuisance.at("steering.ratio").z), 0, 2);
}

TEST(DiagnosisOfASimpleCar, AnswerIsTheSameToTheBitForOneAndTwoThreads) {
    Diagnosis one = diagnosed(14.5, 1), two = diagnosed(14.5, 2);
    one.seconds = two.seconds = 0;
    EXPECT_EQ(diagnosisJson(one).dump(), diagnosisJson(two).dump());
}

TEST(DiagnosisOfASimpleCar, TolerancesAllowWhatTheyDoToItsYawRate) {
    simple_car::Case made = simple_car::recorded(16.5, 0.66, 3);
    made.file.recordings.back().hold_out = true;
    made.file.tolerances = {{.path = "steering.ratio", .relative = 0.2}};
    const Diagnosis d = diagnose::diagnosisOf(made.nominal, made.file, made.recorded,
                                              {effect("drag", "aero.drag_area")}, simple_car::options());
    ASSERT_EQ(d.overlays.size(), 3u);
    EXPECT_TRUE(d.overlays.back().allowed.channels.empty()) << "held out";
    for (std::size_t i = 0; i < 2; ++i) {
        // Yaw rate goes with one over the ratio, whose standard deviation is a fifth over the root of three; the
        // difference is taken over 0.6 of that.
        const double sd = 0.2 / std::sqrt(3), expected = sd / (1 + 0.6 * sd);
        const std::vector<double>&rate = d.overlays[i].nominal.find("chassis.yaw_rate")->values,
              &allowed = d.overlays[i].allowed.find("chassis.yaw_rate")->values;
        const auto most = std::max_element(rate.begin(), rate.end());
        EXPECT_NEAR(allowed[static_cast<std::size_t>(most - rate.begin())], expected * *most, 0.05 * expected * *most);
    }
}

// Sensitivities that were kept by a diagnosis, taken by the next.
class KeptSensitivities : public testing::Test {
protected:
    Scratch scratch;
    simple_car::Case made = simple_car::recorded(14.5, 0.66, 3);

    Diagnosis diagnosed() const {
        diagnose::Options options = simple_car::options();
        options.cache = scratch.path("cache");
        options.simulate = [driven = driven_, simulate = options.simulate](const auto&... all) {
            ++*driven;
            simulate(all...);
        };
        Diagnosis d =
            diagnose::diagnosisOf(made.nominal, made.file, made.recorded,
                                  {effect("ratio", "steering.ratio"), effect("drag", "aero.drag_area")}, options);
        d.seconds = 0;
        return d;
    }
    int driven() const { return driven_->exchange(0); }  // simulations since it was asked last
    std::vector<std::filesystem::path> files() const {
        std::vector<std::filesystem::path> found;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(scratch.folder()))
            if (entry.is_regular_file()) found.push_back(entry.path());
        return found;
    }
    static std::string textOf(const Diagnosis& d) { return diagnosisJson(d).dump(); }

    std::shared_ptr<std::atomic<int>> driven_ = std::make_shared<std::atomic<int>>(0);
};

TEST_F(KeptSensitivities, GiveTheSameAnswerToTheBitWithFewerSimulations) {
    const Diagnosis first = diagnosed();
    const int without = driven();
    const Diagnosis second = diagnosed();
    EXPECT_EQ(textOf(first), textOf(second));
    EXPECT_EQ(first.simulations, second.simulations) << "those that were kept count like new ones";
    const auto columns = static_cast<int>(files().size());
    EXPECT_GT(columns, 0);
    EXPECT_LE(driven(), without - columns) << "each column that was kept saves at least one simulation";
}

TEST_F(KeptSensitivities, OfAnInterruptedDiagnosisAreTakenAndTheRestIsMade) {
    const Diagnosis first = diagnosed();
    const int without = driven();
    std::vector<std::filesystem::path> kept = files();
    for (std::size_t i = 0; i < kept.size(); i += 2) std::filesystem::remove(kept[i]);
    std::filesystem::resize_file(kept[1], 100);  // a disk that was full
    const Diagnosis second = diagnosed();
    EXPECT_EQ(textOf(first), textOf(second));
    EXPECT_LT(driven(), without);
    EXPECT_EQ(files().size(), kept.size());
}

TEST_F(KeptSensitivities, ThatWereNotUsedForLongestGiveWayToTheLimit) {
    diagnosed();
    std::vector<std::filesystem::path> kept = files();
    std::uintmax_t sum = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        sum += std::filesystem::file_size(kept[i]);
        std::filesystem::last_write_time(kept[i],
                                         std::filesystem::file_time_type::clock::now() + std::chrono::hours(i));
    }
    diagnose::model::trimCache(scratch.path("cache"), sum);
    EXPECT_EQ(files().size(), kept.size());
    diagnose::model::trimCache(scratch.path("cache"), sum - 1);
    EXPECT_FALSE(std::filesystem::exists(kept.front()));
    EXPECT_EQ(files().size(), kept.size() - 1);
}

TEST_F(KeptSensitivities, NeedNotBeWritten) {
    const Diagnosis first = diagnosed();
    std::filesystem::remove_all(scratch.path("cache"));
    std::filesystem::create_symlink("/dev/full", scratch.path("cache"));  // no folder, and no room
    EXPECT_EQ(textOf(diagnosed()), textOf(first));
}

TEST_F(KeptSensitivities, AreNotThoseOfAnotherCarOrDrive) {
    diagnosed();
    const std::size_t count = files().size();
    made.nominal.vehicle.wheelbase *= 1.001;
    const int without = driven();
    diagnosed();
    EXPECT_GT(driven(), 9 * without / 10) << "no column of the other car is taken";
    EXPECT_EQ(files().size(), 2 * count);
    made.recorded.logs[0].channels[1].values[150] += 0.01;
    diagnosed();
    EXPECT_GT(driven(), without / 2);
    EXPECT_GT(files().size(), 2 * count);
}

}  // namespace
}  // namespace tread::diagnose_simple_model_test
