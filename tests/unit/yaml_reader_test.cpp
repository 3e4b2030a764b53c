#include "base/yaml/read.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/text/concat.h"
#include "places/places.h"
#include "shared/described_samples.h"
#include "shared/scratch.h"
#include "tread/tyre.h"
#include "tread/wheels.h"
#include "vehicle/fields.h"

// Not an anonymous namespace: clang 14 wants to see conversions to a type without linkage defined.
namespace tread::yaml_reader_test {

using sample::Damper, sample::Drive, sample::Keep, sample::Ramp;
using Texts = std::vector<std::string>;

struct Car {
    std::string name;
    Drive drive = Drive::front;
    bool locked = false;
    int gears = 5;
    double mass = 1000;
    PerAxle<Damper> damper{{100, 0}, {200, 0}};
    Curve torque;
    std::vector<double> ratios;
    std::vector<Damper> extra;
    std::optional<double> steer_lag;
    std::optional<Damper> cab;
    std::variant<Keep, Ramp> steer;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(name), About{"", "name"});
        field(TREAD_FIELD(drive), About{"", "driven axle"});
        field(TREAD_FIELD(locked), About{"", "locked differential"});
        field(TREAD_FIELD(gears), About{"-", "number of gears", Limits{1, 10}});
        field(TREAD_FIELD(mass), About{"kg", "mass", kPositive});
        field(TREAD_FIELD(damper), About{"", "dampers"});
        field(TREAD_FIELD(torque), About{"N m", "engine torque", kNonNegative, 0, "rad/s"});
        field(TREAD_FIELD(ratios), About{"-", "gear ratios", kPositive});
        field(TREAD_FIELD(extra), About{"", "further dampers"});
        field(TREAD_FIELD(steer_lag), About{"s", "lag", kPositive});
        field(TREAD_FIELD(cab), About{"", "damper of the cab"});
        field(TREAD_FIELD(steer), About{"", "steering"});
    }
    static void check(const auto& self, auto&& complain) {
        if (!self.ratios.empty() && std::ssize(self.ratios) != self.gears) {
            complain("ratios", "found " + std::to_string(self.ratios.size()) +
                                   " ratios, expected one for each of the " + std::to_string(self.gears) +
                                   " gears; correct one of the two");
        }
        if (self.damper.front.bump > 9000) complain("damper.front.bump", "found too much, expected less; correct it");
    }
};
static_assert(describesEveryMember<Car>());

Car read(const std::string& text) {
    return readYamlText<Car>(text, "car.yaml");
}

template <class T = Car>
Texts faults(const std::string& text) {
    Texts texts;
    try {
        readYamlText<T>(text, "car.yaml");
        ADD_FAILURE() << "no fault was found in\n" << text;
    } catch (const LoadError& error) {
        for (const Problem& problem : error.problems()) texts.push_back(toText(problem));
    }
    return texts;
}

// ---- What may stand in a file --------------------------------------------------------------------------------------

TEST(YamlReader, TyreFileLoadsUnchanged) {
    const auto tyre = readYaml<TyreParams>(sourceFile("vehicles/tyres/car_205_60R15.yaml"));
    EXPECT_EQ(tyre.name, "car_205_60R15");
    EXPECT_EQ(tyre.side, TyreSide::left);
    EXPECT_EQ(tyre.parameters.Fzo, 4000);
    EXPECT_EQ(tyre.parameters.Re, 0.3055);
    EXPECT_EQ(tyre.parameters.qEz5, -0.5704113160413529);
    EXPECT_EQ(tyre.parameters.cpsigyr, 0.5);
    EXPECT_EQ(tyre.lambda.muy, 1);
}

