// Numbers that describe no car are refused, whatever number it is; what is taken drives, or the simulation says why
// not.
#include "base/fields/possible.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "base/fields/numbers.h"
#include "base/text/byte_limit.h"
#include "base/yaml/read.h"
#include "base/yaml/schema.h"
#include "base/yaml/setting.h"
#include "run/simulate.h"
#include "shared/equipped_car.h"
#include "shared/vehicles.h"
#include "vehicle/fields.h"

namespace tread::possible_test {
namespace {

TEST(Possible, SizesAreWithinAFactorOf1000OfWhatIsPlausible) {
    const Usual mass{3, 4e4, true};
    EXPECT_TRUE(isPossible(mass, 0.003));
    EXPECT_FALSE(isPossible(mass, 0.0029));
    EXPECT_TRUE(isPossible(mass, 4e7));
    EXPECT_FALSE(isPossible(mass, 4.1e7));
    EXPECT_TRUE(isPossible(mass, -3)) << "the sign is the limits' business";
    EXPECT_FALSE(isPossible(mass, -1e-308));
    for (const double none : {0.0, kInfinity, -kInfinity}) EXPECT_TRUE(isPossible(mass, none));
    const Usual slope{-0.2, 0.1, true};
    EXPECT_TRUE(isPossible(slope, 1e-308)) << "as good as 0";
    EXPECT_TRUE(isPossible(slope, 200));
    EXPECT_FALSE(isPossible(slope, -201));
    EXPECT_TRUE(isPossible({}, 1e308));
    EXPECT_TRUE(isPossible({.said = true}, 1e308));
}

TEST(Possible, WhatIsFoundAndExpectedIsSaid) {
    EXPECT_EQ(
        impossibleText(1e-308, "1e-308", "kg m2", {0.001, 5, true}),
        "found \"1e-308\", expected a number in kg m2 between 1.0e-06 and 5000 in size, within a factor of 1000 of "
        "what is plausible; correct value or unit");
    EXPECT_EQ(impossibleText(2.2, "2.2", "Pa", {2e4, 1.2e6, true}),
              "found \"2.2\", expected a number in Pa between 20 and 1200000000 in size, within a factor of 1000 of "
              "what is plausible; did you mean \"2.2 bar\"?");
    EXPECT_EQ(impossibleText(1e4, "", "m", {-1, 1, true}),
              "found \"10000\", expected a number in m of at most 1000 in size, within a factor of 1000 of what is "
              "plausible; correct value or unit");
}

struct Part {
    double ratio = 15, gain = 0;
    int gears = 5;
    Curve torque = {{{0, 100}}};

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(ratio), About{"-", "ratio", kPositive}.usually(0.5, 40));
        field(TREAD_FIELD(gain), About{"-", "gain", kAny}.usually(-2, 2));
        field(TREAD_FIELD(gears), About{"-", "gears", {1, 1e9}}.usually(1, 20));
        field(TREAD_FIELD(torque), About{"N m", "torque", kAny, 0, "rad/s"}.usually(1, 1e4).over(0, 4e3));
    }
};
static_assert(describesEveryMember<Part>());

std::string faultOf(const std::string& text) {
    try {
        readYamlText<Part>(text, "part.yaml");
        return "";
    } catch (const LoadError& error) {
        return error.what();
    }
}

TEST(Possible, FileIsRefusedWithThePlace) {
    EXPECT_EQ(faultOf("ratio: 1e-308\n"),
              "part.yaml:1:8: ratio: found \"1e-308\", expected a number between 0.0005 and 40000 in size, within a "
              "factor of 1000 of what is plausible; correct value or unit");
    EXPECT_EQ(faultOf("ratio: 0.001\ngain: 2000\ngears: 20000\n"), "");
    EXPECT_NE(faultOf("gain: -2001\n").find("part.yaml:1:7: gain: "), std::string::npos);
    EXPECT_NE(faultOf("gears: 20001\n").find("part.yaml:1:8: gears: "), std::string::npos);
    EXPECT_NE(faultOf("torque: [[0, 1e-9]]\n").find("part.yaml:1:14: torque.0.y: "), std::string::npos);
    EXPECT_NE(faultOf("torque: [[0, 1], [1e8, 1]]\n").find("part.yaml:1:19: torque.1.x: "), std::string::npos);
}

