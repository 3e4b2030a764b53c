#include "report/text.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

namespace tread {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kRevolutionsPerMinute = 30 / std::numbers::pi;

bool endsWith(std::string_view text, std::string_view end) {
    return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

}  // namespace

std::string formatNumber(double value, int significant_digits) {
    if (!std::isfinite(value)) return "–";
    std::string text = fmt::format("{:.{}g}", value == 0 ? 0.0 : value, significant_digits);
    // Four digits are no reason to write 1.235e+04 newtons: up to a million, whole numbers read better.
    if (text.find('e') != std::string::npos && std::abs(value) >= 1 && std::abs(value) < 1e6) {
        text = fmt::format("{:.0f}", value);
    }
    return text;
}

std::string prettyUnit(std::string_view unit) {
    if (unit == "-") return {};
    std::string out;
    for (std::size_t i = 0; i < unit.size(); ++i) {
        const bool exponent = i > 0 && (std::isalpha(static_cast<unsigned char>(unit[i - 1])) != 0);
        if (exponent && unit[i] == '2') {
            out += "²";
        } else if (exponent && unit[i] == '3') {
            out += "³";
        } else if (unit[i] == ' ') {
            out += "·";
        } else {
            out += unit[i];
        }
    }
    return out;
}

std::string withUnit(std::string_view label, std::string_view unit) {
    const std::string pretty = prettyUnit(unit);
    return pretty.empty() ? std::string(label) : fmt::format("{} [{}]", label, pretty);
}

DisplayUnit displayUnit(std::string_view unit, std::string_view channel) {
    if (unit == "rad/s" && (endsWith(channel, ".spin") || endsWith(channel, "engine_speed"))) {
        return {"rev/min", kRevolutionsPerMinute};
    }
    // "rad", "rad/s", "rad/(m/s2)"; not "rad2" nor "N m/rad", where the angle is not a plain numerator.
    if (unit == "rad" || unit.substr(0, 4) == "rad/") return {"deg" + std::string(unit.substr(3)), kDegrees};
    return {std::string(unit), 1};
}

DisplayUnit displayUnitAs(std::string_view unit, std::string_view wanted) {
    struct Conversion {
        std::string_view from, to;
        double scale;
    };
    static constexpr std::array<Conversion, 6> kConversions = {{{"m/s", "km/h", 3.6},
                                                                {"rad/s", "rev/min", kRevolutionsPerMinute},
                                                                {"rad", "deg", kDegrees},
                                                                {"rad/s", "deg/s", kDegrees},
                                                                {"m", "mm", 1000},
                                                                {"-", "%", 100}}};
    for (const Conversion& conversion : kConversions) {
        if (conversion.from == unit && conversion.to == wanted) return {std::string(wanted), conversion.scale};
    }
    return {std::string(unit), 1};
}

}  // namespace tread