TEST(YamlReader, EveryKindOfFieldIsRead) {
    const Car car = read(
        "name: compact\n"
        "drive: all\n"
        "locked: true\n"
        "gears: 3\n"
        "mass: 1.2 t\n"
        "damper:\n"
        "  front: {bump: 1.8 kN s/m, friction: 30}\n"
        "  rear:\n"
        "    bump: \"1500\"\n"
        "torque: [[0, 100], [3000 rpm, 0.15 kN m], [628, 90]]\n"
        "ratios: [3.5, 200 %, 1]\n"
        "extra:\n"
        "  - bump: 1\n"
        "  - {bump: 2, friction: 3}\n"
        "steer_lag: 50 ms\n"
        "cab: {bump: 7}\n"
        "steer: {ramp: {to: 45 deg, start: 1}}\n");
    EXPECT_EQ(car.name, "compact");
    EXPECT_EQ(car.drive, Drive::all);
    EXPECT_TRUE(car.locked);
    EXPECT_EQ(car.gears, 3);
    EXPECT_EQ(car.mass, 1200);
    EXPECT_EQ(car.damper.front.bump, 1800);
    EXPECT_EQ(car.damper.front.friction, 30);
    EXPECT_EQ(car.damper.rear.bump, 1500);
    EXPECT_EQ(car.damper.rear.friction, 0);
    ASSERT_EQ(car.torque.points.size(), 3u);
    EXPECT_DOUBLE_EQ(car.torque.points[1].x, 314.1592653589793);
    EXPECT_EQ(car.torque.points[1].y, 150);
    EXPECT_EQ(car.ratios, (std::vector<double>{3.5, 2, 1}));
    ASSERT_EQ(car.extra.size(), 2u);
    EXPECT_EQ(car.extra[1].friction, 3);
    EXPECT_EQ(car.steer_lag, 0.05);
    ASSERT_TRUE(car.cab);
    EXPECT_EQ(car.cab->bump, 7);
    ASSERT_TRUE(std::holds_alternative<Ramp>(car.steer));
    EXPECT_DOUBLE_EQ(std::get<Ramp>(car.steer).to, 0.7853981633974483);
    EXPECT_EQ(std::get<Ramp>(car.steer).start, 1);
}

TEST(YamlReader, AbsentKeysKeepTheirDefaults) {
    const Car car = read("name: x\n");
    EXPECT_EQ(car.gears, 5);
    EXPECT_EQ(car.damper.rear.bump, 200);
    EXPECT_FALSE(car.steer_lag);
    EXPECT_FALSE(car.cab);
    EXPECT_TRUE(std::holds_alternative<Keep>(car.steer));
}

TEST(YamlReader, AlternativeWithoutRequiredFieldsMayStandAsABareWord) {
    EXPECT_TRUE(std::holds_alternative<Keep>(read("steer: keep\n").steer));
    EXPECT_EQ(std::get<Keep>(read("steer: {keep: {tolerance: 0.1}}\n").steer).tolerance, 0.1);
    EXPECT_EQ(std::get<Keep>(read("steer: {keep: {}}\n").steer).tolerance, 0.5);
    EXPECT_EQ(faults("steer: ramp\n"), (Texts{"car.yaml:1:8: steer.ramp.to: found no value, expected a number in rad "
                                              "(final angle); add \"to: <number>\""}));
}

TEST(YamlReader, ByteOrderMarkWindowsLineEndsAndCommentsAreFine) {
    EXPECT_EQ(read("\xEF\xBB\xBF# a car\r\nname: \"ä b\"  # its name\r\nmass: 900\r\n").name, "ä b");
    EXPECT_EQ(read("---\nmass: 900\n...\n").mass, 900);
}

TEST(YamlReader, AliasesStandForTheirValue) {
    const Car car = read("damper: {front: &d {bump: 5}, rear: *d}\n");
    EXPECT_EQ(car.damper.front.bump, 5);
    EXPECT_EQ(car.damper.rear.bump, 5);
}

TEST(YamlReader, MistypedKeyCountsAsTheFieldThatItMeans) {
    EXPECT_EQ(faults("extra: [{bmup: 4}]\n"),
              (Texts{"car.yaml:1:10: extra.0: found the unknown key \"bmup\", expected the name of a field; did you "
                     "mean \"bump\"?"}))
        << "and no missing bump";
    EXPECT_EQ(faults("extra: [{bmup: -4}]\n").size(), 2u) << "its value is looked at";
    EXPECT_EQ(faults("mass: 1\nmas: -2\n").size(), 1u) << "the mass is there";
}

TEST(YamlReader, WhatAMissingStructRequiresIsOneFault) {
    EXPECT_EQ(faults<PerAxle<PerAxle<Damper>>>("front: {front: {bump: 1}, rear: {bump: 1}}\n"),
              (Texts{"car.yaml:1:1: rear: found nothing, expected a map with at least \"front\", \"rear\"; add "
                     "\"rear:\" with these"}));
}

// ---- Faults, each with its place -----------------------------------------------------------------------------------

