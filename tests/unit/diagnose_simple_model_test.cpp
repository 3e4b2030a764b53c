// The whole diagnosis on a car of two lines: fast, and its answer can be seen by eye.
#include <gtest/gtest.h>

#include "diagnose/diagnosis_json.h"
#include "shared/simple_car.h"

namespace tread {
namespace {

using simple_car::effect;

Diagnosis diagnosed(double ratio, int threads) {
    const simple_car::Case made =
        simple_car::recorded(ratio, loadVehicle(sourceFile("vehicles/compact.yaml")).aero.drag_area, 3);
    return diagnose(made.nominal, made.file, made.logs,
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

TEST(DiagnosisOfASimpleCar, NominalCarHasNothingBeyondTolerance) {
    const Diagnosis d = diagnosed(16.5, 2);
    EXPECT_EQ(d.verdict, Verdict::nothing) << d.answer;
}

TEST(DiagnosisOfASimpleCar, AnswerIsTheSameToTheBitForOneAndTwoThreads) {
    Diagnosis one = diagnosed(14.5, 1), two = diagnosed(14.5, 2);
    one.seconds = two.seconds = 0;
    EXPECT_EQ(diagnosisJson(one).dump(), diagnosisJson(two).dump());
}

}  // namespace
}  // namespace tread
