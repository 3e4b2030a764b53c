// Text tables of other programs: comma, semicolon, tab or blank between cells, decimal point or comma, comment lines,
// lines about the file above the header, a row of units below it or units in the names.
#include <algorithm>
#include <cmath>
#include <map>

#include "import/formats/foreign_table.h"
#include "import/formats/foreign_text.h"
#include "import/formats/unit_spelling.h"

namespace tread {
namespace {

constexpr std::size_t kSampleRows = 200;  // rows that show which delimiter the file has
constexpr std::size_t kHeaderRows = 3;    // names, descriptions, units

bool isComment(std::string_view line) {
    const std::string_view text = trimmedText(line);
    return text.starts_with('#') || text.starts_with('%') || text.starts_with("//") || text.starts_with('!');
}

struct Dialect {
    char delimiter = ',';
    bool decimal_comma = false;
    std::size_t cells = 0;  // in most rows
    double numbers = 0;     // share of the cells that are numbers
};

bool isNumber(std::string_view cell, bool decimal_comma) {
    return cell.empty() || cellNumber(cell, decimal_comma).has_value();
}

// How the rows look with this delimiter. Rows near the end of the sample are data; the header is above.
Dialect tried(char delimiter, bool decimal_comma, const std::vector<TextLine>& lines) {
    const std::size_t rows = std::min(kSampleRows, lines.size());
    const std::size_t first = (lines.size() - rows) / 2;
    std::map<std::size_t, std::size_t> counts;
    for (std::size_t i = 0; i < rows; ++i) ++counts[cellsOf(lines[first + i].text, delimiter).size()];
    Dialect dialect{delimiter, decimal_comma};
    std::size_t most = 0;
    for (const auto& [cells, count] : counts) {
        if (count >= most) std::tie(most, dialect.cells) = std::pair(count, cells);
    }
    std::size_t numbers = 0, all = 0;
    for (std::size_t i = 0; i < rows; ++i) {
        for (const TextCell& cell : cellsOf(lines[first + i].text, delimiter)) {
            ++all;
            numbers += isNumber(cell.text, decimal_comma) && !cell.text.empty();
        }
    }
    dialect.numbers = all == 0 ? 0 : static_cast<double>(numbers) / static_cast<double>(all);
    return dialect;
}

Dialect dialectOf(const std::vector<TextLine>& lines) {
    Dialect best;
    for (const auto& [delimiter, comma] : {std::pair(',', false), std::pair(';', false), std::pair('\t', false),
                                           std::pair(';', true), std::pair('\t', true), std::pair(' ', false)}) {
        const Dialect dialect = tried(delimiter, comma, lines);
        const auto worth = [](const Dialect& d) { return d.numbers * (d.cells > 1 ? 1.0 : 0.5); };
        if (worth(dialect) > worth(best) + 0.02) best = dialect;
    }
    return best;
}

class TableReader {
public:
    TableReader(std::string_view text, ForeignTable& table) : table_(table) {
        for (const TextLine& line : linesOf(text)) {
            if (trimmedText(line.text).empty()) continue;
            (isComment(line.text) ? comments_ : lines_).push_back(line);
        }
    }

    void read() {
        if (lines_.empty()) fail(0, "is empty, expected a header and rows of numbers");
        dialect_ = dialectOf(lines_);
        first_row_ = findFirstRow();
        readHeader();
        for (ForeignColumn& column : table_.columns) column.values.reserve(lines_.size());
        for (std::size_t i = first_row_; i < lines_.size() && problems_.size() < kMostImportFaults; ++i) readRow(i);
        if (!problems_.empty()) throw LoadError(std::move(problems_));
        if (table_.lines.empty()) fail(lines_.back().number, "there are no rows of numbers below the header");
    }

private:
    [[noreturn]] void fail(int line, std::string text) {
        throw LoadError({{table_.file, line, line > 0 ? 1 : 0, "", std::move(text)}});
    }

    std::vector<TextCell> cells(std::size_t line) const { return cellsOf(lines_[line].text, dialect_.delimiter); }

    bool isData(std::size_t line) const {
        std::size_t numbers = 0, words = 0;
        for (const TextCell& cell : cells(line)) {
            if (cell.text.empty()) continue;
            (isNumber(cell.text, dialect_.decimal_comma) ? numbers : words) += 1;
        }
        return numbers > words;
    }

    std::size_t findFirstRow() {
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            const std::size_t count = cells(i).size();
            if (isData(i) && (count == dialect_.cells || count + 1 == dialect_.cells)) return i;
        }
        fail(0, "has no rows of numbers, expected a table with a header, or a .vbo or .mat file");
    }