TEST(YamlReader, UnknownKeyIsAnErrorThatNamesTheLikelyOne) {
    EXPECT_EQ(faults("damper:\n  front:\n    bmup: 4\n    bump: 3\n"),
              (Texts{"car.yaml:3:5: damper.front: found the unknown key \"bmup\", expected the name of a field; did "
                     "you mean \"bump\"?"}));
    EXPECT_EQ(faults("damper: {front: {bump: 1, zzz: 2}}\n"),
              (Texts{"car.yaml:1:27: damper.front: found the unknown key \"zzz\", expected the name of a field; write "
                     "one of bump or friction"}));
    EXPECT_EQ(
        faults("<<: {mass: 3}\n"),
        (Texts{"car.yaml:1:1: found the unknown key \"<<\", expected the name of a field; write the merged keys out"}));
}

TEST(YamlReader, DuplicateKeyIsAnErrorThatNamesTheFirst) {
    EXPECT_EQ(faults("mass: 1\nname: a\nmass: 2\n"),
              (Texts{"car.yaml:3:1: found the key \"mass\" a second time, expected it once (the first is in line 1); "
                     "remove one of the two"}));
}

TEST(YamlReader, MissingNumbersAreReportedAtTheEnclosingMap) {
    EXPECT_EQ(faults("name: x\nextra:\n  - friction: 2\n"),
              (Texts{"car.yaml:3:5: extra.0.bump: found no value, expected a number in N s/m (damping in compression); "
                     "add \"bump: <number>\""}));
    // The map of a struct that is absent as a whole is the one around it.
    EXPECT_EQ(faults<PerAxle<Damper>>("\nfront: {bump: 1}\n"),
              (Texts{"car.yaml:2:1: rear.bump: found no value, expected a number in N s/m (damping in compression); "
                     "add \"bump: <number>\""}));
    EXPECT_EQ(faults<PerAxle<Damper>>("front:\n  friction: 1\nrear: {bump: 1}\n"),
              (Texts{"car.yaml:2:3: front.bump: found no value, expected a number in N s/m (damping in compression); "
                     "add \"bump: <number>\""}));
}

TEST(YamlReader, NumbersAreCheckedForLimitsTypeAndUnit) {
    EXPECT_EQ(faults("mass: 0\n"),
              (Texts{"car.yaml:1:7: mass: found \"0\", expected a number in kg above 0; correct the value"}));
    EXPECT_EQ(faults("mass:  -5 t\n"),
              (Texts{"car.yaml:1:8: mass: found \"-5 t\", expected a number in kg above 0; correct the value"}));
    EXPECT_EQ(faults("mass: yes\n"),
              (Texts{"car.yaml:1:7: mass: found \"yes\", which is not a number, expected kg; write a decimal "
                     "number, alone or followed by a unit"}));
    EXPECT_EQ(faults("mass: 3 mm\n"),
              (Texts{"car.yaml:1:7: mass: found a length (\"mm\"), expected kg; correct the unit"}));
    EXPECT_EQ(faults("mass: 3 kgg\n"),
              (Texts{"car.yaml:1:7: mass: found the unknown unit \"kgg\", expected kg; did you mean \"kg\"?"}));
    EXPECT_EQ(faults("mass: [1]\n"),
              (Texts{"car.yaml:1:7: mass: found a list, expected a number in kg; write a decimal number, alone "
                     "or followed by a unit"}));
    EXPECT_EQ(faults("name: a\nmass:\n"),
              (Texts{"car.yaml:2:1: mass: found nothing, expected a number in kg; write a decimal number, "
                     "alone or followed by a unit"}));
    for (const char* number :
         {".nan", ".inf", "-.inf", "nan", "inf", "0x10", "1_000", "12abc", "\"\"", "1e999", "true"}) {
        const Texts texts = faults(std::string("mass: ") + number + "\n");
        ASSERT_EQ(texts.size(), 1u);
        EXPECT_TRUE(texts[0].starts_with("car.yaml:1:7: mass: found ")) << texts[0];
    }
}

TEST(YamlReader, WholeNumbersTakeDigitsOnly) {
    EXPECT_EQ(faults("gears: 0\n"),
              (Texts{"car.yaml:1:8: gears: found \"0\", expected a whole number from 1 to 10; correct the value"}));
    for (const char* number : {"3.0", "3e0", "three", "99999999999", "0x3", "3 -", "{}", "~"}) {
        const Texts texts = faults(std::string("gears: ") + number + "\n");
        ASSERT_EQ(texts.size(), 1u);
        EXPECT_TRUE(texts[0].ends_with("expected a whole number from 1 to 10; write digits only")) << texts[0];
    }
}

TEST(YamlReader, OnlyTrueAndFalseAreTruthValues) {
    for (const char* word : {"yes", "no", "on", "True", "1", "\"true\"", "[]", "~"}) {
        const Texts texts = faults(std::string("locked: ") + word + "\n");
        ASSERT_EQ(texts.size(), 1u);
        EXPECT_TRUE(texts[0].ends_with("expected true or false; write one of these, without quotes")) << texts[0];
    }
    EXPECT_FALSE(read("locked: false\n").locked);
}

