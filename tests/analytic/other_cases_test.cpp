// Cases from the other simulator: what is planted under tread's paths, and how it is measured.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "blind/other_measure.h"
#include "diagnose/catalogue/effect.h"
#include "shared/other_car/compact.h"
#include "shared/vehicles.h"

namespace other_car {
namespace {

Truth known() {
    Truth truth;
    truth.car = compact();
    return truth;
}

tread::Drive driveNamed(const std::string& name) {
    for (const tread::Drive& drive : tread::blindDrives())
        if (drive.name == name) return drive;
    throw std::out_of_range(name);
}

Drawn drawnWith(const std::string& effect, std::uint64_t seed = 3) {
    std::vector<tread::diagnose::catalogue::Effect> effects;
    for (const tread::diagnose::catalogue::Effect& one :
         plantable(tread::diagnose::catalogue::effectCatalogue(), reference::compact()))
        if (one.name == effect) effects.push_back(one);
    tread::Random random(seed);
    return draw(known(), reference::compact(), effects, tread::CaseKind::one, random);
}

TEST(OtherCases, ManyEffectsOfTheCatalogueCanBePlanted) {
    const auto effects = plantable(tread::diagnose::catalogue::effectCatalogue(), reference::compact());
    EXPECT_GE(effects.size(), 25u);
    for (const char* name : {"mass", "grip", "tyre_relaxation", "wind", "steering_delay", "gyro_scale", "wheel_radius"})
        EXPECT_TRUE(std::any_of(effects.begin(), effects.end(), [&](const auto& e) { return e.name == name; })) << name;
}

TEST(OtherCases, PlantedNumberOfTheKeyIsThatOfTheCar) {
    const Drawn mass = drawnWith("mass"), gyro = drawnWith("gyro_bias");
    EXPECT_NEAR(mass.truth.car.mass, mass.key.numbers.at("mass").value, 0.003 * 1350);  // errors multiply
    EXPECT_GT(std::abs(mass.key.numbers.at("mass").change), 0.59);
    EXPECT_NEAR(gyro.truth.instruments.yaw_rate.bias, gyro.key.numbers.at("instruments.yaw_rate.bias").value, 1e-12);
}

TEST(OtherCases, EmptyCaseErrsInEveryNumberOnlyALittle) {
    tread::Random random(1);
    Drawn none = draw(known(), reference::compact(), {}, tread::CaseKind::none, random);
    EXPECT_TRUE(none.key.effects.empty());
    EXPECT_NE(none.truth.car.mass, 1350);
    EXPECT_NEAR(none.truth.car.mass, 1350, 0.02 * 1350);
    EXPECT_NE(none.truth.car.rear.tyre.stiffness, compact().rear.tyre.stiffness);
}

TEST(OtherCases, InstrumentsReadWhatTheirNumbersSay) {
    const tread::Drive drive = driveNamed("step_steer_80");
    Truth read = known();
    read.instruments.yaw_rate = {.gain = 1.1, .bias = 0.01, .delay = 0.05};
    const tread::Log plain = measure(known(), drive, 1, tread::kIdeal), other = measure(read, drive, 1, tread::kIdeal);
    const auto &yaw = plain.find("chassis.yaw_rate")->values, &shown = other.find("chassis.yaw_rate")->values;
    for (std::size_t i = 5; i < yaw.size(); i += 20) EXPECT_NEAR(shown[i], 1.1 * yaw[i - 5] + 0.01, 1e-12);
}

TEST(OtherCases, AccelerationElsewhereFollowsFromYawing) {
    // In a steady turn a unit x ahead of the centre reads r^2 x less along the car.
    const tread::Drive drive = driveNamed("step_steer_80");
    Truth ahead = known();
    ahead.instruments.inertial_unit.x = 1;
    const tread::Log plain = measure(known(), drive, 1, tread::kIdeal), other = measure(ahead, drive, 1, tread::kIdeal);
    const std::size_t steady = 380;
    const double r = plain.find("chassis.yaw_rate")->values[steady];
    EXPECT_NEAR(other.find("chassis.ax")->values[steady] - plain.find("chassis.ax")->values[steady], -r * r, 1e-9);
}

TEST(OtherCases, LateSteeringIsTheSameDriveLater) {
    const tread::Drive drive = driveNamed("step_steer_80");
    Truth late = known();
    late.steering_delay = 0.05;
    const tread::Log plain = measure(known(), drive, 1, tread::kIdeal), other = measure(late, drive, 1, tread::kIdeal);
    const auto &yaw = plain.find("chassis.yaw_rate")->values, &later = other.find("chassis.yaw_rate")->values;
    for (std::size_t i = 55; i < 120; i += 5) EXPECT_NEAR(later[i], yaw[i - 5], 2e-4);
    EXPECT_EQ(plain.find("driver.steering_wheel_angle")->values, other.find("driver.steering_wheel_angle")->values);
}

TEST(OtherCases, HeadwindAndGradeHoldTheCarBack) {
    const tread::Drive drive = driveNamed("coast_down_120");
    Truth wind = known(), grade = known();
    wind.car.wind_x = -5;
    grade.car.grade = 0.02;
    const double v = 120 / 3.6, p = known().car.drag_area * known().car.air_density / 2;
    const auto ax = [&](const Truth& truth) {
        return measure(truth, drive, 1, tread::kIdeal).find("chassis.ax")->values[20];
    };
    const Params car = known().car;
    const double turning =
        2 * (car.front.wheel_inertia + car.rear.wheel_inertia) + car.engine_inertia * car.drive_ratio * car.drive_ratio;
    const double mass = car.mass + turning / (car.front.tyre.rolling_radius * car.front.tyre.loaded_radius);
    EXPECT_NEAR(ax(wind) - ax(known()), -p * ((v + 5) * (v + 5) - v * v) / mass, 1e-3);
    EXPECT_NEAR(ax(grade) - ax(known()), -0.02 * kGravity * car.mass / mass, 1e-3);
}

TEST(OtherCases, RepeatsAndNoiseDifferAndTheSameSeedIsTheSame) {
    const tread::Drive drive = driveNamed("step_steer_80");
    const tread::Log a = measure(known(), drive, 1), b = measure(known(), drive, 1), c = measure(known(), drive, 2);
    EXPECT_EQ(a.find("chassis.ay")->values, b.find("chassis.ay")->values);
    EXPECT_NE(a.find("chassis.ay")->values, c.find("chassis.ay")->values);
}

}  // namespace
}  // namespace other_car
