#include "log/csv_header.h"

#include <algorithm>
#include <set>

#include "base/text/trimmed.h"

namespace tread {
namespace {

constexpr std::size_t kQuotedLength = 40;  // enough to recognise a cell in a message

constexpr std::string_view kBlanks = " \t";

bool isBlank(char c) {
    return kBlanks.find(c) != kBlanks.npos;
}
bool isControl(char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

// One fault per column; the whole list is legal when all are empty.
std::vector<std::string> columnFaults(const std::vector<Column>& columns) {
    std::vector<std::string> faults(columns.size());
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const auto& [name, unit] = columns[i];
        if (name.empty()) {
            faults[i] = "column " + std::to_string(i + 1) + " has no name, expected `name [unit]`";
        } else if (unit.empty()) {
            faults[i] = "column " + shown(name) + " has no unit, expected `name [unit]` (`[-]` for pure numbers)";
        } else if (i == 0 && (name != "time" || unit != "s")) {
            faults[i] = "the first column is " + shown(name + " [" + unit + "]") + ", expected `time [s]`";
        } else if (!names.insert(name).second) {
            faults[i] = "column " + shown(name) + " appears twice";
        }
    }
    return faults;
}

Column columnOf(std::string_view cell) {
    const std::size_t bracket = cell.rfind('[');
    if (bracket == std::string_view::npos || cell.back() != ']') return {std::string(cell), ""};
    const std::string_view unit = cell.substr(bracket + 1, cell.size() - bracket - 2);
    return {std::string(trimmed(cell.substr(0, bracket), kBlanks)), std::string(trimmed(unit, kBlanks))};
}

// Reads a quoted cell from its opening quote; leaves `at` behind the closing one.
HeaderCell quotedCell(std::string_view line, std::size_t& at) {
    HeaderCell cell{"", at + 1, false};
    for (++at; at < line.size(); ++at) {
        if (line[at] != '"') {
            cell.text += line[at];
        } else if (at + 1 < line.size() && line[at + 1] == '"') {
            cell.text += line[++at];
        } else {
            ++at;
            cell.closed = true;
            break;
        }
    }
    while (at < line.size() && isBlank(line[at])) ++at;
    if (at < line.size() && line[at] != ',') cell.closed = false;
    return cell;
}

}  // namespace

std::string shown(std::string_view text) {
    std::string out = "'";
    for (char c : text.substr(0, kQuotedLength)) out += isControl(c) ? '?' : c;
    return out + (text.size() > kQuotedLength ? "...'" : "'");
}

std::string columnFault(const std::vector<Column>& columns) {
    if (columns.empty()) return "there are no columns, expected at least `time [s]`";
    for (const auto& [name, unit] : columns) {
        for (char c : name + unit) {
            if (isControl(c)) return "the name of column " + shown(name) + " contains a control character";
        }
    }
    for (const std::string& fault : columnFaults(columns)) {
        if (!fault.empty()) return fault;
    }
    return {};
}

std::string headerRow(const std::vector<Column>& columns) {
    std::string row;
    for (const auto& [name, unit] : columns) {
        if (!row.empty()) row += ',';
        const std::string cell = name + " [" + unit + "]";
        if (cell.find_first_of(",\"") == std::string::npos) {
            row += cell;
            continue;
        }
        row += '"';
        for (char c : cell) row += c == '"' ? std::string("\"\"") : std::string(1, c);
        row += '"';
    }
    return row + '\n';
}

std::vector<HeaderCell> splitHeader(std::string_view line) {
    std::vector<HeaderCell> cells;
    std::size_t at = 0;
    while (true) {
        while (at < line.size() && isBlank(line[at])) ++at;
        if (at < line.size() && line[at] == '"') {
            cells.push_back(quotedCell(line, at));
        } else {
            cells.push_back({"", at + 1});
        }
        // Up to the comma: the cell itself, or what wrongly follows a closing quote.
        const std::size_t end = std::min(line.find(',', at), line.size());
        if (end > at) cells.back().text += trimmed(line.substr(at, end - at), kBlanks);
        if (end == line.size()) return cells;
        at = end + 1;
    }
}

std::vector<Column> readHeader(std::string_view line, int line_number, const std::string& file,
                               std::vector<Problem>& problems) {
    const std::vector<HeaderCell> cells = splitHeader(line);
    std::vector<Column> columns;
    for (const HeaderCell& cell : cells) columns.push_back(columnOf(cell.text));
    const std::vector<std::string> faults = columnFaults(columns);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const int place = static_cast<int>(cells[i].column);
        if (!cells[i].closed) {
            problems.push_back({file, line_number, place, "", "unclosed quote in " + shown(cells[i].text)});
        } else if (!faults[i].empty()) {
            problems.push_back({file, line_number, place, "", faults[i]});
        }
    }
    return columns;
}

}  // namespace tread