TEST(YamlReader, TextIsAnyScalarButNotNothing) {
    EXPECT_EQ(read("name: 205\n").name, "205");
    EXPECT_EQ(read("name: \"\"\n").name, "");
    EXPECT_EQ(faults("name:\n"),
              (Texts{"car.yaml:1:1: name: found nothing, expected a text; write it on one line, in quotes when it "
                     "has special characters"}));
    EXPECT_EQ(faults("name: {a: 1}\n").size(), 1u);
}

TEST(YamlReader, EscapesOfCharactersBeyondAsciiAreThoseCharacters) {
    EXPECT_EQ(read(R"(name: "a\Nb\_\_ä\x85\u00e4\L")"
                   "\n")
                  .name,
              "a\u0085b\u00a0\u00a0ä\u0085ä\u2028");
}

TEST(YamlReader, EnumNamesTheLikelyValue) {
    EXPECT_EQ(faults("drive: reer\n"),
              (Texts{"car.yaml:1:8: drive: found \"reer\", expected front, rear or all; did you mean \"rear\"?"}));
    EXPECT_EQ(faults("drive: 2\n"),
              (Texts{"car.yaml:1:8: drive: found \"2\", expected front, rear or all; write one of these"}));
    EXPECT_EQ(faults("drive: [all]\n"),
              (Texts{"car.yaml:1:8: drive: found a list, expected front, rear or all; write one of these"}));
}

TEST(YamlReader, CurveFaultsHaveThePlaceOfTheirPoint) {
    EXPECT_EQ(faults("torque:\n  - [0, 1]\n  - [5, 1]\n  - [5, 2]\n  - [4, 1]\n"),
              (Texts{"car.yaml:4:6: torque.2.x: found x = 5 after 5, expected x to increase strictly; sort the points "
                     "and remove repetitions",
                     "car.yaml:5:6: torque.3.x: found x = 4 after 5, expected x to increase strictly; sort the points "
                     "and remove repetitions"}));
    EXPECT_EQ(faults("torque: [[0, -1], [1 m, 2 N], [3], 4, [5, 6, 7]]\n"),
              (Texts{"car.yaml:1:14: torque.0.y: found \"-1\", expected a number in N m at least 0; correct the value",
                     "car.yaml:1:20: torque.1.x: found a length (\"m\"), expected rad/s; correct the unit",
                     "car.yaml:1:25: torque.1.y: found a force (\"N\"), expected N m; correct the unit",
                     "car.yaml:1:31: torque.2: found a list, expected a point [x, y] of two numbers; write both "
                     "numbers in brackets",
                     "car.yaml:1:36: torque.3: found \"4\", expected a point [x, y] of two numbers; write both numbers "
                     "in brackets",
                     "car.yaml:1:39: torque.4: found a list, expected a point [x, y] of two numbers; write both "
                     "numbers in brackets"}));
    EXPECT_EQ(faults("torque: 5\n"), (Texts{"car.yaml:1:9: torque: found \"5\", expected a list of points [x in rad/s, "
                                            "y in N m]; write [[x1, y1], [x2, y2]]"}));
    EXPECT_TRUE(read("torque: []\n").torque.empty());
}

TEST(YamlReader, ListFaultsHaveThePlaceOfTheirElement) {
    EXPECT_EQ(faults("ratios: [3, 0, x]\n"),
              (Texts{"car.yaml:1:13: ratios.1: found \"0\", expected a pure number above 0; correct the value",
                     "car.yaml:1:16: ratios.2: found \"x\", which is not a number, expected a pure number; write a "
                     "decimal number, alone or "
                     "followed by a unit"}));
    EXPECT_EQ(
        faults("extra: {bump: 1}\n"),
        (Texts{"car.yaml:1:8: extra: found a map, expected a list; write [a, b] or one \"- \" line for each element"}));
}

