// Described structs as JSON: there and back, and messages that name the field.
#include "store/described_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace tread::described_json_test {
namespace {

enum class Colour { red, green };
constexpr auto enumNames(Colour) {
    return std::array<std::string_view, 2>{"red", "green"};
}

struct Wheel {
    double radius = 0;
    bool driven = false;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(radius), About{"m", "free radius"});
        field(TREAD_FIELD(driven), About{"", "by the engine"});
    }
    bool operator==(const Wheel&) const = default;
};

struct Cart {
    std::string name;
    Colour colour = Colour::red;
    int seats = 0;
    std::uint64_t seed = 0;
    std::vector<Wheel> wheels;
    std::vector<std::vector<std::string>> rows;
    std::map<std::string, double> loads;
    std::map<std::string, Wheel> spare;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(name), About{"", "of the cart"});
        field(TREAD_FIELD(colour), About{"", "of the cart"});
        field(TREAD_FIELD(seats), About{"-", "number of seats"});
        field(TREAD_FIELD(seed), About{"-", "up to 64 bits"});
        field(TREAD_FIELD(wheels), About{"", "all of them"});
        field(TREAD_FIELD(rows), About{"", "who sits where"});
        field(TREAD_FIELD(loads), About{"kg", "by place"});
        field(TREAD_FIELD(spare), About{"", "by place"});
    }
    bool operator==(const Cart&) const = default;
};

Cart cart() {
    return {.name = "a \"cart\"",
            .colour = Colour::green,
            .seats = -2,
            .seed = 0xffffffffffffffffu,
            .wheels = {{0.1, true}, {1.0 / 3, false}},
            .rows = {{"a", "b"}, {}, {"c"}},
            .loads = {{"front", 12.5}, {"rear", 1e-300}},
            .spare = {{"boot", {0.3, false}}}};
}

nlohmann::ordered_json changed(const std::function<void(nlohmann::ordered_json&)>& change) {
    nlohmann::ordered_json json = jsonOf(cart());
    change(json);
    return json;
}

std::string fault(const nlohmann::ordered_json& json) {
    try {
        Cart read;
        readJson(read, json);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "none";
}

TEST(DescribedJson, TextReadsBackToTheSame) {
    Cart read;
    read.wheels.resize(9), read.loads["old"] = 1;  // what was there is replaced
    readJson(read, nlohmann::ordered_json::parse(jsonOf(cart()).dump()));
    EXPECT_EQ(read, cart());
}

TEST(DescribedJson, FieldsStandInTheOrderOfTheDescription) {
    EXPECT_EQ(jsonOf(Wheel{0.5, true}).dump(), R"({"radius":0.5,"driven":true})");
    EXPECT_EQ(jsonOf(std::vector<std::vector<std::string>>{{"a"}, {}}).dump(), R"([["a"],[]])");
    EXPECT_EQ(jsonOf(Colour::green).dump(), "\"green\"");
}

TEST(DescribedJson, NumberThatIsNotFiniteIsNull) {
    EXPECT_EQ(jsonOf(Wheel{std::nan(""), true}).dump(), R"({"radius":null,"driven":true})");
    EXPECT_EQ(jsonOf(kInfinity).dump(), "null");
    Wheel read;
    readJson(read, nlohmann::ordered_json::parse(R"({"radius": null, "driven": true})"));
    EXPECT_TRUE(std::isnan(read.radius));
}

TEST(DescribedJson, WholeNumberIsANumberToo) {
    Wheel read;
    readJson(read, nlohmann::ordered_json::parse(R"({"radius": 2, "driven": false})"));
    EXPECT_EQ(read.radius, 2);
}

TEST(DescribedJson, MissingFieldIsNamedWithItsPath) {
    EXPECT_EQ(fault(changed([](auto& json) { json.erase("loads"); })), "expected the field \"loads\"");
    EXPECT_EQ(fault(changed([](auto& json) { json["wheels"][1].erase("driven"); })),
              "wheels.1: expected the field \"driven\"");
    EXPECT_EQ(fault(changed([](auto& json) { json["spare"]["boot"].erase("radius"); })),
              "spare.boot: expected the field \"radius\"");
}

TEST(DescribedJson, WrongTypeIsNamedWithItsPath) {
    EXPECT_EQ(fault(changed([](auto& json) { json["wheels"][0]["radius"] = "wide"; })),
              "wheels.0.radius: expected a number");
    EXPECT_EQ(fault(changed([](auto& json) { json["wheels"][0]["driven"] = 1; })),
              "wheels.0.driven: expected true or false");
    EXPECT_EQ(fault(changed([](auto& json) { json["rows"][2][0] = 3; })), "rows.2.0: expected a string");
    EXPECT_EQ(fault(changed([](auto& json) { json["rows"][1] = "c"; })), "rows.1: expected a list");
    EXPECT_EQ(fault(changed([](auto& json) { json["loads"] = nullptr; })), "loads: expected an object");
    EXPECT_EQ(fault(changed([](auto& json) { json["colour"] = "blue"; })),
              "colour: expected a known name of this enumeration");
    EXPECT_EQ(fault(changed([](auto& json) { json["seats"] = 1.5; })), "seats: expected a whole number");
    EXPECT_EQ(fault("cart"), "expected an object");
}

TEST(DescribedJson, WholeNumberBeyondTheFieldIsRefused) {
    EXPECT_EQ(fault(changed([](auto& json) { json["seats"] = 3000000000; })),
              "seats: expected a whole number within the range of this field");
    EXPECT_EQ(fault(changed([](auto& json) { json["seed"] = -1; })),
              "seed: expected a whole number within the range of this field");
}

}  // namespace
}  // namespace tread::described_json_test
