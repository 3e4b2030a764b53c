#include "base/fields/reference_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/fields/numbers.h"
#include "tread/tyre.h"
#include "tread/wheels.h"
#include "vehicle/fields.h"

// Not an anonymous namespace: clang 14 wants to see conversions to a type without linkage defined.
namespace tread::reference_table_test {

struct Keep {
    static constexpr std::string_view kName = "keep";
    int dummy = 1;
    static constexpr void describe(auto& self, auto&& field) { field(TREAD_FIELD(dummy), About{"-", "dummy"}); }
};
struct Ramp {
    static constexpr std::string_view kName = "ramp";
    double to = kRequired;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(to), About{"rad", "angle", Limits{-1, 1, true, true}, 0.02});
    }
};
enum class Drive { front, rear };
constexpr auto enumNames(Drive) {
    return std::array<std::string_view, 2>{"front", "rear"};
}

struct Car {
    std::string name = "x";
    Drive drive = Drive::rear;
    bool locked = false;
    double mass = 1200;
    double limit = kInfinity;
    PerAxle<Ramp> ramp;
    Curve torque;
    std::vector<double> ratios{1, 2};
    std::variant<Keep, Ramp> steer;
    std::optional<double> lag;
    std::optional<Keep> extra;
    std::vector<Car> trailers;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(name), About{"", "name"});
        field(TREAD_FIELD(drive), About{"", "driven axle"});
        field(TREAD_FIELD(locked), About{"", "locked"});
        field(TREAD_FIELD(mass), About{"kg", "mass", kPositive, 0.01});
        field(TREAD_FIELD(limit), About{"N", "limit", Limits{0, 5}});
        field(TREAD_FIELD(ramp), About{"", "ramps"});
        field(TREAD_FIELD(torque), About{"N m", "torque", kAny, 0, "rad/s"});
        field(TREAD_FIELD(ratios), About{"-", "ratios", kPositive});
        field(TREAD_FIELD(steer), About{"", "steering"});
        field(TREAD_FIELD(lag), About{"s", "lag"});
        field(TREAD_FIELD(extra), About{"", "extra"});
        field(TREAD_FIELD(trailers), About{"", "trailers"});
    }
};

std::string lines(const std::vector<ReferenceRow>& rows) {
    std::string text;
    for (const ReferenceRow& row : rows) {
        for (const std::string& cell : {row.path, row.unit, row.meaning, row.limits}) text += cell + "|";
        text += row.default_text + "\n";
    }
    return text;
}

TEST(ReferenceTable, HasARowForEveryField) {
    EXPECT_EQ(lines(referenceTable<Car>()),
              "name||name||x\n"
              "drive||driven axle|front or rear|rear\n"
              "locked||locked||false\n"
              "mass|kg|mass|above 0|1200\n"
              "limit|N|limit|from 0 to 5|unlimited\n"
              "ramp.front.to|rad|angle|above -1 and below 1|required\n"
              "ramp.rear.to|rad|angle|above -1 and below 1|required\n"
              "torque|N m|torque||empty\n"
              "ratios|-|ratios|a list|2 elements\n"
              "ratios.0|-|ratios|above 0|0\n"
              "steer||steering|keep or ramp|keep\n"
              "steer.keep.dummy|-|dummy||1\n"
              "steer.ramp.to|rad|angle|above -1 and below 1|required\n"
              "lag|s|lag||absent\n"
              "extra||extra||absent\n"
              "extra.dummy|-|dummy||1\n"
              "trailers||trailers|a list|empty\n");
    EXPECT_EQ(referenceTable<Car>()[3].tolerance, 0.01);
}

TEST(ReferenceTable, TyreHasAllItsParameters) {
    const auto rows = referenceTable<TyreParams>();
    TyreParams tyre;
    for (const Number& number : numbers(tyre)) {
        EXPECT_EQ(
            std::count_if(rows.begin(), rows.end(), [&](const ReferenceRow& row) { return row.path == number.path; }),
            1)
            << number.path;
    }
    EXPECT_EQ(rows[2].path, "parameters.Fzo");
    EXPECT_EQ(rows[2].default_text, "required");
}

}  // namespace tread::reference_table_test