TEST(YamlReader, VariantIsExactlyOneOfItsAlternatives) {
    EXPECT_EQ(faults("steer: {remp: {to: 1}}\n"),
              (Texts{"car.yaml:1:9: steer: found \"remp\", expected keep or ramp; did you mean \"ramp\"?"}));
    EXPECT_EQ(
        faults("steer: {ramp: {to: 1}, keep: {}}\n"),
        (Texts{"car.yaml:1:8: steer: found a map of 2 keys, expected one of keep or ramp; write \"keep: {...}\""}));
    EXPECT_EQ(faults("steer: [keep]\n"),
              (Texts{"car.yaml:1:8: steer: found a list, expected one of keep or ramp; write \"keep: {...}\""}));
    EXPECT_EQ(faults("steer:\n  ramp:\n    to: 3 m\n"),
              (Texts{"car.yaml:3:9: steer.ramp.to: found a length (\"m\"), expected rad; correct the unit"}));
    EXPECT_EQ(faults("steer:\n  ramp:\n"),
              (Texts{"car.yaml:2:3: steer.ramp: found nothing, expected a map; write \"key: value\" lines"}));
}

TEST(YamlReader, RulesAcrossFieldsCountUnlessAFieldThatTheyNameIsFaulty) {
    EXPECT_EQ(
        faults("gears: 3\nratios: [1, 2]\n"),
        (Texts{"car.yaml:2:9: ratios: found 2 ratios, expected one for each of the 3 gears; correct one of the two"}));
    EXPECT_EQ(faults("gears: 3\nratios: [1, 2]\nmass: x\n").size(), 2u) << "mass and ratios";
    EXPECT_EQ(faults("gears: x\nratios: [1, 2]\n").size(), 1u) << "only the gears are reported";
    EXPECT_EQ(faults("gears: 3\nratios: [1, x]\n").size(), 1u) << "only the second ratio is reported";
    EXPECT_EQ(faults("damper:\n  front: {bump: 9001}\n"),
              (Texts{"car.yaml:2:17: damper.front.bump: found too much, expected less; correct it"}));
}

TEST(YamlReader, EveryFaultOfAFileIsReportedInOneRunFromTopToBottom) {
    EXPECT_EQ(
        faults("mess: 3\n"
               "gears: many\n"
               "cab:\n"
               "  {friction: -1}\n"
               "damper: soft\n"
               "steer: jump\n"
               "gears: 4\n"),
        (Texts{"car.yaml:1:1: found the unknown key \"mess\", expected the name of a field; did you mean \"mass\"?",
               "car.yaml:2:8: gears: found \"many\", expected a whole number from 1 to 10; write digits only",
               "car.yaml:4:3: cab.bump: found no value, expected a number in N s/m (damping in compression); "
               "add \"bump: "
               "<number>\"",
               "car.yaml:4:14: cab.friction: found \"-1\", expected a number in N at least 0; correct the value",
               "car.yaml:5:9: damper: found \"soft\", expected a map; write \"key: value\" lines",
               "car.yaml:6:8: steer: found \"jump\", expected keep or ramp; write one of these",
               "car.yaml:7:1: found the key \"gears\" a second time, expected it once (the first is in line 2); remove "
               "one of the "
               "two"}));
}

TEST(YamlReader, ColumnsCountCharactersNotBytes) {
    EXPECT_EQ(faults("{name: \"äöü€\", mass: x}\n").front().substr(0, 19), "car.yaml:1:22: mass");
}

// ---- Files that are not what they should be ------------------------------------------------------------------------

TEST(YamlReader, TextThatIsNotOneYamlMapIsOneClearFault) {
    EXPECT_EQ(faults(""),
              (Texts{"car.yaml: found nothing in the file, expected \"key: value\" lines; check the path"}));
    EXPECT_EQ(faults("# only a comment\n").size(), 1u);
    EXPECT_EQ(faults("---\n").size(), 1u);
    EXPECT_EQ(faults("- 1\n- 2\n"), (Texts{"car.yaml:1:1: found a list, expected a map; write \"key: value\" lines"}));
    EXPECT_EQ(faults("hello\n"), (Texts{"car.yaml:1:1: found \"hello\", expected a map; write \"key: value\" lines"}));
    EXPECT_EQ(faults("mass: 1\n---\nmass: 2\n"), (Texts{"car.yaml:2:1: found a second document, expected one in a "
                                                        "file; remove the rest, or correct the indentation here"}));
    EXPECT_EQ(faults("  mass: 1\nname: x\n"), (Texts{"car.yaml:2:1: found a second document, expected one in a file; "
                                                     "remove the rest, or correct the indentation here"}));
    EXPECT_EQ(faults("damper:\n\tfront: 3\n"),
              (Texts{"car.yaml:2:1: found a tab in the indentation, expected spaces; replace it by spaces"}));
    EXPECT_EQ(faults(std::string("mass: 1\nname: \0", 15)),
              (Texts{"car.yaml:2:7: found a NUL byte, expected UTF-8 text; check that this is not a binary file"}));
    EXPECT_EQ(faults("name: ä\xFF\n"),
              (Texts{"car.yaml:1:8: found a byte that is not UTF-8; save the file as UTF-8 text"}));
    for (const char* bad :
         {"name: \xC0\x80", "name: \xED\xA0\x80", "name: \xF4\x90\x80\x80", "name: \xE2\x82", "\x89PNG\r\n"}) {
        EXPECT_EQ(faults(bad).size(), 1u);
    }
    EXPECT_EQ(
        faults("mass: !!float 3\n"),
        (Texts{"car.yaml:1:7: found a YAML tag, expected a plain value; remove the word that begins with \"!\""}));
    EXPECT_EQ(faults("[a]: 1\n"),
              (Texts{"car.yaml:1:1: found a list, expected the name of a field; write \"key: value\""}));
}

