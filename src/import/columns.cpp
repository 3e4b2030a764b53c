#include "import/columns.h"

#include <vector>

#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "base/units/units.h"
#include "import/formats/unit_spelling.h"

namespace tread {
namespace {

[[noreturn]] void fail(const std::string& path, std::string text) {
    throw LoadError({{"", 0, 0, path, std::move(text)}});
}

}  // namespace

const ForeignColumn& foreignColumn(const ForeignTable& table, const std::string& name, const std::string& path) {
    if (const ForeignColumn* column = table.find(name)) return *column;
    std::vector<std::string_view> names;
    for (const ForeignColumn& column : table.columns) names.push_back(column.name);
    const std::string suggestion = didYouMean(name, names);
    fail(path, "found " + quote(name) + ", which is not a column of " + table.file +
                   (suggestion.empty() ? "; its columns are " + quote(listed(names), 400) : suggestion));
}

void expectNumbers(const ForeignColumn& column) {
    if (column.not_a_number) throw LoadError({*column.not_a_number});
}

std::optional<std::string> foreignUnit(const ForeignColumn& column, const std::string& given, const std::string& path,
                                       std::string_view otherwise) {
    if (!given.empty()) {
        const std::string unit = spelledUnit(given);
        if (!unit.empty()) return unit;
        std::string fault;
        parseUnit(given, fault);
        fail(path, fault);
    }
    std::string unit = spelledUnit(column.unit);
    if (unit.empty() && column.unit.empty()) unit = unitInName(column.name);
    if (unit.empty() && column.unit.empty()) unit = otherwise;
    return unit.empty() ? std::nullopt : std::optional(unit);
}

Scaling scalingTo(const std::string& from, const std::string& to, const std::string& path,
                  const ForeignColumn& column) {
    if (from == to) return {};
    std::string fault;
    const auto a = parseUnit(from, fault), b = parseUnit(to, fault);
    if (!a || !b) fail(path, fault);
    if (a->dimension != b->dimension) {
        fail(path, "found " + dimensionName(a->dimension) + " (" + quote(from) + ", the unit of column " +
                       quote(column.name) + "), expected " + dimensionName(b->dimension) + " (" + to +
                       "); correct the unit or the channel");
    }
    return {a->numerator * b->denominator, a->denominator * b->numerator,
            (a->offset - b->offset) * b->denominator / b->numerator};
}

}  // namespace tread
