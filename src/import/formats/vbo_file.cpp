// Racelogic VBOX files (.vbo): text in sections. [header] names the channels, one a line, the standard ones with their
// unit behind the name ("velocity kmh"); [channel units] has the units of the last channels, one a line; [data] has one
// row of blank-separated numbers per sample. Time is UTC as HHMMSS.SS, latitude and longitude are in minutes with
// longitude positive to the west. (Racelogic support centre, "VBO file format".)
#include <map>

#include "import/formats/foreign_table.h"
#include "import/formats/foreign_text.h"
#include "import/formats/unit_spelling.h"

namespace tread {
namespace {

struct Section {
    int line = 0;
    std::vector<TextLine> lines;
};

std::map<std::string, Section> sectionsOf(std::string_view text) {
    std::map<std::string, Section> sections;
    Section* open = nullptr;
    for (const TextLine& line : linesOf(text)) {
        const std::string_view words = trimmedText(line.text);
        if (words.starts_with('[') && words.ends_with(']')) {
            open = &sections[std::string(words.substr(1, words.size() - 2))];
            open->line = line.number;
        } else if (open) {
            open->lines.push_back(line);
        }
    }
    return sections;
}

const Section& needed(const std::map<std::string, Section>& sections, const std::string& name,
                      const std::string& file) {
    const auto found = sections.find(name);
    if (found != sections.end()) return found->second;
    const char* why = sections.empty() ? "is not a VBOX file: it has no sections" : "has no section";
    throw LoadError({{file, 0, 0, "",
                      std::string(why) + ", expected [" + name +
                          "] as in every .vbo file; is it cut off or of another "
                          "kind?"}});
}

// The unit behind a standard name: "velocity kmh", "Long accel g".
ForeignColumn columnOf(const TextLine& line) {
    ForeignColumn column;
    const std::string_view whole = trimmedText(line.text);
    const std::size_t blank = whole.rfind(' ');
    const std::string unit = blank == std::string_view::npos ? "" : spelledUnit(whole.substr(blank + 1));
    column.name = unit.empty() ? whole : trimmedText(whole.substr(0, blank));
    column.unit = unit.empty() ? "" : whole.substr(blank + 1);
    column.line = line.number;
    column.column = 1 + static_cast<int>(whole.data() - line.text.data());
    return column;
}

// An empty line ends a section; units may be empty lines themselves.
void takeUnits(const Section& section, std::vector<ForeignColumn>& columns) {
    std::vector<TextLine> lines = section.lines;
    if (!lines.empty() && trimmedText(lines.back().text).empty()) lines.pop_back();
    if (lines.size() > columns.size()) return;
    const std::size_t first = columns.size() - lines.size();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string_view unit = trimmedText(lines[i].text);
        if (!unit.empty()) columns[first + i].unit = unit;
    }
}

class Rows {
public:
    explicit Rows(ForeignTable& table) : table_(table) {}

    void read(const Section& data) {
        for (std::size_t i = 0; i < data.lines.size() && problems_.size() < kMostImportFaults; ++i) {
            const TextLine& line = data.lines[i];
            const std::vector<TextCell> cells = cellsOf(line.text, ' ');
            if (cells.empty()) continue;
            if (cells.size() == table_.columns.size()) {
                readRow(line, cells);
            } else if (isLast(data, i) && cells.size() < table_.columns.size()) {
                table_.notes.push_back("the file ends within a row (line " + std::to_string(line.number) +
                                       "), which was left out");
            } else {
                fault(line, 1,
                      "the row has " + std::to_string(cells.size()) + " values, the header names " +
                          std::to_string(table_.columns.size()) + " channels");
            }
        }
        if (!problems_.empty()) throw LoadError(std::move(problems_));
    }

private:
    static bool isLast(const Section& data, std::size_t i) {
        for (++i; i < data.lines.size(); ++i) {
            if (!trimmedText(data.lines[i].text).empty()) return false;
        }
        return true;
    }

    void readRow(const TextLine& line, const std::vector<TextCell>& cells) {
        for (std::size_t i = 0; i < cells.size(); ++i) {
            ForeignColumn& column = table_.columns[i];
            const auto value = cellNumber(cells[i].text, false);
            if (!value && !column.not_a_number) {
                column.not_a_number = {table_.file, line.number, cells[i].column, column.name,
                                       "found " + quotedCell(cells[i].text) + ", which is not a number"};
            }
            column.values.push_back(value.value_or(kNoNumber));
        }
        table_.lines.push_back(line.number);
    }

    void fault(const TextLine& line, int column, std::string text) {
        problems_.push_back({table_.file, line.number, column, "", std::move(text)});
    }

    ForeignTable& table_;
    std::vector<Problem> problems_;
};

}  // namespace

ForeignTable parseVbo(std::string raw, const std::string& file) {
    ForeignTable table{file, "VBOX file", {}, {}, {}};
    const std::string text = foreignText(std::move(raw), file, table.notes);
    const auto sections = sectionsOf(text);
    for (const TextLine& line : needed(sections, "header", file).lines) {
        if (!trimmedText(line.text).empty()) table.columns.push_back(columnOf(line));
    }
    const Section& data = needed(sections, "data", file);
    if (table.columns.empty()) {
        throw LoadError({{file, sections.at("header").line, 1, "", "the section [header] names no channel"}});
    }
    if (const auto units = sections.find("channel units"); units != sections.end()) {
        takeUnits(units->second, table.columns);
    }
    Rows(table).read(data);
    if (table.lines.empty()) throw LoadError({{file, data.line, 1, "", "the section [data] has no rows"}});
    return table;
}

}  // namespace tread