TEST(YamlReader, SyntaxErrorsHaveTheirPlace) {
    for (const auto& [text, place] :
         std::vector<std::pair<std::string, std::string>>{{"mass: 1\nname: a: b\n", "car.yaml:2:8: "},
                                                          {"mass: [1, 2\n", "car.yaml:2:1: "},
                                                          {"mass: 1\n  name: x\n", "car.yaml:2:7: "},
                                                          {"mass: @\n", "car.yaml:1:7: "},
                                                          {"mass: *nowhere\n", "car.yaml:1:7: "}}) {
        const Texts texts = faults(text);
        ASSERT_EQ(texts.size(), 1u) << text;
        EXPECT_TRUE(texts[0].starts_with(place + "found text that is not YAML (")) << texts[0];
    }
}

// yaml-cpp 0.7 itself takes the rest of the file for the text.
TEST(YamlReader, QuoteThatIsNeverClosedIsAnError) {
    const std::string fault = "found no end of the quoted text that begins after this place; close the quotation mark";
    EXPECT_EQ(faults("gears: 3\nname: \"a\n"), (Texts{"car.yaml:2:1: " + fault}));
    EXPECT_EQ(faults("gears: 3\nname: 'a\nmass: 3\n\n"), (Texts{"car.yaml:2:1: " + fault}));
    EXPECT_EQ(faults("gears: 3\nname: \"a"), (Texts{"car.yaml:2:1: " + fault}));
    EXPECT_EQ(faults("\"a\n").size(), 1u);
    EXPECT_EQ(read("name: \"a\n  b\"\n").name, "a b");
}

TEST(YamlReader, DeepNestingIsRefusedBeforeItCostsTheStack) {
    for (const std::string_view unit : {"[", "{", "{a: ", "- ", "? ", "[\n", "[[{"}) {
        std::string text;
        for (int i = 0; i < 200000; ++i) text += unit;
        const Texts texts = faults(text);
        ASSERT_EQ(texts.size(), 1u);
        EXPECT_NE(texts[0].find("found values nested more than 64 deep; check the brackets"), std::string::npos)
            << texts[0];
    }
}

TEST(YamlReader, AliasBombsAreRefusedWhereverTheyStand) {
    std::string bomb = "ignored:\n  - &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
    for (int i = 1; i < 40; ++i) {
        const std::string before = concat({"*a", std::to_string(i - 1)});
        bomb += concat({"  - &a", std::to_string(i), " [", before});
        for (int j = 0; j < 9; ++j) bomb += concat({", ", before});
        bomb += "]\n";
    }
    const Texts texts = faults(bomb);
    ASSERT_EQ(texts.size(), 1u);
    EXPECT_NE(texts[0].find("found more than a million values"), std::string::npos) << texts[0];

    std::string chain = "a: &a0 [1]\n";
    for (int i = 1; i < 100; ++i) {
        const std::string name = concat({"a", std::to_string(i)});
        chain += concat({name, ": &", name, " [*a", std::to_string(i - 1), "]\n"});
    }
    EXPECT_NE(faults(chain)[0].find("found aliases nested more than 64 deep"), std::string::npos);
    EXPECT_EQ(faults("extra: &x [*x]\n"),
              (Texts{"car.yaml:1:12: found an alias inside the value that it stands for; write the value out"}));
}

TEST(YamlReader, EndlessFaultsAreCutShort) {
    std::string text;
    for (int i = 0; i < 5000; ++i) text += concat({"key", std::to_string(i), ": 1\n"});
    const Texts texts = faults(text);
    EXPECT_EQ(texts.size(), 1001u);
    EXPECT_EQ(std::count_if(texts.begin(), texts.end(),
                            [](const std::string& line) {
                                return line.find("found more than 1000 faults") != std::string::npos;
                            }),
              1);
}

