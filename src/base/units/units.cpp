#include "base/units/units.h"

#include <cmath>
#include <vector>

#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "base/text/trimmed.h"

namespace tread {
namespace {

constexpr std::size_t kLongestUnit = 64;  // characters; bounds recursion and exponents
constexpr int kLargestExponent = 9;

struct Prefix {
    char letter;
    double numerator;
    double denominator;
};
constexpr Prefix kPrefixes[] = {{'G', 1e9, 1}, {'M', 1e6, 1},  {'k', 1e3, 1},
                                {'c', 1, 100}, {'m', 1, 1000}, {'u', 1, 1e6}};

// Composite units that are offered when a unit is mistyped, beside the named ones.
constexpr std::string_view kComposites[] = {
    "km/h",   "m/s",   "m/s2",   "rad/s",     "deg/s", "N/m", "N/mm", "kN/m", "N s/m", "N m", "N m/rad",
    "Nm/deg", "kg m2", "kN s/m", "N m s/rad", "kg/m3", "kW",  "kPa",  "mm",   "km",    "ms",  "kN"};

std::optional<Unit> namedUnit(std::string_view name) {
    for (const NamedUnit& candidate : namedUnits()) {
        if (candidate.name == name) return candidate.unit;
    }
    return {};
}

// A unit by its name, with or without a prefix: "m", "kN".
std::optional<Unit> findUnit(std::string_view name) {
    if (const auto unit = namedUnit(name)) return unit;
    for (const Prefix& prefix : kPrefixes) {
        if (name.size() < 2 || name.front() != prefix.letter) continue;
        for (const NamedUnit& candidate : namedUnits()) {
            if (!candidate.prefixes || candidate.name != name.substr(1)) continue;
            Unit unit = candidate.unit;
            unit.numerator *= prefix.numerator;
            unit.denominator *= prefix.denominator;
            return unit;
        }
    }
    return {};
}

void multiply(Unit& unit, const Unit& factor, int exponent) {
    for (int i = 0; i < std::abs(exponent); ++i) {
        unit.numerator *= exponent > 0 ? factor.numerator : factor.denominator;
        unit.denominator *= exponent > 0 ? factor.denominator : factor.numerator;
    }
    for (std::size_t i = 0; i < unit.dimension.size(); ++i) unit.dimension[i] += exponent * factor.dimension[i];
}

// Typographic signs in the spelling that the parser knows.
std::string plainSpelling(std::string_view text) {
    constexpr std::string_view kSigns[][2] = {{"²", "2"}, {"³", "3"}, {"·", " "}, {"µ", "u"}, {"μ", "u"}, {"*", " "}};
    std::string out;
    while (!text.empty()) {
        bool replaced = false;
        for (const auto& [sign, plain] : kSigns) {
            if (replaced || !text.starts_with(sign)) continue;
            out += plain;
            text.remove_prefix(sign.size());
            replaced = true;
        }
        if (!replaced) {
            out += text.front();
            text.remove_prefix(1);
        }
    }
    return out;
}

// product := factor { [" " | "/"] factor };  factor := ("1" | name | "(" product ")") [["^"] integer]
class UnitParser {
public:
    // `expected` becomes part of every fault: ", expected N/m".
    UnitParser(std::string_view text, std::string_view expected, std::string& fault)
        : whole_(text), rest_(text), expected_(expected), fault_(fault) {}

    std::optional<Unit> parse() {
        const auto unit = product();
        if (unit && !rest_.empty()) return unknown(rest_);
        // Only a temperature that stands alone has a zero to shift: 1/degC is not 1/(K + 273.15).
        if (unit && has_offset_ && factors_ > 1) {
            return fail("found degC inside the unit " + quote(whole_), "write K for a difference of temperatures");
        }
        return unit;
    }

private:
    std::optional<Unit> product() {
        Unit unit;
        bool divided = false;
        skipSpaces();
        for (bool first = true; first || !(rest_.empty() || rest_.front() == ')'); first = false) {
            const bool slash = !first && take('/');
            if (!slash && divided) {
                return fail("found the unit " + quote(whole_) + ", which can be read in two ways",
                            "put the denominator in parentheses, a/(b c)");
            }
            divided = divided || slash;
            skipSpaces();
            const auto next = factor(slash ? -1 : 1);
            if (!next) return {};
            if (next->offset != 0) unit.offset = next->offset;
            multiply(unit, *next, 1);
            skipSpaces();
        }
        return unit;
    }

