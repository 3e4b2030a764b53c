#include "log/log_columns.h"

#include <optional>
#include <string_view>
#include <unordered_map>

#include "base/fields/numbers.h"
#include "base/text/concat.h"
#include "base/text/number_text.h"
#include "base/text/text_file.h"
#include "log/csv_header.h"
#include "log/csv_lines.h"

namespace tread {

template void detail::FieldsOf<LogColumns>::addNumbers(LogColumns&, const std::string&, std::vector<Number>&);

namespace {

struct Header {
    int line = 0;
    std::vector<HeaderCell> cells;
};

Header headerOf(const std::string& file) {
    std::string fault;
    const auto text = readWholeFile(file, fault);
    CsvLines lines(text ? *text : std::string_view());
    return lines.next() ? Header{lines.number(), splitHeader(lines.line())} : Header{};
}

}  // namespace

std::string_view quantityOf(std::string_view channel) {
    return channel.substr(0, channel.find('@'));
}

std::string_view sourceOf(std::string_view channel) {
    const std::size_t at = channel.find('@');
    return at == std::string_view::npos ? std::string_view() : channel.substr(at + 1);
}

std::optional<std::string_view> logUnit(const std::string& name) {
    static const auto units = [] {
        LogColumns columns;
        std::unordered_map<std::string, std::string_view> by_name;
        for (const Number& number : numbers(columns)) by_name.emplace(number.path, number.about.unit);
        return by_name;
    }();
    const auto found = units.find(std::string(quantityOf(name)));
    return found == units.end() ? std::nullopt : std::optional(found->second);
}

std::vector<Problem> unitFaults(const Log& log, const std::string& file) {
    std::optional<Header> header;
    std::vector<Problem> problems;
    for (std::size_t i = 0; i < log.channels.size(); ++i) {
        const Channel& channel = log.channels[i];
        const auto known = logUnit(channel.name);
        if (!known || *known == channel.unit) continue;
        if (!header) header = headerOf(file);
        const bool placed = i < header->cells.size();
        problems.push_back({file, placed ? header->line : 0, placed ? static_cast<int>(header->cells[i].column) : 0,
                            channel.name,
                            concat({"found the unit ", quote(channel.unit), ", expected ", quote(*known),
                                    "; convert the column or give it another name"})});
    }
    return problems;
}

}  // namespace tread
