// The elementary functions of a run against those of the C library in long double.
#include "base/math/elementary.h"

#include <gtest/gtest.h>

#include <array>
#include <cfloat>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "base/math/power.h"

namespace tread::elementary_test {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();
constexpr double kTiniest = std::numeric_limits<double>::denorm_min();
constexpr double kHuge = std::numeric_limits<double>::max();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

constexpr int kPoints = 100'000;
std::mt19937_64 engine(1);

double between(double a, double b) {
    return a + (b - a) * (static_cast<double>(engine() >> 11) * 0x1p-53);
}
// Of either sign, with a size spread evenly over the orders of magnitude.
double ofAnySize(double least, double most) {
    const double size = std::exp(between(std::log(least), std::log(most)));
    return engine() & 1 ? size : -size;
}

// In units in the last place of the exact value.
double error(double found, long double exact) {
    const auto nearest = static_cast<double>(exact);
    if (std::isnan(found) || std::isnan(nearest)) return std::isnan(found) && std::isnan(nearest) ? 0 : kEndless;
    if (std::isinf(found) || std::isinf(nearest)) return found == nearest ? 0 : kEndless;
    int exponent;
    std::frexp(std::max(std::abs(nearest), DBL_MIN), &exponent);
    return static_cast<double>(std::abs(static_cast<long double>(found) - exact) / std::ldexp(1.0L, exponent - 53));
}

template <class Function, class Exact, class Point>
void expectWithin(double most, const char* name, Function&& function, Exact&& exact, Point&& point) {
    double worst = 0, at = 0;
    for (int i = 0; i < kPoints; ++i) {
        const double x = point();
        const double off = error(function(x), exact(static_cast<long double>(x)));
        if (off > worst) worst = off, at = x;
    }
    EXPECT_LE(worst, most) << name << " at " << at;
}

template <class Function, class Exact, class Point>
void expectWithinOfTwo(double most, const char* name, Function&& function, Exact&& exact, Point&& point) {
    double worst = 0;
    std::pair<double, double> at;
    for (int i = 0; i < kPoints; ++i) {
        const auto [a, b] = point();
        const double off = error(function(a, b), exact(static_cast<long double>(a), static_cast<long double>(b)));
        if (off > worst) worst = off, at = {a, b};
    }
    EXPECT_LE(worst, most) << name << " at " << at.first << ", " << at.second;
}

const auto kOrdinary = [] { return between(-3, 3); };
const auto kOfAnySize = [] { return ofAnySize(1e-300, 1e300); };

TEST(Elementary, TrigonometricFunctionsAreWithinTheirBounds) {
    using std::cos, std::sin, std::tan;
    const auto sine_ = [](double x) { return sine(x); };
    const auto cosine_ = [](double x) { return cosine(x); };
    const auto tangent_ = [](double x) { return tangent(x); };
    const auto turns = [] { return ofAnySize(1e-10, 8e8); };
    // Where the long double's cosine is next to nothing, its argument's rounding is all there is of it.
    expectWithin(
        2, "sine", sine_, [](long double x) { return sin(x); }, kOrdinary);
    expectWithin(
        2, "sine", sine_, [](long double x) { return sin(x); }, turns);
    expectWithin(
        2, "cosine", cosine_, [](long double x) { return cos(x); }, kOrdinary);
    expectWithin(
        2, "cosine", cosine_, [](long double x) { return cos(x); }, turns);
    expectWithin(
        3.5, "tangent", tangent_, [](long double x) { return tan(x); }, kOrdinary);
    expectWithin(
        3.5, "tangent", tangent_, [](long double x) { return tan(x); }, turns);
}

TEST(Elementary, AnglesOfAnySizeHaveSinesOfAtMostOne) {
    for (int i = 0; i < kPoints; ++i) {
        const SineCosine<double> far = sineCosineFar(ofAnySize(1e8, kHuge));
        EXPECT_NEAR(far.sine * far.sine + far.cosine * far.cosine, 1, 1e-15);
    }
    EXPECT_EQ(sineCosineFar(1e3).sine, sine(1e3));
    EXPECT_EQ(tangentFar(1e3), tangent(1e3));
    EXPECT_TRUE(std::isnan(sineCosineFar(kEndless).sine));
    EXPECT_TRUE(std::isnan(sine(kNaN)));
}

TEST(Elementary, InverseTrigonometricFunctionsAreWithinTheirBounds) {
    using std::asin, std::atan, std::atan2;
    const auto arctan_ = [](double x) { return arctan(x); };
    const auto arcsine_ = [](double x) { return arcsine(x); };
    const auto arctan2_ = [](double y, double x) { return arctan2(y, x); };
    expectWithin(
        1, "arctan", arctan_, [](long double x) { return atan(x); }, kOrdinary);
    expectWithin(
        1, "arctan", arctan_, [](long double x) { return atan(x); }, kOfAnySize);
    expectWithin(
        2, "arcsine", arcsine_, [](long double x) { return asin(x); }, [] { return between(-1, 1); });
    expectWithin(
        2, "arcsine", arcsine_, [](long double x) { return asin(x); }, [] { return ofAnySize(1e-300, 1); });
    expectWithin(
        2, "arcsine near 1", arcsine_, [](long double x) { return asin(x); },
        [] { return 1 - std::abs(ofAnySize(1e-16, 0.5)); });
    const auto exact = [](long double y, long double x) { return atan2(y, x); };
    expectWithinOfTwo(2, "arctan2", arctan2_, exact, [] { return std::pair(kOrdinary(), kOrdinary()); });
    expectWithinOfTwo(2, "arctan2", arctan2_, exact, [] { return std::pair(kOfAnySize(), kOfAnySize()); });
    expectWithinOfTwo(2, "arctan2", arctan2_, exact, [] {
        const double x = ofAnySize(kTiniest, kHuge);
        return std::pair(x * between(-1, 1), x);
    });
}

TEST(Elementary, ExponentialsAreWithinTheirBounds) {
    using std::exp, std::expm1, std::tanh;
    const auto exponential_ = [](double x) { return exponential(x); };
    const auto less1 = [](double x) { return exponentialLess1(x); };
    const auto tanh_ = [](double x) { return hyperbolicTangent(x); };
    expectWithin(
        2, "exponential", exponential_, [](long double x) { return exp(x); }, [] { return between(-700, 700); });
    expectWithin(
        2, "exponential", exponential_, [](long double x) { return exp(x); }, kOrdinary);
    expectWithin(
        2, "less 1", less1, [](long double x) { return expm1(x); }, [] { return between(-700, 700); });
    expectWithin(
        2, "less 1", less1, [](long double x) { return expm1(x); }, kOrdinary);
    expectWithin(
        2, "less 1", less1, [](long double x) { return expm1(x); }, [] { return ofAnySize(1e-300, 1); });
    expectWithin(
        2, "tanh", tanh_, [](long double x) { return tanh(x); }, kOrdinary);
    expectWithin(
        2, "tanh", tanh_, [](long double x) { return tanh(x); }, kOfAnySize);
}

TEST(Elementary, ExponentialIsHeldBeyondItsRange) {
    EXPECT_EQ(exponential(kEndless), exponential(700.0));
    EXPECT_EQ(exponential(-kEndless), exponential(-700.0));
    EXPECT_EQ(exponentialLess1(1e10), exponentialLess1(700.0));
    EXPECT_EQ(exponentialLess1(-kEndless), -1);
    for (auto* function : {&exponential<double>, &exponentialLess1<double>, &hyperbolicTangent<double>})
        EXPECT_TRUE(std::isnan(function(kNaN)));
}

TEST(Elementary, LogarithmAndPowerAreWithinOneUnit) {
    using std::log, std::pow;
    const auto exact = [](long double x) { return log(x); };
    expectWithin(1, "logarithm", logarithm, exact, [] { return std::abs(ofAnySize(kTiniest, kHuge)); });
    expectWithin(1, "logarithm", logarithm, exact, [] { return between(0.5, 2); });
    expectWithin(1, "logarithm", logarithm, exact, [] { return 1 + ofAnySize(1e-16, 0.1); });
    const auto exact_power = [](long double x, long double y) { return pow(x, y); };
    expectWithinOfTwo(1, "power", power, exact_power, [] { return std::pair(between(0, 10), between(-20, 20)); });
    expectWithinOfTwo(1, "power", power, exact_power, [] {
        const double x = std::abs(kOfAnySize());
        return std::pair(x, between(-708, 709) / std::log(x));
    });
    expectWithinOfTwo(1, "power", power, exact_power,
                      [] { return std::pair(1 + ofAnySize(1e-15, 1e-3), ofAnySize(1, 1e5)); });
}

TEST(Elementary, HypotenuseNeitherOverflowsNorVanishes) {
    using std::hypot;
    const auto exact = [](long double x, long double y) { return hypot(x, y); };
    expectWithinOfTwo(1.5, "hypotenuse", hypotenuse, exact, [] { return std::pair(kOrdinary(), kOrdinary()); });
    expectWithinOfTwo(1.5, "hypotenuse", hypotenuse, exact, [] {
        const double x = ofAnySize(DBL_MIN, 1e308);
        return std::pair(x, x * between(-1, 1));
    });
    EXPECT_EQ(hypotenuse(kEndless, 1), kEndless);
    EXPECT_EQ(hypotenuse(0, -0.0), 0);
    EXPECT_EQ(hypotenuse(3, -4), 5);
}

// Zeros, whose signs tell apart the sides of a cut, infinities, NaN, numbers without all their digits, and huge ones.
TEST(Elementary, SpecialValuesAreThoseOfTheLibrary) {
    const std::array special{0.0,   -0.0,     1.0,      -1.0,    2.0,       -2.0,   3.0,   -3.0,
                             0.5,   -0.5,     kEndless, kNaN,    -kEndless, 1e-320, kHuge, -kHuge,
                             1e300, kTiniest, DBL_MIN,  DBL_MIN, -kTiniest, -1e16,  1e16,  1 + DBL_EPSILON};
    const auto expectLike = [](const char* name, double found, double exact, double most, double a, double b = 0) {
        EXPECT_LE(error(found, static_cast<long double>(exact)), most + 1)
            << name << " of " << a << ", " << b << ": " << found << " " << exact;
        EXPECT_TRUE(std::isnan(exact) || std::signbit(found) == std::signbit(exact)) << name << a << ", " << b;
    };
    for (const double a : special) {
        expectLike("arctan", arctan(a), std::atan(a), 1, a);
        expectLike("arcsine", arcsine(a), std::asin(a), 2, a);
        expectLike("tanh", hyperbolicTangent(a), std::tanh(a), 2, a);
        expectLike("logarithm", logarithm(a), std::log(a), 1, a);
        for (const double b : special) {
            expectLike("arctan2", arctan2(a, b), std::atan2(a, b), 2, a, b);
            expectLike("power", power(a, b), std::pow(a, b), 1, a, b);
        }
    }
}

// ---- Lanes ----

template <int N, class Function>
void expectLanesAgree(Function&& function) {
    for (int i = 0; i < 2000; ++i) {
        LanesOf<N> x, y;
        for (std::size_t k = 0; k < N; ++k) {
            x.set(k, i % 2 ? ofAnySize(1e-6, 1e6) : kOrdinary());
            y.set(k, kOrdinary());
        }
        const LanesOf<N> all = function(x, y);
        for (std::size_t k = 0; k < N; ++k) {
            const double alone = function(x[k], y[k]);
            EXPECT_EQ(std::bit_cast<std::int64_t>(all[k]), std::bit_cast<std::int64_t>(alone)) << x[k] << ", " << y[k];
        }
    }
}

TEST(Elementary, LanesHaveTheBitsOfNumbers) {
    const auto everything = [](const auto& x, const auto& y) {
        return arctan(x) + arctan2(y, x) + sine(x) + cosine(y) + tangent(y) + exponential(x) + exponentialLess1(y) +
               hyperbolicTangent(x);
    };
    expectLanesAgree<4>(everything);
    expectLanesAgree<8>(everything);
    expectLanesAgree<4>([](const auto& x, const auto& y) { return arctan2(x, y); });
    expectLanesAgree<4>([](const auto& x, const auto&) { return hyperbolicTangent(x); });
    expectLanesAgree<4>([](const auto&, const auto& y) { return arcsine(decltype(y + y)(y / 3.0)); });
}

}  // namespace
}  // namespace tread::elementary_test
