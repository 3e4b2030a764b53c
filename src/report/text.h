// Text for HTML and SVG: numbers for people, units as people write them, and the one conversion from SI to
// the units in which they are shown.
#pragma once

#include <string>
#include <string_view>

namespace tread {

// A number with the given significant digits, "–" when it is not finite: 1234.57, 0.00123, 2.5e+07.
std::string formatNumber(double value, int significant_digits = 4);

// "m/s2" -> "m/s²", "N m" -> "N·m"; nothing for "-", which means a pure number.
std::string prettyUnit(std::string_view unit);

// "load [N]", or just "load" for a pure number.
std::string withUnit(std::string_view label, std::string_view unit);

// A shown value is the SI value times the scale.
struct DisplayUnit {
    std::string unit;
    double scale = 1;
};

// The unit in which a quantity in SI units is shown: degrees for every angle, rev/min for things that spin (channels
// that end in ".spin" or "engine_speed"), otherwise the SI unit itself.
DisplayUnit displayUnit(std::string_view unit, std::string_view channel = {});

// From one unit to another that the report knows ("m/s" to "km/h", "rad" to "deg"); when it knows no such conversion,
// the quantity stays in `unit`.
DisplayUnit displayUnitAs(std::string_view unit, std::string_view wanted);

}  // namespace tread
