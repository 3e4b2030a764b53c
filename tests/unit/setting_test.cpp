#include "base/yaml/setting.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "shared/described_samples.h"
#include "tread/tyre.h"
#include "tread/wheels.h"

// Not an anonymous namespace: clang 14 wants to see conversions to a type without linkage defined.
namespace tread::setting_test {

using sample::Damper, sample::Drive, sample::Keep, sample::Ramp;

struct Axle {
    Damper damper{100, 0};
    static constexpr void describe(auto& self, auto&& field) { field(TREAD_FIELD(damper), About{"", "damper"}); }
};

struct Car {
    std::string name;
    Drive drive = Drive::front;
    bool locked = false;
    int gears = 5;
    double low = 1;
    double high = 2;
    Axle front;
    Axle rear;
    Curve torque;
    std::vector<Damper> extra{{1, 0}, {2, 0}};
    std::variant<Keep, Ramp> steer;
    std::optional<double> lag;
    std::optional<Damper> cab;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(name), About{"", "name"});
        field(TREAD_FIELD(drive), About{"", "driven axle"});
        field(TREAD_FIELD(locked), About{"", "locked differential"});
        field(TREAD_FIELD(gears), About{"-", "number of gears", Limits{1, 10}});
        field(TREAD_FIELD(low), About{"m", "low"});
        field(TREAD_FIELD(high), About{"m", "high"});
        field(TREAD_FIELD(front), About{"", "front axle"});
        field(TREAD_FIELD(rear), About{"", "rear axle"});
        field(TREAD_FIELD(torque), About{"N m", "engine torque", kAny, 0, "rad/s"});
        field(TREAD_FIELD(extra), About{"", "further dampers"});
        field(TREAD_FIELD(steer), About{"", "steering"});
        field(TREAD_FIELD(lag), About{"s", "lag", kPositive});
        field(TREAD_FIELD(cab), About{"", "damper of the cab"});
    }
    static void check(const auto& self, auto&& complain) {
        if (self.low >= self.high) complain("low", "found low >= high, expected less; correct one of the two");
    }
};
static_assert(describesEveryMember<Car>());

std::string listing(std::string_view path) {
    return "look for " + std::string(path);
}

template <Described T>
void set(T& object, const std::vector<std::string>& assignments) {
    applySettings(object, assignments, "--set", listing);
}

template <Described T>
std::string faultOf(T& object, const std::vector<std::string>& assignments) {
    try {
        set(object, assignments);
        ADD_FAILURE() << "no fault was found";
        return {};
    } catch (const LoadError& error) {
        return error.what();
    }
}

TEST(Setting, FieldsOfEveryKindAreSetByPath) {
    Car car;
    set(car, {"front.damper.bump=1800", "rear.damper.bump = 1.8 kN s/m", "gears=4", "locked=true", "drive=rear",
              "name=a: b # c", "extra.1.friction=7", "steer.keep.tolerance=50 %", "lag=20 ms",
              "torque=[[0, 1], [1000 rpm, 2]]"});
    EXPECT_EQ(car.front.damper.bump, 1800);
    EXPECT_EQ(car.rear.damper.bump, 1800);
    EXPECT_EQ(car.gears, 4);
    EXPECT_TRUE(car.locked);
    EXPECT_EQ(car.drive, Drive::rear);
    EXPECT_EQ(car.name, "a: b # c");
    EXPECT_EQ(car.extra[1].friction, 7);
    EXPECT_EQ(std::get<Keep>(car.steer).tolerance, 0.5);
    EXPECT_EQ(car.lag, 0.02);
    ASSERT_EQ(car.torque.points.size(), 2u);
    EXPECT_EQ(car.torque.points[1].y, 2);
    set(car, {"steer={ramp: {to: 90 deg}}"});
    EXPECT_DOUBLE_EQ(std::get<Ramp>(car.steer).to, 1.5707963267948966);
    set(car, {"steer.ramp.to=1"});
    EXPECT_EQ(std::get<Ramp>(car.steer).to, 1);
    set(car, {"cab={bump: 3}"});
    EXPECT_EQ(car.cab.value().bump, 3);
    set(car, {"cab.friction=4"});
    EXPECT_EQ(car.cab.value().friction, 4);
}

