// Units: products, quotients and powers of named units ("N s/m", "kg m2", "m/s^2", "J/(kg K)"), and the conversion of a
// value with a unit to the unit in which the program holds it.
//
// The radian is a dimension of its own, so that degrees are not taken where a pure number is wanted. "g" is standard
// gravity, never a gram. A plain temperature may be given in degC; "%" is a hundredth.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tread {

// Exponents of metre, kilogram, second, kelvin, ampere, radian.
using Dimension = std::array<int, 6>;

// value in SI = value * numerator / denominator + offset. Two factors, because 1480 / 1000 is exact and 1480 * 0.001
// is not.
struct Unit {
    double numerator = 1;
    double denominator = 1;
    double offset = 0;
    Dimension dimension{};
};

// The unit of that name; nothing, and the reason in `fault`, when there is none. "", "1" and "-" are the pure number.
std::optional<Unit> parseUnit(std::string_view text, std::string& fault);

// "a length", "a damping coefficient"; "a quantity in kg m/s3" for what has no name here.
std::string dimensionName(const Dimension& dimension);

// "1480 mm", "4.5 deg", "3" (already in `unit`) in terms of `unit`. Nothing, and what is wrong in `fault`, when the
// text is not a number, or its unit is unknown or measures something else.
std::optional<double> toSi(std::string_view text, std::string_view unit, std::string& fault);

// A unit that has a name of its own.
struct NamedUnit {
    std::string_view name;
    Unit unit;
    bool prefixes = false;  // takes G, M, k, c, m, u
};
std::span<const NamedUnit> namedUnits();

}  // namespace tread