TEST(YamlReader, HugeTextIsRefused) {
    EXPECT_EQ(faults("name: " + std::string(5u << 20, 'x')),
              (Texts{"car.yaml: found more than 4 MB, expected a description written by hand; check the path"}));
}

// ---- Files and what they include -----------------------------------------------------------------------------------

struct Tyre {
    static constexpr bool kIncludable = true;
    double radius = kRequired;
    double width = 0.2;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(radius), About{"m", "radius", kPositive});
        field(TREAD_FIELD(width), About{"m", "width", kPositive});
    }
};
static_assert(describesEveryMember<Tyre>());

// Takes "*.tir": the radius alone, in a line of its own.
bool readForeign(Tyre& tyre, const std::filesystem::path& file, std::vector<Problem>& problems) {
    if (file.extension() != ".tir") return false;
    std::ifstream stream(file);
    if (!(stream >> tyre.radius)) problems.push_back({file.string(), 1, 1, "", "found no radius"});
    tyre.width = tyre.radius == 9 ? -1 : 0.3;
    if (tyre.radius == 8) tyre.radius = kRequired;
    return true;
}

struct Wheel {
    static constexpr bool kIncludable = true;
    std::string name;
    Tyre tyre;
    std::vector<Wheel> spares;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(name), About{"", "name"});
        field(TREAD_FIELD(tyre), About{"", "tyre"});
        field(TREAD_FIELD(spares), About{"", "spare wheels"});
    }
};

class YamlFiles : public testing::Test {
protected:
    YamlFiles() { std::filesystem::create_directory(path("tyres")); }

    std::string path(const std::string& name) const { return scratch_.path(name); }
    std::string write(const std::string& name, const std::string& text) const { return scratch_.file(name, text); }
    template <class T = Wheel>
    Texts faultsOf(const std::string& file) const {
        Texts texts;
        try {
            readYaml<T>(file);
            ADD_FAILURE() << "no fault was found in " << file;
        } catch (const LoadError& error) {
            for (const Problem& problem : error.problems()) texts.push_back(toText(problem));
        }
        return texts;
    }

    Scratch scratch_;
};

TEST_F(YamlFiles, IncludedFileIsFoundBesideTheIncludingOne) {
    write("tyres/a.yaml", "radius: 300 mm\n");
    const auto wheel =
        readYaml<Wheel>(write("wheel.yaml", "tyre: tyres/a.yaml\nspares: [{tyre: tyres/../tyres/a.yaml}]\n"));
    EXPECT_EQ(wheel.tyre.radius, 0.3);
    EXPECT_EQ(wheel.tyre.width, 0.2);
    EXPECT_EQ(wheel.spares.at(0).tyre.radius, 0.3);
}

TEST_F(YamlFiles, FaultsOfIncludedFilesAreReportedWithTheOthersAndOnce) {
    const std::string tyre = write("tyres/a.yaml", "radius: 300 kg\nwitdh: 3\n");
    const std::string wheel = write("wheel.yaml", "tyre: tyres/a.yaml\nnam: x\nspares:\n  - tyre: tyres/a.yaml\n");
    EXPECT_EQ(
        faultsOf(wheel),
        (Texts{
            wheel + ":2:1: found the unknown key \"nam\", expected the name of a field; did you mean \"name\"?",
            tyre + ":1:9: tyre.radius: found a mass (\"kg\"), expected m; correct the unit",
            tyre +
                ":2:1: tyre: found the unknown key \"witdh\", expected the name of a field; did you mean \"width\"?"}));
}

TEST_F(YamlFiles, IncludedFileOfAnotherKindIsOneFaultWhereItIsNamed) {
    write("tyres/a.yaml", "mass: 3\ninertia: 4\nwheelbase: 5\nname: x\n");
    const std::string wheel = write("wheel.yaml", "tyre: tyres/a.yaml\n");
    const Texts texts = faultsOf(wheel);
    ASSERT_EQ(texts.size(), 1u);
    EXPECT_TRUE(texts[0].starts_with(wheel +
                                     ":1:7: tyre: found \"tyres/a.yaml\", a file of another kind, expected a file "
                                     "with "))
        << texts[0];
}

