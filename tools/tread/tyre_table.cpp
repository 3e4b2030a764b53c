#include "tyre_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <system_error>
#include <utility>

#include "base/text/concat.h"
#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "base/text/text_file.h"
#include "log/csv_header.h"
#include "log/csv_lines.h"
#include "tread/problem.h"

namespace tread::program {
namespace {

constexpr std::size_t kMostProblems = 20;  // faults reported at most

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

// "Vx [km/h]" split into its parts.
struct NameAndUnit {
    std::string_view name;
    std::optional<std::string_view> unit;
};

NameAndUnit takeApart(std::string_view header) {
    const std::size_t bracket = header.find('[');
    if (bracket == std::string_view::npos || header.back() != ']') return {header, {}};
    return {trimmed(header.substr(0, bracket)), trimmed(header.substr(bracket + 1, header.size() - bracket - 2))};
}

class Reader {
public:
    Reader(std::string_view text, const std::string& file, const std::vector<ColumnKind>& kinds)
        : lines_(text), kinds_(kinds) {
        table_.file = file;
    }

    InputTable read() {
        checkText();
        if (!lines_.next()) throw LoadError({{table_.file, 0, 0, "", "is empty, expected a header of column names"}});
        readHeader();
        throwProblems();
        while (problems_.size() < kMostProblems && lines_.next()) readRow();
        throwProblems();
        if (table_.rows() == 0)
            throw LoadError({{table_.file, lines_.number(), 1, "", "has no rows below the header"}});
        return std::move(table_);
    }

private:
    void complain(std::size_t column, std::string path, std::string text) {
        problems_.push_back({table_.file, lines_.number(), static_cast<int>(column), std::move(path), std::move(text)});
    }
    void throwProblems() {
        if (!problems_.empty()) throw LoadError(std::move(problems_));
    }

    void checkText() {
        if (lines_.rest().find('\0') != std::string_view::npos) {
            throw LoadError(
                {{table_.file, 0, 0, "", "is not a text file, expected CSV with a header of column names"}});
        }
    }

    void readHeader() {
        std::vector<bool> seen(kinds_.size());
        for (const HeaderCell& cell : splitHeader(lines_.line())) readHeaderCell(cell, seen);
        if (!problems_.empty()) return;
        for (std::size_t kind = 0; kind < kinds_.size(); ++kind) {
            const auto& [name, about, required] = kinds_[kind];
            if (!required || seen[kind]) continue;
            complain(1, "",
                     concat({"found no column ", quote(name), " (", about.meaning, ", in ", about.unit, "); add it"}));
        }
    }

    void readHeaderCell(const HeaderCell& cell, std::vector<bool>& seen) {
        if (!cell.closed) return complain(cell.column, "", "unclosed quote in " + quote(cell.text));
        const NameAndUnit given = takeApart(cell.text);
        const std::string_view name = given.name;
        const auto known =
            std::find_if(kinds_.begin(), kinds_.end(), [&](const ColumnKind& kind) { return kind.name == name; });
        if (known == kinds_.end()) return complain(cell.column, "", unknownColumn(name));
        const auto kind = static_cast<std::size_t>(known - kinds_.begin());
        if (seen[kind]) return complain(cell.column, "", "column " + quote(name) + " appears twice");
        seen[kind] = true;
        table_.columns.push_back({cell.text, kind, unitOf(cell, *known, given.unit)});
    }

    std::string unknownColumn(std::string_view name) const {
        if (name.empty()) return "found a column without a name";
        if (name.find_first_of(";\t") != std::string_view::npos) {
            return "found " + quote(name) + ", expected column names separated by commas";
        }
        std::vector<std::string_view> all, required;
        for (const ColumnKind& kind : kinds_) {
            all.push_back(kind.name);
            if (kind.required) required.push_back(kind.name);
        }
        const std::string more = all.size() > required.size() ? ", or a scaling factor such as lambda_mux" : "";
        return concat({"found the column ", quote(name), ", expected ", listed(required), more, didYouMean(name, all)});
    }