    // Names, and units where a row below them or the names themselves say so.
    void readHeader() {
        std::vector<TextLine> rows;
        const auto width = [](const std::vector<TextCell>& row) {  // without what a delimiter at the end leaves
            return row.size() - (row.back().text.empty() ? 1 : 0);
        };
        const std::vector<TextCell> first = cells(first_row_);
        for (std::size_t i = first_row_; i > 0 && rows.size() < kHeaderRows; --i) {
            const std::vector<TextCell> row = cells(i - 1);
            const bool fits = row.size() == first.size() || width(row) == first.size() || width(row) == width(first);
            if (!fits) break;
            rows.insert(rows.begin(), lines_[i - 1]);
        }
        if (rows.empty()) rows = headerInComment();
        if (rows.empty()) {
            fail(lines_[first_row_].number,
                 "found numbers in the first row, expected a header with the names of the "
                 "columns above it; add one");
        }
        nameColumns(rows.front());
        for (std::size_t i = rows.size(); i > 1; --i) {
            if (takeUnits(rows[i - 1])) break;
        }
        table_.notes.insert(table_.notes.end(), remarks_.begin(), remarks_.end());
    }

    // "# t, x, y" above the first row.
    std::vector<TextLine> headerInComment() const {
        for (auto comment = comments_.rbegin(); comment != comments_.rend(); ++comment) {
            if (comment->number >= lines_[first_row_].number) continue;
            TextLine line = *comment;
            const std::size_t begin = line.text.find_first_not_of("#%/! \t");
            if (begin == std::string_view::npos) continue;
            line.text.remove_prefix(begin);
            if (cellsOf(line.text, dialect_.delimiter).size() == dialect_.cells) return {line};
        }
        return {};
    }

    void nameColumns(const TextLine& header) {
        std::map<std::string, int> seen;
        for (const TextCell& cell : cellsOf(header.text, dialect_.delimiter)) {
            ForeignColumn column{std::string(cell.text), "", {}, header.number, cell.column, {}};
            takeUnitFromName(column);
            const int times = ++seen[column.name];
            if (times > 1 && !column.name.empty()) {
                const std::string name = column.name + "#" + std::to_string(times);
                remarks_.push_back("the column " + quotedCell(column.name) + " is there more than once; the next is " +
                                   quotedCell(name));
                column.name = name;
            }
            table_.columns.push_back(std::move(column));
        }
        if (table_.columns.back().name.empty()) table_.columns.pop_back();  // a delimiter at the end of the line
    }

    static void takeUnitFromName(ForeignColumn& column) {
        for (const auto& [open, close] : {std::pair('[', ']'), std::pair('(', ')'), std::pair('{', '}')}) {
            const std::size_t begin = column.name.rfind(open);
            if (begin == std::string::npos || begin == 0 || column.name.back() != close) continue;
            const std::string unit = column.name.substr(begin + 1, column.name.size() - begin - 2);
            if (open != '[' && spelledUnit(unit).empty()) continue;  // "accel (front)"
            column.unit = trimmedText(unit);
            column.name = trimmedText(std::string_view(column.name).substr(0, begin));
            return;
        }
    }

    bool takeUnits(const TextLine& row) {
        const std::vector<TextCell> units = cellsOf(row.text, dialect_.delimiter);
        const auto inside = [](std::string_view text) {
            const bool bracketed = text.size() > 1 && (text.front() == '[' || text.front() == '(');
            return bracketed ? text.substr(1, text.size() - 2) : text;
        };
        const auto known = std::count_if(units.begin(), units.end(), [&](const TextCell& cell) {
            return cell.text.empty() || !spelledUnit(inside(cell.text)).empty();
        });
        if (2 * static_cast<std::size_t>(known) < units.size()) return false;
        for (std::size_t i = 0; i < std::min(units.size(), table_.columns.size()); ++i) {
            if (!units[i].text.empty()) table_.columns[i].unit = inside(units[i].text);
        }
        return true;
    }

    void readRow(std::size_t index) {
        const TextLine& line = lines_[index];
        const std::vector<TextCell> row = cells(index);
        const std::size_t columns = table_.columns.size();
        const bool closed = row.size() == columns + 1 && row.back().text.empty();
        if (row.size() != columns && !closed) {
            if (index + 1 == lines_.size() && row.size() < columns) {
                table_.notes.push_back("the file ends within a row (line " + std::to_string(line.number) +
                                       "), which was left out");
                return;
            }
            problems_.push_back({table_.file, line.number, 1, "",
                                 "the row has " + std::to_string(row.size()) + " values, the header has " +
                                     std::to_string(columns) + " columns"});
            return;
        }
        for (std::size_t i = 0; i < columns; ++i) readCell(table_.columns[i], line.number, row[i]);
        table_.lines.push_back(line.number);
    }

    void readCell(ForeignColumn& column, int line, const TextCell& cell) {
        const auto value = cell.text.empty() ? kNoNumber : cellNumber(cell.text, dialect_.decimal_comma);
        if (!value && !column.not_a_number) {
            column.not_a_number = {table_.file, line, cell.column, column.name,
                                   "found " + quotedCell(cell.text) + ", which is not a number"};
        }
        column.values.push_back(value.value_or(kNoNumber));
    }

    ForeignTable& table_;
    std::vector<TextLine> lines_, comments_;
    Dialect dialect_;
    std::size_t first_row_ = 0;
    std::vector<std::string> remarks_;
    std::vector<Problem> problems_;
};

}  // namespace

ForeignTable parseForeignCsv(std::string raw, const std::string& file) {
    ForeignTable table{file, "text table", {}, {}, {}};
    const std::string text = foreignText(std::move(raw), file, table.notes);
    TableReader(text, table).read();
    return table;
}

}  // namespace tread
