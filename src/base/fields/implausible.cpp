#include "base/fields/implausible.h"

#include <cmath>
#include <optional>

#include "base/text/concat.h"
#include "base/text/number_text.h"
#include "base/text/trimmed.h"
#include "base/units/slip.h"

namespace tread {
namespace {

std::string withUnit(const std::string& number, std::string_view unit) {
    return unit.empty() || unit == "-" ? number : concat({number, " ", unit});
}

// Ends of a range that was computed have more digits than they are worth.
std::string rounded(double value) {
    if (value == 0 || !std::isfinite(value)) return numberText(value);
    const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value)))) - 2;
    const double unit = std::pow(10.0, std::abs(exponent));
    if (!std::isfinite(unit)) return numberText(value);  // too small to be rounded so
    return numberText(exponent < 0 ? std::round(value * unit) / unit : std::round(value / unit) * unit);
}

// "1250 lb (567 kg)", "550 m".
std::string foundText(const Implausible& number, std::string_view written) {
    const std::string si = withUnit(rounded(number.value), number.unit);
    const std::string_view given = trimmed(written);
    std::string_view rest = given;
    const auto bare = takeNumber(rest);
    if (!bare) return si;
    if (trimmed(rest).empty()) return withUnit(std::string(given), number.unit);
    return trimmed(rest) == number.unit ? std::string(given) : concat({given, " (", si, ")"});
}

}  // namespace

std::string usualText(const Usual& usual) {
    if (!usual.said || (usual.lowest == -kInfinity && usual.highest == kInfinity)) return {};
    return rounded(usual.lowest) + " to " + rounded(usual.highest);
}

std::string implausibleText(const Implausible& number, std::string_view written) {
    const std::string slip =
        likelySlip(written.empty() ? numberText(number.value) : written, number.unit, number.usual);
    return concat({"found ", foundText(number, written), ", plausible values are ",
                   withUnit(usualText(number.usual), number.unit), number.why.empty() ? "" : " ", number.why,
                   slip.empty() ? "; check value and unit" : "; did you mean ", slip, slip.empty() ? "" : "?"});
}

namespace detail {

Way Way::to(std::string_view name, std::string_view old_name) const {
    Way way{joinPath(path, name), {}};
    for (const std::string& place : places) {
        way.places.push_back(joinPath(place, name));
        if (!old_name.empty()) way.places.push_back(joinPath(place, old_name));
    }
    return way;
}

void Judge::number(double value, const Way& way, std::string_view unit, const Usual& usual) {
    if (!usual.said || std::isnan(value) || usual.has(value)) return;
    found.push_back({way.path, way.places, value, std::string(unit), usual});
}

void Judge::curve(const Curve& curve, const Way& way, const About& about) {
    const std::size_t before = found.size();
    for (std::size_t i = 0; i < curve.points.size() && found.size() == before; ++i) {
        Way x = way.at(i).to("0"), y = way.at(i).to("1");
        x.path = joinPath(joinPath(way.path, std::to_string(i)), "x");
        y.path = joinPath(joinPath(way.path, std::to_string(i)), "y");
        number(curve.points[i].x, x, about.argument, about.usual_argument);
        number(curve.points[i].y, y, about.unit, about.usual);
    }
}

}  // namespace detail
}  // namespace tread