    Unit unitOf(const HeaderCell& cell, const ColumnKind& kind, std::optional<std::string_view> given) {
        if (!given) return {};
        table_.has_units = true;
        std::string fault;
        const auto unit = parseUnit(*given, fault);
        const auto expected = parseUnit(kind.about.unit, fault).value();
        const std::string wanted = concat({dimensionName(expected.dimension), " such as [", kind.about.unit, "]"});
        if (!unit) {
            complain(cell.column, kind.name, concat({"found the unknown unit ", quote(*given), ", expected ", wanted}));
            return {};
        }
        if (unit->dimension != expected.dimension) {
            complain(cell.column, kind.name,
                     concat({"found the unit ", quote(*given), ", ", dimensionName(unit->dimension), "; expected ",
                             wanted}));
        }
        return *unit;
    }

    void readRow() {
        const std::string_view line = lines_.line();
        const std::size_t start = table_.values.size(), columns = table_.columns.size();
        std::size_t at = 0, count = 0;
        const std::size_t problems_before = problems_.size();
        for (; count < columns; ++count) {
            const std::size_t end = std::min(line.find(',', at), line.size());
            readCell(line.substr(at, end - at), at + 1, count);
            if (end == line.size()) break;
            at = end + 1;
        }
        const auto cells = static_cast<std::size_t>(std::count(line.begin(), line.end(), ',')) + 1;
        if (cells != columns) {
            problems_.resize(problems_before);  // the cells may belong to other columns
            complain(at + 1, "",
                     concat({"found ", counted(cells, "value"), ", the header has ", counted(columns, "column")}));
        }
        if (problems_.size() > problems_before) {
            table_.values.resize(start);
            table_.places.resize(start);
        } else {
            table_.lines.push_back(lines_.number());
        }
    }

    void readCell(std::string_view cell, std::size_t place, std::size_t column) {
        const ColumnKind& kind = kinds_[table_.columns[column].kind];
        std::string_view text = trimmed(cell);
        const std::string_view shown = text;
        if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
        double value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        table_.values.push_back(value);
        table_.places.push_back(static_cast<int>(place));
        const double si = toSi(value, table_.columns[column].unit);

        if (shown.empty()) {
            complain(place, kind.name, "found an empty cell, expected a number");
        } else if (error == std::errc::result_out_of_range) {
            complain(place, kind.name, concat({"found ", quote(shown), ", beyond the range of numbers"}));
        } else if (error != std::errc{} || end != text.data() + text.size()) {
            complain(place, kind.name, concat({"found ", quote(shown), ", expected a number"}));
        } else if (!std::isfinite(si)) {
            complain(place, kind.name, concat({"found ", quote(shown), ", expected a finite number"}));
        } else if (!kind.about.limits.allow(si)) {
            complain(place, kind.name, concat({"found ", quote(shown), ", expected ", limitsText(kind.about.limits)}));
        }
    }

    CsvLines lines_;
    const std::vector<ColumnKind>& kinds_;
    InputTable table_;
    std::vector<Problem> problems_;
};

}  // namespace

InputTable readTable(const Path& file, const std::vector<ColumnKind>& kinds) {
    std::string fault;
    const auto text = readWholeFile(file, fault);
    if (!text) throw LoadError({{file.string(), 0, 0, "", "cannot be read: " + fault}});
    return Reader(*text, file.string(), kinds).read();
}

void Columns::add(ColumnKind kind, double& variable, double sign) {
    kinds.push_back(std::move(kind));
    variables.push_back({&variable, sign});
}

void fill(const Columns& columns, const InputTable& table, std::size_t row) {
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const Columns::Variable& variable = columns.variables[table.columns[i].kind];
        *variable.value = variable.sign * table.si(row, i);
    }
}

}  // namespace tread::program
