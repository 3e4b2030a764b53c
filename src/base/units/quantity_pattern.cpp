#include "base/units/quantity_pattern.h"

#include <optional>

#include "base/text/concat.h"
#include "base/units/units.h"

namespace tread {
namespace {

constexpr std::string_view kNumber = "([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+-]?[0-9]+)?";
constexpr std::string_view kLetter = "A-Za-z%°µμ";
constexpr std::string_view kOperator = " /^*·²³0-9(.-";  // a unit with one of these is put together

struct SingleNames {
    std::string names;        // "m|km|in"
    bool has_offset = false;  // negative numbers can be positive quantities: -5 degC
};

// The names of all units of the dimension that consist of one word.
SingleNames singleNames(const Dimension& dimension) {
    SingleNames found;
    const auto add = [&](const std::string& name) {
        std::string fault;
        const auto unit = parseUnit(name, fault);
        if (!unit || unit->dimension != dimension) return;
        found.names += found.names.empty() ? "" : "|";
        found.names += name;
        found.has_offset = found.has_offset || unit->offset != 0;
    };
    add("-");
    for (const NamedUnit& named : namedUnits()) {
        add(std::string(named.name));
        if (!named.prefixes) continue;
        for (char letter = 'A'; letter <= 'z'; ++letter) add(letter + std::string(named.name));
        for (const char* micro : {"µ", "μ"}) add(micro + std::string(named.name));
    }
    return found;
}

}  // namespace

std::string quantityPattern(std::string_view unit, const Limits& limits) {
    std::string fault;
    const auto parsed = parseUnit(unit, fault);
    if (!parsed) return concat({"^\\s*[+-]?", kNumber, "(\\s+1[ /].*|\\s*[", kLetter, "(].*)?\\s*$"});
    const SingleNames single = singleNames(parsed->dimension);
    const bool negative = !(limits.lowest >= 0) || single.has_offset;
    const std::string one = single.names.empty() ? "" : concat({"(", single.names, ")?"});
    return concat({"^\\s*", negative ? "[+-]?" : "\\+?", kNumber, "\\s*(", one, "\\s*|1[ /].*|\\(.*|[", kLetter, "]+[",
                   kOperator, "].*)$"});
}

}  // namespace tread