TEST(Possible, SchemaSaysIt) {
    const std::string schema = jsonSchema<Part>("Part", "part");
    EXPECT_NE(schema.find(R"("type": "number", "minimum": 0.0005, "maximum": 40000)"), std::string::npos) << schema;
    EXPECT_NE(schema.find(R"("type": "number", "minimum": -2000, "maximum": 2000)"), std::string::npos) << schema;
}

// Swerves and brakes within a moment.
Scenario swerve() {
    return readYamlText<Scenario>(R"(start: {speed: 20}
log: {rate: 100}
phases:
  - name: swerve
    steering: {ramp: {to: 1, rate: 30}}
    throttle: {constant: {value: 0.7}}
    until: {duration: 0.05 s}
  - name: brake
    throttle: {constant: {value: 0}}
    brake: {ramp: {to: 0.6, rate: 30}}
    until: {duration: 0.02 s}
)",
                                  "swerve.yaml");
}

std::string noListing(std::string_view) {
    return "";
}

// What drives is a car still, beyond the bounds that the simulation itself sets (Health).
void expectSane(const Log& log) {
    for (const Channel& channel : log.channels)
        for (const double value : channel.values)
            if (!std::isfinite(value) || std::abs(value) > 1e12) {
                ADD_FAILURE() << channel.name << " is " << value;
                return;
            }
}

TEST(Possible, NoNumberOfACarMakesAnAbsurdDrive) {
    VehicleParams car = shared::withEverything(reference::compact());
    const Scenario scenario = swerve();
    int refused = 0, broke_down = 0, drove = 0;
    for (const Number& number : numbers(car)) {
        if (number.path.starts_with("rear.")) continue;  // described as the front ones
        for (const std::string value : {"1e-308", "1e308", "-1"}) {
            SCOPED_TRACE(number.path + "=" + value);
            VehicleParams changed = car;
            try {
                applySettings(changed, std::vector{number.path + "=" + value}, "--set", noListing);
                expectSane(simulate(changed, scenario, MovedBy::itself));
                ++drove;
            } catch (const LoadError& error) {
                EXPECT_FALSE(error.problems().empty());
                ++refused;
            } catch (const SimulationError&) {
                ++broke_down;
            }
        }
    }
    std::printf("%d refused, %d broke down, %d drove\n", refused, broke_down, drove);
    EXPECT_GT(refused, 400);
    EXPECT_GT(broke_down, 20) << "beyond what one number can tell";
}

TEST(ByteLimit, IsAWholeNumberOrASentence) {
    const auto limit = [](const char* text) {
        setenv("TREAD_LARGEST_TEST", text, 1);
        return byteLimit("TREAD_LARGEST_TEST", 7);
    };
    EXPECT_EQ(byteLimit("TREAD_LARGEST_NOTHING", 7), 7u);
    EXPECT_EQ(limit("2000000000"), 2000000000u);
    EXPECT_EQ(limit("0"), 0u);
    for (const char* const text : {"", "2 GB", "-1", "1e9", "99999999999999999999", " 5"}) {
        try {
            limit(text);
            ADD_FAILURE() << text;
        } catch (const LoadError& error) {
            EXPECT_EQ(std::string(error.what()), "TREAD_LARGEST_TEST: found \"" + std::string(text) +
                                                     "\", expected a whole number of bytes, such as 2000000000; "
                                                     "correct or unset this variable of the environment");
        }
    }
    unsetenv("TREAD_LARGEST_TEST");
}

}  // namespace
}  // namespace tread::possible_test
