#include "base/yaml/schema.h"

#include <gtest/gtest.h>
#include <regex.h>

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/units/quantity_pattern.h"
#include "base/units/units.h"
#include "tread/tyre.h"
#include "tread/wheels.h"
#include "vehicle/fields.h"

// Not an anonymous namespace: clang 14 wants to see conversions to a type without linkage defined.
namespace tread::schema_test {

using Json = nlohmann::json;

struct Keep {
    static constexpr std::string_view kName = "keep";
    int dummy = 1;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(dummy), About{"-", "a \"dummy\"", Limits{1, 10}});
    }
};
struct Ramp {
    static constexpr std::string_view kName = "ramp";
    double to = kRequired;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(to), About{"rad", "angle", Limits{-1, 2, true, false}});
    }
};

struct Car {
    std::string name;
    bool locked = false;
    PerAxle<Ramp> ramp;
    std::optional<Ramp> extra;
    Curve torque;
    std::vector<Keep> list;
    std::variant<Keep, Ramp> steer;
    TyreParams tyre;
    TyreParams spare;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(name), About{"", "name"});
        field(TREAD_FIELD(locked), About{"", "locked"});
        field(TREAD_FIELD(ramp), About{"", "ramps"});
        field(TREAD_FIELD(extra), About{"", "further ramp"});
        field(TREAD_FIELD(torque), About{"N m", "torque", kNonNegative, 0, "rad/s"});
        field(TREAD_FIELD(list), About{"", "list"});
        field(TREAD_FIELD(steer), About{"", "steering"});
        field(TREAD_FIELD(tyre), About{"", "tyre"});
        field(TREAD_FIELD(spare), About{"", "spare tyre"});
    }
};

Json schema() {
    return Json::parse(jsonSchema<Car>("A car", "https://example.org/car.json"));
}

TEST(Schema, IsJsonThatSaysWhatItIs) {
    const Json car = schema();
    EXPECT_EQ(car["$schema"], "http://json-schema.org/draft-07/schema#");
    EXPECT_EQ(car["$id"], "https://example.org/car.json");
    EXPECT_EQ(car["title"], "A car");
    EXPECT_EQ(car["type"], "object");
    EXPECT_EQ(car["additionalProperties"], false);
    EXPECT_EQ(car["properties"].size(), 9u);
    EXPECT_EQ(car["required"], (Json{"ramp", "tyre", "spare"})) << "what holds a number without default";
    EXPECT_EQ(car["properties"]["locked"]["type"], "boolean");
}

TEST(Schema, NumbersHaveMeaningUnitAndLimits) {
    const Json car = schema();
    const Json& to = car["definitions"]["ramp.front"]["properties"]["to"];
    EXPECT_EQ(to["description"], "angle [rad], above -1 and at most 2");
    EXPECT_EQ(to["anyOf"][0], (Json{{"type", "number"}, {"exclusiveMinimum", -1}, {"maximum", 2}}));
    EXPECT_EQ(to["anyOf"][1]["$ref"], "#/definitions/_rad");
    EXPECT_EQ(car["definitions"]["ramp.front"]["required"], (Json{"to"}));
    const Json& dummy = car["definitions"]["list"]["properties"]["dummy"];
    EXPECT_EQ(
        dummy,
        (Json{{"type", "integer"}, {"minimum", 1}, {"maximum", 10}, {"description", "a \"dummy\" [-], from 1 to 10"}}));
    const Json& torque = car["properties"]["torque"];
    EXPECT_EQ(torque["description"], "torque [N m] over [rad/s], at least 0");
    EXPECT_EQ(torque["items"]["items"][1]["anyOf"][0]["minimum"], 0);
    EXPECT_EQ(torque["items"]["items"][0]["anyOf"][1]["$ref"], "#/definitions/_rad_per_s");
    EXPECT_EQ(torque["items"]["items"][1]["anyOf"][1]["$ref"], "#/definitions/_N_m_not_negative");
}

TEST(Schema, TypesAreDefinedOnce) {
    const Json car = schema();
    const std::string target = "#/definitions/ramp.front";
    EXPECT_EQ(car["definitions"]["ramp"]["properties"]["rear"]["allOf"][0]["$ref"], target);
    EXPECT_EQ(car["properties"]["extra"]["allOf"][0]["$ref"], target);
    EXPECT_EQ(car["properties"]["spare"]["oneOf"][1], car["properties"]["tyre"]["oneOf"][1]);
    for (const auto& [name, definition] : car["definitions"].items()) EXPECT_TRUE(definition.is_object()) << name;
    std::size_t types = 0;
    for (const auto& [name, definition] : car["definitions"].items()) types += definition["type"] == "object";
    EXPECT_EQ(types, 6u) << "PerAxle, Ramp, Keep, TyreParams, TyreCoefficients, TyreScaling";
}

