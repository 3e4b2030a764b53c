#include "log/log_columns.h"

#include <fstream>
#include <unordered_map>

#include "base/concat.h"
#include "base/number_text.h"
#include "base/numbers.h"
#include "log/csv_header.h"

namespace tread {
namespace {

struct Header {
    int line = 0;
    std::vector<HeaderCell> cells;
};

// The first line that is neither empty nor a comment, as the reader of logs finds it.
Header findHeader(const std::string& file) {
    std::ifstream stream(file);
    Header header;
    for (std::string line; std::getline(stream, line);) {
        ++header.line;
        if (line.find_first_not_of(" \t\r") == std::string::npos || line.front() == '#') continue;
        header.cells = splitHeader(line);
        break;
    }
    return header;
}

}  // namespace

std::optional<std::string_view> logUnit(const std::string& name) {
    static const auto units = [] {
        LogColumns columns;
        std::unordered_map<std::string, std::string_view> by_name;
        for (const Number& number : numbers(columns)) by_name.emplace(number.path, number.about.unit);
        return by_name;
    }();
    const auto found = units.find(name);
    return found == units.end() ? std::nullopt : std::optional(found->second);
}

std::vector<Problem> unitFaults(const Log& log, const std::string& file) {
    const Header header = findHeader(file);
    std::vector<Problem> problems;
    for (std::size_t i = 0; i < log.channels.size(); ++i) {
        const Channel& channel = log.channels[i];
        const auto known = logUnit(channel.name);
        if (!known || *known == channel.unit) continue;
        const bool placed = i < header.cells.size();
        problems.push_back({file, placed ? header.line : 0, placed ? static_cast<int>(header.cells[i].column) : 0,
                            channel.name,
                            concat({"found the unit ", quote(channel.unit), ", expected ", quote(*known),
                                    "; convert the column or give it another name"})});
    }
    return problems;
}

}  // namespace tread
