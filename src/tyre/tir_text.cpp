#include "tyre/tir_text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <utility>

#include "base/text/trimmed.h"

namespace tread {
namespace {

constexpr std::string_view kBlank = " \t\r\f\v";
constexpr std::string_view kComment = "$!";

std::string_view withoutComment(std::string_view text) {
    return trimmed(text.substr(0, text.find_first_of(kComment)));
}

// Rows of tables carry no key: column names in braces, subtables in parentheses, quoted remarks, or numbers.
bool isTableRow(std::string_view line) {
    const char first = line.front();
    return first == '{' || first == '(' || first == '\'' || first == '"' || first == '+' || first == '-' ||
           first == '.' || std::isdigit(static_cast<unsigned char>(first));
}

// Reads line after line; keeps the section it is in.
class LineReader {
public:
    LineReader(TirText& text, std::vector<Problem>& problems) : text_(text), problems_(problems) {}

    void read(std::string_view line) {
        ++line_;
        if (line_ == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);  // byte order mark
        const std::size_t start = line.find_first_not_of(kBlank);
        if (start == std::string_view::npos || kComment.find(line[start]) != std::string_view::npos) return;
        const std::size_t equals = line.find('=');
        if (line[start] == '[') {
            readSection(line, start);
        } else if (isTableRow(line.substr(start))) {
            return;
        } else if (equals == std::string_view::npos || equals > line.find_first_of(kComment)) {
            complain(start, "", "expected KEY = value, [SECTION], a row of a table or a comment");
        } else {
            readEntry(line, start, equals);
        }
    }

private:
    void complain(std::size_t position, std::string path, std::string text) {
        problems_.push_back({text_.file, line_, static_cast<int>(position) + 1, std::move(path), std::move(text)});
    }

    void readSection(std::string_view line, std::size_t start) {
        const std::size_t end = line.find(']', start);
        if (end == std::string_view::npos || !withoutComment(line.substr(end + 1)).empty()) {
            complain(start, "", "expected [SECTION] and nothing else");
            return;
        }
        section_ = upperCase(trimmed(line.substr(start + 1, end - start - 1)));
        text_.sections.push_back(section_);
    }

    void readEntry(std::string_view line, std::size_t start, std::size_t equals) {
        TirEntry entry{section_, upperCase(trimmed(line.substr(start, equals - start))), "", false, line_, 0};
        std::size_t at = line.find_first_not_of(kBlank, equals + 1);
        if (at == std::string_view::npos) at = equals + 1;
        entry.column = static_cast<int>(at) + 1;
        if (at < line.size() && (line[at] == '\'' || line[at] == '"')) {
            const std::size_t end = line.find(line[at], at + 1);
            if (end == std::string_view::npos) return complain(at, entry.key, "the quote is not closed");
            if (!withoutComment(line.substr(end + 1)).empty()) {
                return complain(end + 1, entry.key, "expected the end of the line or a comment after the quoted text");
            }
            entry.quoted = true;
            entry.value = line.substr(at + 1, end - at - 1);
        } else {
            entry.value = withoutComment(line.substr(at));
        }
        const auto [earlier, is_first] = lines_.try_emplace({entry.section, entry.key}, line_);
        if (!is_first)
            return complain(start, entry.key, "is given twice, first in line " + std::to_string(earlier->second));
        text_.entries.push_back(std::move(entry));
    }

    TirText& text_;
    std::vector<Problem>& problems_;
    std::map<std::pair<std::string, std::string>, int> lines_;  // of a key in a section
    std::string section_;
    int line_ = 0;
};

}  // namespace

std::string upperCase(std::string_view text) {
    std::string out(text);
    for (char& c : out) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return out;
}

bool TirText::hasSection(std::string_view name) const {
    return std::find(sections.begin(), sections.end(), name) != sections.end();
}

std::vector<const TirEntry*> TirText::find(std::string_view key, bool units) const {
    std::vector<const TirEntry*> found;
    for (const TirEntry& entry : entries) {
        if (entry.key == key && (entry.section == "UNITS") == units) found.push_back(&entry);
    }
    return found;
}

std::optional<double> numberIn(const TirEntry& entry) {
    std::string_view text = entry.value;
    if (entry.quoted) return std::nullopt;
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    double value = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

TirText parseTirText(std::string_view content, const std::string& file, std::vector<Problem>& problems) {
    TirText text;
    text.file = file;
    LineReader reader(text, problems);
    while (!content.empty()) {
        const std::size_t end = std::min(content.find('\n'), content.size());
        reader.read(content.substr(0, end));
        content.remove_prefix(std::min(end + 1, content.size()));
    }
    return text;
}

}  // namespace tread
