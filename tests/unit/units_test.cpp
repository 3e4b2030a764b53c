#include "base/units/units.h"

#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <vector>

#include "base/fields/numbers.h"
#include "tread/tyre.h"

namespace tread::units_test {
namespace {

constexpr double kPi = std::numbers::pi;

double value(std::string_view text, std::string_view unit) {
    std::string fault;
    const auto converted = toSi(text, unit, fault);
    EXPECT_TRUE(converted) << text << ": " << fault;
    return converted.value_or(-12345);
}

std::string faultOf(std::string_view text, std::string_view unit) {
    std::string fault;
    const auto converted = toSi(text, unit, fault);
    EXPECT_FALSE(converted) << text << " was taken as " << converted.value_or(0);
    return fault;
}

TEST(Units, BareNumberIsAlreadyInTheDescribedUnit) {
    EXPECT_EQ(value("3", "m"), 3);
    EXPECT_EQ(value("-1.5e-3", "N s/m"), -1.5e-3);
    EXPECT_EQ(value("+.5", "-"), 0.5);
    EXPECT_EQ(value(" 7. ", ""), 7);
    EXPECT_EQ(value("290", "K"), 290);
}

// Equal to the last bit: a decimal number times or over a whole number is rounded once.
TEST(Units, DecimalConversionsAreExact) {
    EXPECT_EQ(value("1480 mm", "m"), 1.48);
    EXPECT_EQ(value("1480mm", "m"), 1.48);
    EXPECT_EQ(value("90 km/h", "m/s"), 25);
    EXPECT_EQ(value("90 kph", "m/s"), 25);
    EXPECT_EQ(value("2.1 bar", "Pa"), 210000);
    EXPECT_EQ(value("210 kPa", "Pa"), 210000);
    EXPECT_EQ(value("1.8 kN s/m", "N s/m"), 1800);
    EXPECT_EQ(value("28.5 N/mm", "N/m"), 28500);
    EXPECT_EQ(value("0.2 kN/mm", "N/m"), 200000);
    EXPECT_EQ(value("1 g", "m/s2"), 9.80665);
    EXPECT_EQ(value("9.81 m/s^2", "m/s2"), 9.81);
    EXPECT_EQ(value("1.2 t", "kg"), 1200);
    EXPECT_EQ(value("35 %", "-"), 0.35);
    EXPECT_EQ(value("35%", ""), 0.35);
    EXPECT_EQ(value("150 ms", "s"), 0.15);
    EXPECT_EQ(value("2 min", "s"), 120);
    EXPECT_EQ(value("1.5 h", "s"), 5400);
    EXPECT_EQ(value("12 Hz", "1/s"), 12);
    EXPECT_EQ(value("110 kW", "W"), 110000);
    EXPECT_EQ(value("250 Nm", "N m"), 250);
    EXPECT_EQ(value("250 N m", "N m"), 250);
    EXPECT_EQ(value("1 mi", "m"), 1609.344);
    EXPECT_EQ(value("10 ft", "m"), 3.048);
    EXPECT_EQ(value("15 in", "m"), 0.381);
    EXPECT_EQ(value("100 lb", "kg"), 45.359237);
    EXPECT_EQ(value("3 kg m2", "kg m^2"), 3);
    EXPECT_EQ(value("3 kg·m²", "kg m2"), 3);
    EXPECT_EQ(value("5 1/km", "1/m"), 0.005);
    EXPECT_EQ(value("500 J/(kg K)", "J/(kg K)"), 500);
    EXPECT_EQ(value("2 m s-1", "m/s"), 2);
    EXPECT_EQ(value("3 l", "m3"), 0.003);
}

TEST(Units, IrrationalConversionsAgreeWithTheirFormulas) {
    EXPECT_DOUBLE_EQ(value("4.5 deg", "rad"), 4.5 * kPi / 180);
    EXPECT_DOUBLE_EQ(value("4.5°", "rad"), 4.5 * kPi / 180);
    EXPECT_DOUBLE_EQ(value("10 deg/s", "rad/s"), kPi / 18);
    EXPECT_DOUBLE_EQ(value("6000 rpm", "rad/s"), 200 * kPi);
    EXPECT_DOUBLE_EQ(value("2 rev/s", "rad/s"), 4 * kPi);
    EXPECT_DOUBLE_EQ(value("100 N m/deg", "N m/rad"), 100 * 180 / kPi);
    EXPECT_DOUBLE_EQ(value("1 1/deg", "1/rad"), 180 / kPi);
    EXPECT_NEAR(value("60 mph", "m/s"), 26.8224, 1e-13);
    EXPECT_NEAR(value("1 lbf", "N"), 4.4482216152605, 1e-13);
    EXPECT_NEAR(value("30 psi", "Pa"), 206842.7, 0.1);           // NIST SP 811: 6.894757 kPa
    EXPECT_NEAR(value("100 hp", "W"), 74569.98715822702, 1e-6);  // 550 ft lbf/s
    EXPECT_NEAR(value("100 PS", "W"), 73549.875, 1e-9);
}

TEST(Units, OnlyAPlainTemperatureHasAShiftedZero) {
    EXPECT_EQ(value("20 degC", "K"), 293.15);
    EXPECT_EQ(value("-40 °C", "K"), 233.14999999999998);
    EXPECT_EQ(value("300 K", "K"), 300);
    EXPECT_EQ(value("5 W/K", "W/K"), 5);
    EXPECT_EQ(faultOf("5 W/degC", "W/K"),
              "found degC inside the unit \"W/degC\", expected W/K; write K for a difference of temperatures");
    EXPECT_EQ(faultOf("5 1/degC", "1/K"),
              "found degC inside the unit \"1/degC\", expected 1/K; write K for a difference of temperatures");
}

TEST(Units, TextThatIsNotADecimalNumberIsRefused) {
    for (const std::string_view text : {"yes", "", "  ", "0x10", "1_000", "1,5", "1:30", "--1", "+-1", "1.2.3", ".",
                                        "-", "nan", ".nan", "inf", "-.inf", "1e999", "e5", "mm"}) {
        const std::string fault = faultOf(text, "m");
        EXPECT_NE(fault.find("which is not a number, expected m; write a decimal number"), std::string::npos) << fault;
    }
    EXPECT_EQ(faultOf("1e308 km", "m"), "found \"1e308 km\", which is too large; correct the number or its unit");
}

TEST(Units, UnknownUnitNamesTheLikelyOne) {
    EXPECT_EQ(faultOf("3 mmm", "m"), "found the unknown unit \"mmm\", expected m; did you mean \"mm\"?");
    EXPECT_EQ(faultOf("90 kmh", "m/s"), "found the unknown unit \"kmh\", expected m/s; did you mean \"km/h\"?");
    EXPECT_EQ(faultOf("4 degg", "rad"), "found the unknown unit \"degg\", expected rad; did you mean \"deg\"?");
    EXPECT_EQ(faultOf("2 Bar", "Pa"), "found the unknown unit \"Bar\", expected Pa; did you mean \"bar\"?");
    EXPECT_EQ(faultOf("12abc", "N"),
              "found the unknown unit \"abc\", expected N; write another unit of the same kind, or leave it out");
    EXPECT_EQ(faultOf("1 N/quux", "N/m"),
              "found the unknown unit \"quux\" in \"N/quux\", expected N/m; write another unit of "
              "the same kind, or leave it out");
    EXPECT_NE(faultOf("1 " + std::string(100, 'm'), "m").find("found the unknown unit"), std::string::npos);
}

TEST(Units, WrongDimensionNamesBoth) {
    EXPECT_EQ(faultOf("3 mm", "N/m"), "found a length (\"mm\"), expected N/m; correct the unit");
    EXPECT_EQ(faultOf("4 deg", "-"), "found an angle (\"deg\"), expected a pure number; correct the unit");
    EXPECT_EQ(faultOf("5 %", "rad"), "found a pure number (\"%\"), expected rad; correct the unit");
    EXPECT_EQ(faultOf("5 Hz", "rad/s"), "found a frequency (\"Hz\"), expected rad/s; correct the unit");
    EXPECT_EQ(faultOf("5 N m", "N m/rad"), "found a torque or energy (\"N m\"), expected N m/rad; correct the unit");
    EXPECT_EQ(faultOf("500 g", "kg"),
              "found an acceleration (\"g\"), expected kg; g is standard gravity, write a mass in kg");
    EXPECT_EQ(faultOf("1 kg m5", "m"), "found a quantity in m5 kg (\"kg m5\"), expected m; correct the unit");
}

TEST(Units, UnitsThatCanBeReadInTwoWaysAreRefused) {
    EXPECT_EQ(faultOf("1 J/kg K", "J/(kg K)"),
              "found the unit \"J/kg K\", which can be read in two ways, expected J/(kg K); put the denominator in "
              "parentheses, a/(b c)");
    EXPECT_EQ(value("2 m/s/s", "m/s2"), 2);
    for (const std::string_view text : {"1 m^", "1 m10", "1 m^-", "1 (m", "1 m)", "1 m//s", "1 m/", "1 /m", "1 ()"}) {
        EXPECT_FALSE(faultOf(text, "m").empty());
    }
}

TEST(Units, EveryUnitOfATyreParameterIsKnown) {
    TyreParams tyre;
    for (const Number& number : numbers(tyre)) {
        std::string fault;
        EXPECT_TRUE(parseUnit(number.about.unit, fault)) << number.path << ": " << fault;
    }
}

}  // namespace
}  // namespace tread::units_test
