#include "scenario/condition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/text/number_text.h"
#include "base/text/trimmed.h"
#include "base/units/units.h"
#include "tread/describe.h"

namespace tread {
namespace {

using Kind = Condition::Kind;

constexpr double kRounding = 1e-9;  // share of a wanted value by which an equal one may differ

// Longer signs first.
constexpr std::array<std::pair<std::string_view, Kind>, 8> kSigns = {{{"<=", Kind::at_most},
                                                                      {">=", Kind::at_least},
                                                                      {"==", Kind::equal},
                                                                      {"\u2264", Kind::at_most},
                                                                      {"\u2265", Kind::at_least},
                                                                      {"<", Kind::less},
                                                                      {">", Kind::greater},
                                                                      {"=", Kind::equal}}};
constexpr std::array<std::pair<std::string_view, Kind>, 3> kBetween = {
    {{"..", Kind::range}, {"+-", Kind::around}, {"\u00b1", Kind::around}}};

// What follows the number; nothing when there is none.
std::optional<std::string_view> unitOf(std::string_view quantity) {
    std::string_view rest = trimmed(quantity);
    if (!takeNumber(rest)) return {};
    return trimmed(rest);
}

bool isQuantity(std::string_view text, std::string& fault) {
    const auto unit = unitOf(text);
    if (unit) return parseUnit(*unit, fault).has_value();
    fault = "found " + quote(text) + ", which is not a number";
    return false;
}

std::optional<Condition> notOne(std::string_view text, const std::string& why, std::string& fault) {
    fault = (why.empty() ? "found " + quote(text) : why + " in " + quote(text)) +
            R"(, expected a condition such as "< 40 m", "= 0", "30 .. 40 m" or "38.2 m +- 2 %"; correct it)";
    return {};
}

}  // namespace

std::optional<Condition> parseCondition(std::string_view whole, std::string& fault) {
    const std::string_view text = trimmed(whole);
    Condition condition;
    for (const auto& [sign, kind] : kSigns) {
        if (!text.starts_with(sign)) continue;
        condition = {kind, std::string(trimmed(text.substr(sign.size()))), ""};
        std::string why;
        if (!isQuantity(condition.first, why)) return notOne(text, why, fault);
        return condition;
    }
    for (const auto& [sign, kind] : kBetween) {
        const std::size_t at = text.find(sign);
        if (at == std::string_view::npos) continue;
        condition = {kind, std::string(trimmed(text.substr(0, at))),
                     std::string(trimmed(text.substr(at + sign.size())))};
        std::string why;
        if (!isQuantity(condition.first, why) || !isQuantity(condition.second, why)) return notOne(text, why, fault);
        // "30 .. 40 m": the unit behind the range is that of both ends.
        if (kind == Kind::range && unitOf(condition.first)->empty())
            condition.first += " " + std::string(*unitOf(condition.second));
        return condition;
    }
    return notOne(text, "", fault);
}

bool Interval::holds(double value) const {
    const bool above = lowest_open ? value > lowest : value >= lowest;
    const bool below = highest_open ? value < highest : value <= highest;
    return above && below;
}

std::optional<Interval> intervalOf(const Condition& condition, std::string_view unit, std::string& fault) {
    const auto first = toSi(condition.first, unit, fault);
    if (!first) return {};
    const double rounding = kRounding * std::abs(*first);
    switch (condition.kind) {
        case Kind::less:
            return Interval{-kInfinity, *first, false, true};
        case Kind::at_most:
            return Interval{-kInfinity, *first};
        case Kind::greater:
            return Interval{*first, kInfinity, true, false};
        case Kind::at_least:
            return Interval{*first, kInfinity};
        case Kind::equal:
            return Interval{*first - rounding, *first + rounding};
        case Kind::range:
        case Kind::around:
            break;
    }
    const bool share = condition.kind == Kind::around && unit != "%" && unitOf(condition.second) == "%";
    auto second = toSi(condition.second, share ? "-" : unit, fault);
    if (!second) return {};
    if (condition.kind == Kind::range) {
        if (*second < *first) {
            fault = "found a range from " + condition.first + " to " + condition.second +
                    ", expected the smaller number first; exchange them";
            return {};
        }
        return Interval{*first, *second};
    }
    if (share) second = *second * std::abs(*first);
    if (*second < 0) {
        fault = "found the tolerance " + condition.second + ", expected none below 0; write it without sign";
        return {};
    }
    return Interval{*first - *second - rounding, *first + *second + rounding};
}

}  // namespace tread