TEST_F(YamlFiles, NothingIsToldOfAnIncludedFileThatIsNone) {
    for (const std::string text : {"root:x:0:0:root\nsecret:x:1:1:daemon\n", "- secret\n- b\n", "PASSWORD: secret\n",
                                   "a: b: \"secret\n", "secret"}) {
        write("tyres/a.yaml", text);
        const Texts texts = faultsOf(write("wheel.yaml", "name: x\ntyre: tyres/a.yaml\n"));
        ASSERT_EQ(texts.size(), 1u) << text;
        EXPECT_NE(texts[0].find("tyres/a.yaml"), std::string::npos) << texts[0];
        EXPECT_EQ(texts[0].find("secret"), std::string::npos) << texts[0];
        EXPECT_EQ(texts[0].find("PASSWORD"), std::string::npos) << texts[0];
    }
}

TEST_F(YamlFiles, MissingIncludeNamesWhoIncludedItAndWhatWasTried) {
    const std::string wheel = write("wheel.yaml", "name: x\ntyre: tyres/nowhere.yaml\n");
    EXPECT_EQ(faultsOf(wheel), (Texts{wheel + ":2:7: tyre: found the file name \"tyres/nowhere.yaml\", which " + wheel +
                                      " includes, but nothing is there (tried \"" + path("tyres/nowhere.yaml") +
                                      "\"); write a path relative to the including file"}));
    write("directory.yaml", "tyre: tyres\n");
    EXPECT_EQ(faultsOf(path("directory.yaml")),
              (Texts{path("directory.yaml") + ":1:7: tyre: in the included file " + path("tyres") +
                     ": found a directory, expected a file; name a file in it"}));
    EXPECT_EQ(faultsOf(write("nul.yaml", "tyre: \"a\\0b\"\n")).size(), 1u);
    EXPECT_EQ(faultsOf(write("empty.yaml", "tyre: \"\"\n")).size(), 1u);
}

TEST_F(YamlFiles, CircleOfIncludesIsNoticed) {
    write("a.yaml", "tyre: {radius: 1}\nspares: [b.yaml]\n");
    write("b.yaml", "tyre: {radius: 1}\nspares:\n  - tyres/../a.yaml\n");
    EXPECT_EQ(faultsOf(path("a.yaml")),
              (Texts{path("b.yaml") + ":3:5: spares.0.spares.0: found \"tyres/../a.yaml\", which includes itself "
                                      "through this file; break the cycle"}));
    write("self.yaml", "tyre: {radius: 1}\nspares: [self.yaml]\n");
    EXPECT_EQ(faultsOf(path("self.yaml")).size(), 1u);
}

TEST_F(YamlFiles, ForeignFilesAreAskedFirstAndCheckedAfterwards) {
    write("tyres/a.tir", "0.33\n");
    EXPECT_EQ(readYaml<Wheel>(write("wheel.yaml", "tyre: tyres/a.tir\n")).tyre.radius, 0.33);
    EXPECT_EQ(readYaml<Tyre>(path("tyres/a.tir")).width, 0.3);
    EXPECT_EQ(faultsOf(write("w2.yaml", "tyre: " + write("bad.tir", "x") + "\n")),
              (Texts{path("bad.tir") + ":1:1: found no radius"}));
    EXPECT_EQ(faultsOf<Tyre>(write("limits.tir", "9")),
              (Texts{path("limits.tir") + ": width: found -1, expected a number in m above 0; correct the value"}));
    EXPECT_EQ(faultsOf(write("w3.yaml", "tyre: " + write("gap.tir", "8") + "\n")),
              (Texts{path("gap.tir") +
                     ": tyre.radius: found no value, expected a number in m (radius); add \"radius: <number>\""}));
}

TEST_F(YamlFiles, FilesThatCannotBeReadAreOneFault) {
    EXPECT_EQ(faultsOf(path("nowhere.yaml")),
              (Texts{path("nowhere.yaml") + ": found no file of this name; correct the path"}));
    EXPECT_EQ(faultsOf(path("tyres")),
              (Texts{path("tyres") + ": found a directory, expected a file; name a file in it"}));
    EXPECT_EQ(faultsOf("/dev/zero"),
              (Texts{"/dev/zero: is a pipe, a socket or a device, expected a regular file; write its content into a "
                     "file first"}));
    EXPECT_EQ(faultsOf(write("empty.yaml", "")).size(), 1u);
    if (geteuid() == 0) return;  // the superuser may read everything
    const std::string secret = write("secret.yaml", "tyre: {radius: 1}\n");
    std::filesystem::permissions(secret, std::filesystem::perms::none);
    EXPECT_EQ(faultsOf(secret), (Texts{secret + ": found a file that cannot be read; check its permissions"}));
}

}  // namespace tread::yaml_reader_test