TEST(Setting, WrongValueLeavesTheObjectAsItWas) {
    Car car;
    EXPECT_EQ(faultOf(car, {"gears=3", "front.damper.bump=-1"}),
              "--set: front.damper.bump: found \"-1\", expected a number in N s/m at least 0; correct the value");
    EXPECT_EQ(car.gears, 5);
    EXPECT_EQ(faultOf(car, {"front.damper.bump=3 m"}),
              "--set: front.damper.bump: found a length (\"m\"), expected N s/m; correct the unit");
    EXPECT_EQ(faultOf(car, {"drive=reer"}),
              "--set: drive: found \"reer\", expected front, rear or all; did you mean \"rear\"?");
    EXPECT_EQ(faultOf(car, {"gears="}),
              "--set: gears: found nothing, expected a whole number from 1 to 10; write digits only");
    EXPECT_EQ(faultOf(car, {"front=3"}), "--set: front: found \"3\", expected a map; write \"key: value\" lines");
    EXPECT_EQ(car.front.damper.bump, 100);
}

TEST(Setting, UnknownPathNamesTheLikelyOnesAndWhereTheyAreListed) {
    Car car;
    EXPECT_EQ(faultOf(car, {"front.damper.bmup=1"}),
              "--set: front.damper.bmup: found the unknown path \"front.damper.bmup\", expected the path of a field; "
              "did you mean \"front.damper.bump\"? look for front.damper.bump");
    EXPECT_EQ(faultOf(car, {"damper.bump=1"}),
              "--set: damper.bump: found the unknown path \"damper.bump\", expected the path of a field; did you mean "
              "front.damper.bump or rear.damper.bump? look for front.damper.bump");
    EXPECT_EQ(faultOf(car, {"quux=1"}),
              "--set: quux: found the unknown path \"quux\", expected the path of a field; look for quux");
    for (const char* assignment : {"extra.2.bump=1", "extra.-1.bump=1", "extra.x.bump=1", "steer.ramp.to=1",
                                   "gears.x=1", "front..damper=1", ".front=1"}) {
        EXPECT_NE(faultOf(car, {assignment}).find("found the unknown path"), std::string::npos) << assignment;
    }
}

TEST(Setting, ElementsThatAreNotThereAndOtherChoicesAreToldApartFromMistypedPaths) {
    Car car;
    for (const char* path : {"extra.2.bump", "steer.ramp.to"}) {
        EXPECT_EQ(faultOf(car, {std::string(path) + "=1"}),
                  std::string("--set: ") + path + ": found the unknown path \"" + path +
                      "\", which belongs to an element that is not there or to another choice than the one made; set "
                      "the whole of it, as {key: value}");
    }
    EXPECT_NE(faultOf(car, {"extra.2.bmup=1"}).find("did you mean \"extra.2.bump\"?"), std::string::npos);
}

TEST(Setting, TextThatIsNoAssignmentIsRefused) {
    Car car;
    for (const char* text : {"", "gears", "=3", " = ", "gears.=1"}) {
        EXPECT_NE(faultOf(car, {text}).find("expected path=value; look for "), std::string::npos) << text;
    }
    EXPECT_NE(faultOf(car, {"torque=[[1, 2]"}).find("found text that is not YAML"), std::string::npos);
}

TEST(Setting, RulesAcrossFieldsSeeAllNewValues) {
    Car car;
    EXPECT_EQ(faultOf(car, {"low=5"}), "--set: low: found low >= high, expected less; correct one of the two");
    set(car, {"low=5", "high=6"});
    EXPECT_EQ(car.low, 5);
    EXPECT_EQ(car.high, 6);
}

TEST(Setting, WhatANewPartRequiresMustBeGivenWithIt) {
    Car car;
    EXPECT_EQ(
        faultOf(car, {"cab.friction=4"}),
        "--set: cab.bump: found no value, expected a number in N s/m (damping in compression); add \"bump: <number>\"");
    EXPECT_FALSE(car.cab);
    EXPECT_NE(faultOf(car, {"steer=ramp"}).find("--set: steer.ramp.to: found no value"), std::string::npos);
}

TEST(Setting, IncompleteObjectMayStayIncomplete) {
    TyreParams tyre;
    set(tyre, {"parameters.Fzo=4 kN"});
    set(tyre, {"side=right"});
    EXPECT_EQ(tyre.parameters.Fzo, 4000);
    EXPECT_EQ(tyre.side, TyreSide::right);
}

TEST(Setting, SeveralFaultsAreReportedTogether) {
    Car car;
    EXPECT_EQ(faultOf(car, {"gears=x", "drve=rear"}),
              "--set: gears: found \"x\", expected a whole number from 1 to 10; write digits only\n"
              "--set: drve: found the unknown path \"drve\", expected the path of a field; did you mean \"drive\"? "
              "look for drive");
}

}  // namespace tread::setting_test
