#include "base/schema.h"

#include <gtest/gtest.h>
#include <regex.h>

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "tread/tyre.h"
#include "tread/wheels.h"

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
    EXPECT_EQ(to["anyOf"][1]["$ref"], "#/definitions/_quantity");
    EXPECT_EQ(car["definitions"]["ramp.front"]["required"], (Json{"to"}));
    const Json& dummy = car["definitions"]["list"]["properties"]["dummy"];
    EXPECT_EQ(
        dummy,
        (Json{{"type", "integer"}, {"minimum", 1}, {"maximum", 10}, {"description", "a \"dummy\" [-], from 1 to 10"}}));
    const Json& torque = car["properties"]["torque"];
    EXPECT_EQ(torque["description"], "torque [N m] over [rad/s], at least 0");
    EXPECT_EQ(torque["items"]["items"][1]["anyOf"][0]["minimum"], 0);
}

TEST(Schema, TypesAreDefinedOnce) {
    const Json car = schema();
    const std::string target = "#/definitions/ramp.front";
    EXPECT_EQ(car["definitions"]["ramp"]["properties"]["rear"]["allOf"][0]["$ref"], target);
    EXPECT_EQ(car["properties"]["extra"]["allOf"][0]["$ref"], target);
    EXPECT_EQ(car["properties"]["spare"]["oneOf"][1], car["properties"]["tyre"]["oneOf"][1]);
    for (const auto& [name, definition] : car["definitions"].items()) EXPECT_TRUE(definition.is_object()) << name;
    EXPECT_EQ(car["definitions"].size(), 7u)
        << "_quantity, PerAxle, Ramp, Keep, TyreParams, TyreCoefficients, TyreScaling";
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
    EXPECT_EQ(tyre["definitions"]["parameters"]["properties"].size(), 96u);
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

TEST(Schema, PatternAgreesWithTheReaderAboutQuantities) {
    const std::string pattern = schema()["definitions"]["_quantity"]["pattern"];
    for (const char* text : {"1480 mm", "4.5 deg", "-3", "+.5e-3 N s/m", "35%", "5 1/km", "7."}) {
        EXPECT_TRUE(matches(pattern, text)) << text;
    }
    for (const char* text : {"yes", "", "1_000", "1,5", "--1", ".", "mm", "nan"}) {
        EXPECT_FALSE(matches(pattern, text)) << text;
    }
}

}  // namespace tread::schema_test
