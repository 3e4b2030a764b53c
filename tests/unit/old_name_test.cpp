// Fields that were renamed: files and settings with the old name are still read.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/yaml/read.h"
#include "base/yaml/setting.h"
#include "base/yaml/write.h"
#include "places/places.h"
#include "shared/scratch.h"
#include "tread/load.h"

// Not an anonymous namespace: clang 14 wants to see conversions to a type without linkage defined.
namespace tread::old_name_test {

struct Body {
    double centre_height = kRequired;
    double width = 2;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(centre_height),
              About{.unit = "m", .meaning = "height of the centre", .limits = kPositive, .old_name = "height"});
        field(TREAD_FIELD(width), About{"m", "width", kPositive});
    }
    static void check(const auto& self, auto&& complain) {
        if (self.centre_height > self.width) complain("centre_height", "found more than the width; lower it");
    }
};
static_assert(describesEveryMember<Body>());

struct Car {
    Body body;
    double height = 7;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(body), About{"", "body"});
        field(TREAD_FIELD(height), About{"m", "of the roof"});
    }
};
static_assert(describesEveryMember<Car>());

template <class Action>
std::string faultOf(const Action& action) {
    try {
        action();
        ADD_FAILURE() << "no fault was found";
        return {};
    } catch (const LoadError& error) {
        return error.what();
    }
}

Car read(const std::string& text) {
    return readYamlText<Car>(text, "car.yaml");
}

void set(Car& car, const std::vector<std::string>& assignments) {
    applySettings(car, assignments, "--set", [](std::string_view) { return std::string("look it up"); });
}

TEST(OldName, IsReadAsTheNewOne) {
    EXPECT_EQ(read("body: {height: 540 mm}\n").body.centre_height, 0.54);
    EXPECT_EQ(read("body: {centre_height: 0.5}\n").body.centre_height, 0.5);
    EXPECT_EQ(read("{body: {height: 1}, height: 3}\n").height, 3) << "elsewhere the word keeps its meaning";
}

TEST(OldName, IsNotWritten) {
    const std::string text = writeYaml(read("body: {height: 0.5}\n"));
    EXPECT_NE(text.find("centre_height: 0.5"), std::string::npos) << text;
    EXPECT_EQ(read(text).body.centre_height, 0.5);
}

TEST(OldName, FaultsOfItsValueStandWhereItStands) {
    EXPECT_EQ(faultOf([] { read("body:\n  width: 1\n  height: -1\n"); }),
              "car.yaml:3:11: body.centre_height: found \"-1\", expected a number in m above 0; correct the value");
    EXPECT_EQ(faultOf([] { read("body:\n  width: 1\n  height: 3\n"); }),
              "car.yaml:3:11: body.centre_height: found more than the width; lower it");
}

TEST(OldName, BesideTheNewOneIsAFaultThatNamesBoth) {
    for (const std::string text :
         {"body:\n  height: 1\n  centre_height: 1\n", "body:\n  centre_height: 1\n  height: 1\n"}) {
        const std::string fault = faultOf([&] { read(text); });
        EXPECT_NE(
            fault.find("body: found \"height\" beside \"centre_height\", which is the same field, expected one of "
                       "them; remove \"height\", its old name"),
            std::string::npos)
            << fault;
        EXPECT_EQ(fault.find('\n'), std::string::npos) << "one fault, not two: " << fault;
    }
}

TEST(OldName, MissingFieldIsAskedForByItsNewName) {
    EXPECT_NE(faultOf([] { read("body: {width: 1}\n"); }).find("body.centre_height: found no value"),
              std::string::npos);
}

TEST(OldName, IsSetAsTheNewOne) {
    Car car = read("body: {centre_height: 1}\n");
    set(car, {"body.height=0.5"});
    EXPECT_EQ(car.body.centre_height, 0.5);
    set(car, {"body={height: 0.25}"});
    EXPECT_EQ(car.body.centre_height, 0.25);
    set(car, {"body.height=0.5", "body.height=0.75"});
    EXPECT_EQ(car.body.centre_height, 0.75) << "the last one counts, as for every field";
}

TEST(OldName, SettingBothIsAFaultThatNamesBoth) {
    for (const std::vector<std::string>& both : {std::vector<std::string>{"body.height=0.5", "body.centre_height=0.6"},
                                                 {"body.centre_height=0.6", "body.height=0.5"}}) {
        Car car = read("body: {centre_height: 1}\n");
        const std::string fault = faultOf([&] { set(car, both); });
        EXPECT_NE(fault.find("found \"body.height\" beside \"body.centre_height\", which is the same field"),
                  std::string::npos)
            << fault;
        EXPECT_EQ(car.body.centre_height, 1);
    }
}

TEST(OldName, HeightOfACarIsThatOfItsCentreOfGravity) {
    const std::string file = sourceFile("vehicles/compact.yaml");
    std::string text = contentOf(file);
    const std::string name = "centre_of_gravity_height:";
    const std::size_t at = text.find("\n" + name);
    ASSERT_NE(at, std::string::npos);
    text.replace(at + 1, name.size(), "height:");
    for (std::size_t tyre = 0; (tyre = text.find("tyre: tyres/", tyre)) != std::string::npos; tyre += 12)
        text.replace(tyre, 12, "tyre: " + sourceFile("vehicles") + "/tyres/");
    Scratch scratch;
    const VehicleParams old = loadVehicle(scratch.file("old.yaml", text)), now = loadVehicle(file);
    EXPECT_EQ(old.centre_of_gravity_height, now.centre_of_gravity_height);
    EXPECT_EQ(vehicleYaml(old), vehicleYaml(now));
}

}  // namespace tread::old_name_test
