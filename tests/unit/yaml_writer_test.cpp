#include "base/yaml/write.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "base/fields/numbers.h"
#include "base/text/number_text.h"
#include "base/yaml/read.h"
#include "places/places.h"
#include "tread/tyre.h"
#include "tread/wheels.h"
#include "vehicle/fields.h"

// Not an anonymous namespace: clang 14 wants to see conversions to a type without linkage defined.
namespace tread::yaml_writer_test {

struct Ramp {
    static constexpr std::string_view kName = "ramp";
    double to = kRequired;
    bool operator==(const Ramp&) const = default;
    static constexpr void describe(auto& self, auto&& field) { field(TREAD_FIELD(to), About{"rad", "final angle"}); }
};

struct Keep {
    static constexpr std::string_view kName = "keep";
    std::optional<double> tolerance;
    bool operator==(const Keep&) const = default;
    static constexpr void describe(auto& self, auto&& field) { field(TREAD_FIELD(tolerance), About{"m", "tolerance"}); }
};

enum class Side { left, right };
constexpr auto enumNames(Side) {
    return std::array<std::string_view, 2>{"left", "right"};
}

struct Step {
    std::variant<Keep, Ramp> action;
    bool last = false;
    bool operator==(const Step&) const = default;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(action), About{"", "action"});
        field(TREAD_FIELD(last), About{"", "last"});
    }
};

struct Everything {
    std::string name;
    Side side = Side::left;
    bool flag = false;
    int count = 0;
    double number = 0;
    double limit = kInfinity;
    Curve curve;
    std::vector<double> numbers;
    std::vector<std::string> words;
    std::vector<Step> steps;
    std::vector<std::variant<Keep, Ramp>> actions;
    std::vector<std::vector<double>> table;
    std::optional<double> lag;
    std::optional<Step> extra;
    bool operator==(const Everything&) const = default;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(name), About{"", "name"});
        field(TREAD_FIELD(side), About{"", "side"});
        field(TREAD_FIELD(flag), About{"", "flag"});
        field(TREAD_FIELD(count), About{"-", "count"});
        field(TREAD_FIELD(number), About{"N s/m", "number"});
        field(TREAD_FIELD(limit), About{"N", "limit"});
        field(TREAD_FIELD(curve), About{"N m", "curve", kAny, 0, "rad/s"});
        field(TREAD_FIELD(numbers), About{"m", "numbers"});
        field(TREAD_FIELD(words), About{"", "words"});
        field(TREAD_FIELD(steps), About{"", "steps"});
        field(TREAD_FIELD(actions), About{"", "actions"});
        field(TREAD_FIELD(table), About{"m", "table"});
        field(TREAD_FIELD(lag), About{"s", "lag"});
        field(TREAD_FIELD(extra), About{"", "extra"});
    }
};
static_assert(describesEveryMember<Everything>());

Everything example() {
    Everything all;
    all.name = "compact car";
    all.side = Side::right;
    all.flag = true;
    all.count = -3;
    all.number = 1800.5;
    all.curve.points = {{0, 100}, {314.1592653589793, 0.1}};
    all.numbers = {1, 0.1, 1e-9};
    all.words = {"a", "b, c", ""};
    all.steps = {{Ramp{0.5}, false}, {Keep{}, true}, {Keep{0.1}, false}};
    all.actions = {Keep{}, Ramp{1}};
    all.table = {{1, 2}, {}, {3}};
    all.lag = 0.05;
    all.extra = Step{Ramp{2}, true};
    return all;
}

template <Described T>
T roundTrip(const T& object) {
    const std::string text = writeYaml(object);
    try {
        return readYamlText<T>(text, "round_trip.yaml");
    } catch (const LoadError& error) {
        ADD_FAILURE() << error.what() << "\n" << text;
        return {};
    }
}

TEST(YamlWriter, TextHasUnitsInCommentsAndNothingSuperfluous) {
    EXPECT_EQ(writeYaml(example()),
              "name: \"compact car\"\n"
              "side: right\n"
              "flag: true\n"
              "count: -3\n"
              "number: 1800.5  # N s/m\n"
              "# limit: unlimited\n"
              "curve: [[0, 100], [314.1592653589793, 0.1]]  # [rad/s, N m]\n"
              "numbers: [1, 0.1, 1.0e-09]  # m\n"
              "words: [a, \"b, c\", \"\"]\n"
              "steps:\n"
              "  - action:\n"
              "      ramp:\n"
              "        to: 0.5  # rad\n"
              "    last: false\n"
              "  - action: keep\n"
              "    last: true\n"
              "  - action:\n"
              "      keep:\n"
              "        tolerance: 0.1  # m\n"
              "    last: false\n"
              "actions:\n"
              "  - keep\n"
              "  - ramp:\n"
              "      to: 1  # rad\n"
              "table: [[1, 2], [], [3]]\n"
              "lag: 0.05  # s\n"
              "extra:\n"
              "  action:\n"
              "    ramp:\n"
              "      to: 2  # rad\n"
              "  last: true\n");
}