    std::optional<Unit> factor(int sign) {
        ++factors_;
        std::optional<Unit> base;
        if (take('(')) {
            base = product();
            if (base && !take(')')) {
                return fail("found an open parenthesis in the unit " + quote(whole_), "close it");
            }
        } else if (rest_ == "1" || rest_.starts_with("1/") || rest_.starts_with("1 ")) {
            take('1');
            base = Unit{};
        } else {
            const std::string_view name = takeName();
            base = findUnit(name);
            if (!base) return unknown(name);
        }
        if (!base) return {};
        const auto exponent = takeExponent();
        if (!exponent) {
            return fail("found an exponent in the unit " + quote(whole_) + " that is not a whole number up to 9",
                        "correct it");
        }
        if (base->offset != 0) has_offset_ = true;
        if (*exponent == 1 && sign == 1) return base;
        if (base->offset != 0) factors_ += 1;
        Unit power;
        multiply(power, *base, sign * *exponent);
        return power;
    }

    std::string_view takeName() {
        std::size_t length = 0;
        while (length < rest_.size() &&
               std::string_view(" /()^-+.,0123456789").find(rest_[length]) == std::string_view::npos) {
            ++length;
        }
        const std::string_view name = rest_.substr(0, length);
        rest_.remove_prefix(length);
        return name;
    }

    std::optional<int> takeExponent() {
        const std::string_view before = rest_;
        const bool caret = take('^');
        const bool negative = take('-');
        std::size_t length = 0;
        while (length < rest_.size() && rest_[length] >= '0' && rest_[length] <= '9') ++length;
        if (length == 0) {
            if (!caret) rest_ = before;
            return caret ? std::optional<int>{} : 1;
        }
        const int exponent = rest_.front() - '0';
        rest_.remove_prefix(length);
        if (length > 1 || exponent > kLargestExponent) return {};
        return negative ? -exponent : exponent;
    }

    bool take(char c) {
        if (rest_.empty() || rest_.front() != c) return false;
        rest_.remove_prefix(1);
        return true;
    }

    void skipSpaces() {
        while (take(' ')) {
        }
    }

    std::optional<Unit> fail(std::string_view found, std::string_view advice) {
        fault_ = std::string(found) + std::string(expected_) + "; " + std::string(advice);
        return {};
    }

    std::optional<Unit> unknown(std::string_view name) {
        std::vector<std::string_view> candidates(std::begin(kComposites), std::end(kComposites));
        for (const NamedUnit& unit : namedUnits()) candidates.push_back(unit.name);
        auto suggestion = closest(whole_, candidates);
        if (!suggestion) suggestion = closest(name, candidates);
        const std::string within = name == whole_ || name.empty() ? "" : " in " + quote(whole_);
        return fail("found the unknown unit " + quote(name.empty() ? whole_ : name) + within,
                    suggestion ? "did you mean \"" + std::string(*suggestion) + "\"?"
                               : "write another unit of the same kind, or leave it out");
    }

    std::string_view whole_;
    std::string_view rest_;
    std::string_view expected_;
    std::string& fault_;
    int factors_ = 0;
    bool has_offset_ = false;
};

// How the wanted unit is named in a message.
std::string wanted(std::string_view unit) {
    return unit.empty() || unit == "-" ? "a pure number" : std::string(unit);
}

std::optional<Unit> parse(std::string_view text, std::string_view expected, std::string& fault) {
    text = trimmed(text);
    if (text.empty() || text == "-") return Unit{};
    if (text.size() > kLongestUnit) {
        fault = "found the unknown unit " + quote(text) + std::string(expected) + "; correct it or leave it out";
        return {};
    }
    const std::string plain = plainSpelling(text);
    return UnitParser(plain, expected, fault).parse();
}

}  // namespace

std::optional<Unit> parseUnit(std::string_view text, std::string& fault) {
    return parse(text, "", fault);
}

std::optional<double> toSi(std::string_view text, std::string_view unit, std::string& fault) {
    const std::string_view all = trimmed(text);
    std::string_view rest = all;
    const auto number = takeNumber(rest);
    if (!number) {
        fault = "found " + quote(all) + ", which is not a number, expected " + wanted(unit) +
                "; write a decimal number, alone or followed by a unit";
        return {};
    }
    rest = trimmed(rest);
    if (rest.empty() || rest == unit) return number;

    const auto from = parse(rest, ", expected " + wanted(unit), fault);
    const auto to = parse(unit, "", fault);
    if (!from || !to) return {};
    if (from->dimension != to->dimension) {
        const std::string gravity = rest == "g" ? "; g is standard gravity, write a mass in kg" : "; correct the unit";
        fault =
            "found " + dimensionName(from->dimension) + " (" + quote(rest) + "), expected " + wanted(unit) + gravity;
        return {};
    }
    const double si = *number * from->numerator / from->denominator + from->offset;
    const double value = (si - to->offset) * to->denominator / to->numerator;
    if (!std::isfinite(value)) {
        fault = "found " + quote(all) + ", which is too large; correct the number or its unit";
        return {};
    }
    return value;
}

}  // namespace tread