TEST(Schema, IncludableMayBeAFileNameAndVariantOneOfItsAlternatives) {
    const Json car = schema();
    EXPECT_EQ(car["properties"]["tyre"]["oneOf"][0]["type"], "string");
    const Json& steer = car["properties"]["steer"]["oneOf"];
    ASSERT_EQ(steer.size(), 3u);
    EXPECT_EQ(steer[0]["enum"], (Json{"keep"})) << "the bare word, for what requires nothing";
    EXPECT_EQ(steer[2]["required"], (Json{"ramp"}));
    EXPECT_EQ(steer[2]["additionalProperties"], false);
    EXPECT_EQ(steer[2]["properties"]["ramp"]["$ref"], "#/definitions/ramp.front");
}

// What every reference points to must exist, or an editor stays silent.
void expectReferencesExist(const Json& node, const Json& definitions) {
    if (node.is_object() && node.contains("$ref")) {
        const std::string target = node["$ref"].get<std::string>().substr(std::string("#/definitions/").size());
        EXPECT_TRUE(definitions.contains(target)) << target;
    }
    if (!node.is_structured()) return;
    for (const Json& child : node) expectReferencesExist(child, definitions);
}

TEST(Schema, TyreSchemaIsSmallAndComplete) {
    const std::string text = jsonSchema<TyreParams>("Tyre", "https://example.org/tyre.json");
    EXPECT_LT(text.size(), 25000u);
    const Json tyre = Json::parse(text);
    EXPECT_EQ(tyre["definitions"]["parameters"]["properties"].size(), 97u);
    EXPECT_EQ(tyre["definitions"]["lambda"]["properties"].size(), 25u);
    EXPECT_EQ(tyre["definitions"]["parameters"]["required"].size(), 14u);
    EXPECT_EQ(tyre["properties"]["side"]["enum"], (Json{"left", "right"}));
    expectReferencesExist(tyre, tyre["definitions"]);
    expectReferencesExist(schema(), schema()["definitions"]);
}

// POSIX instead of std::regex, which g++ 12 cannot compile with sanitizers and warnings.
bool matches(const std::string& pattern, const std::string& text) {
    regex_t compiled;
    EXPECT_EQ(regcomp(&compiled, pattern.c_str(), REG_EXTENDED | REG_NOSUB), 0);
    const bool found = regexec(&compiled, text.c_str(), 0, nullptr, 0) == 0;
    regfree(&compiled);
    return found;
}

void expectPattern(const char* unit, const Limits& limits, const std::vector<const char*>& fit,
                   const std::vector<const char*>& misfit) {
    const std::string pattern = quantityPattern(unit, limits);
    std::string fault;
    for (const char* text : fit) {
        EXPECT_TRUE(matches(pattern, text)) << text << " " << pattern;
        const auto value = toSi(text, unit, fault);
        EXPECT_TRUE(value && limits.allow(*value)) << text << ": the reader takes it, too";
    }
    for (const char* text : misfit) {
        EXPECT_FALSE(matches(pattern, text)) << text << " " << pattern;
        const auto value = toSi(text, unit, fault);
        EXPECT_FALSE(value && limits.allow(*value)) << text << ": the reader refuses it, too";
    }
}

TEST(Schema, PatternAgreesWithTheReaderAboutQuantities) {
    expectPattern("m", kAny, {"1480 mm", "-3", "+.5e-3 km", "7.", "1480mm", "3 µm", "2 m3/m2", "2 (m)", "4 m^1"},
                  {"yes", "", "1_000", "1,5", "--1", ".", "mm", "nan", "5 kg", "5 meter", "5 Pm", "5 N"});
    expectPattern("kg", kPositive, {"1350 kg", "1.35 t", "+3", "2 N s2/m"}, {"-1350 kg", "-3", "1350 m", "1350 kgs"});
    expectPattern("-", kAny, {"35%", "35 %", "-0.3", "3 -"}, {"3 deg", "3 m"});
    expectPattern("1/m", kAny, {"5 1/km", "5 1/(m)"}, {"5 m", "5 km"});
    expectPattern("N/m", kNonNegative, {"22 kN/m", "22 N/mm"}, {"22 kN", "-22 kN/m"});
    expectPattern("K", kPositive, {"-5 degC", "-5 °C", "300 K"}, {"20 deg", "20 C"});
    expectPattern("N m", kAny, {"145 Nm", "145 N m", "3 kJ", "-1"}, {"145 N"});
    expectPattern("rad/s", kPositive, {"6500 rpm", "3 deg/s", "2 rev/s"}, {"6500 Hz", "6500 deg"});
}

}  // namespace tread::schema_test