TEST(YamlWriter, EveryKindOfFieldReadsBackEqual) {
    EXPECT_EQ(roundTrip(example()), example());
    EXPECT_EQ(roundTrip(Everything{}), Everything{});
    Everything all = example();
    all.curve.points.clear();
    for (int i = 0; i < 50; ++i) all.curve.points.push_back({i / 3.0, i / 7.0});
    EXPECT_EQ(roundTrip(all), all);
    EXPECT_NE(writeYaml(all).find("curve:  # [rad/s, N m]\n  - [0, 0]\n"), std::string::npos)
        << "a long curve has a line a point";
}

TEST(YamlWriter, StructWithoutValuesIsAnEmptyMap) {
    EXPECT_EQ(writeYaml(Keep{}), "{}\n# tolerance: not given\n");
    EXPECT_EQ(roundTrip(Keep{}), Keep{});
    PerAxle<Keep> both;
    both.rear.tolerance = 2;
    EXPECT_EQ(writeYaml(both), "front: {}\n  # tolerance: not given\nrear:\n  tolerance: 2  # m\n");
    EXPECT_EQ(roundTrip(both).rear, both.rear);
}

TEST(YamlWriter, MissingRequiredNumberIsSaidInAComment) {
    EXPECT_EQ(writeYaml(Ramp{}), "{}\n# to: a number is required here, rad\n");
}

TEST(YamlWriter, TyreReadsBackBitForBit) {
    auto tyre = readYaml<TyreParams>(sourceFile("vehicles/tyres/car_205_60R15.yaml"));
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> fraction(0.5, 2);
    for (const Number& number : numbers(tyre)) *number.value *= fraction(random);
    auto back = roundTrip(tyre);
    EXPECT_EQ(back.name, tyre.name);
    EXPECT_EQ(back.side, tyre.side);
    const auto before = numbers(tyre);
    const auto after = numbers(back);
    ASSERT_EQ(before.size(), 122u);
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_EQ(std::bit_cast<std::uint64_t>(*after[i].value), std::bit_cast<std::uint64_t>(*before[i].value))
            << before[i].path;
    }
}

TEST(YamlWriter, AnyFiniteNumberReadsBackBitForBit) {
    const auto same = [](double value) {
        Everything all;
        all.number = value;
        return std::bit_cast<std::uint64_t>(roundTrip(all).number) == std::bit_cast<std::uint64_t>(value);
    };
    using Double = std::numeric_limits<double>;
    for (const double value : {0.0, -0.0, 1e5, 1e15, 1e16, 123456789012345680.0, 1e-5, 9.9e-6, 0.1, 1 / 3.0, 1e300,
                               Double::max(), Double::lowest(), Double::min(), Double::denorm_min()}) {
        EXPECT_TRUE(same(value)) << numberText(value);
    }
    std::mt19937_64 random(2);
    for (int i = 0; i < 2000; ++i) {
        const double value = std::bit_cast<double>(random());
        EXPECT_TRUE(!std::isfinite(value) || same(value)) << numberText(value);
    }
}

TEST(YamlWriter, AnyTextReadsBackEqual) {
    const std::string all_ascii = [] {
        std::string text;
        for (char c = 1; c < 127; ++c) text += c;
        return text;
    }();
    for (const std::string& text :
         {std::string("null"),     std::string("~"),      std::string("true"),    std::string("No"),
          std::string("3"),        std::string("3 mm"),   std::string("a: b"),    std::string("- a"),
          std::string("# a"),      std::string("a #b"),   std::string(" a "),     std::string("\"a\""),
          std::string("it's"),     std::string("a\nb\n"), std::string("a\\b"),    std::string("%a"),
          std::string("...\n---"), std::string("*a"),     std::string("äöü €"),   std::string("\x7F"),
          std::string("a\0b", 3),  std::string(".inf"),   std::string(3000, 'x'), all_ascii}) {
        Everything all;
        all.name = text;
        all.words = {text, text};
        EXPECT_EQ(roundTrip(all), all) << text;
    }
}

}  // namespace tread::yaml_writer_test
