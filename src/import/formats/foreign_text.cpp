#include "import/formats/foreign_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "base/text/number_text.h"
#include "base/text/text_file.h"

namespace tread {
namespace {

constexpr std::size_t kLongestNumber = 64;

// Latin-1 is the beginning of Unicode; the few signs of Windows-1252 between 0x80 and 0x9F are no units.
std::string fromLatin1(std::string_view text) {
    std::string out;
    out.reserve(text.size() + text.size() / 16);
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (code < 0x80) {
            out += c;
        } else {
            out += static_cast<char>(0xC0 | code >> 6);
            out += static_cast<char>(0x80 | (code & 0x3F));
        }
    }
    return out;
}

bool isBlank(char c) {
    return c == ' ' || c == '\t';
}

std::optional<double> plainNumber(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    if (text.empty() || text.front() == '+') return {};
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size()) return {};
    if (error != std::errc{} || !std::isfinite(value)) return kNoNumber;  // inf, nan, beyond the range of a double
    return value;
}

// "10:53:17.85" or "53:17.85" in seconds.
std::optional<double> clockTime(std::string_view text) {
    double seconds = 0;
    int parts = 0;
    for (; parts < 3; ++parts) {
        const std::size_t colon = text.find(':');
        const auto part = plainNumber(text.substr(0, colon));
        if (!part || !(*part >= 0)) return {};
        seconds = 60 * seconds + *part;
        if (colon == std::string_view::npos) return parts > 0 ? std::optional(seconds) : std::nullopt;
        text.remove_prefix(colon + 1);
    }
    return {};
}

}  // namespace

std::string foreignText(std::string text, const std::string& file, std::vector<std::string>& notes) {
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
        throw LoadError({{file, 0, 0, "", "is text in UTF-16, expected UTF-8 or Latin-1; save it in one of these"}});
    }
    if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
    if (text.find('\0') != std::string::npos) {
        throw LoadError({{file, 0, 0, "", "is not a text file, expected a log as .vbo, .mat or text table"}});
    }
    if (isUtf8(text)) return text;
    notes.push_back("the text is not UTF-8; it was read as Latin-1");
    return fromLatin1(text);
}

std::vector<TextLine> linesOf(std::string_view text) {
    std::vector<TextLine> lines;
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        lines.push_back({text.substr(0, end), number});
        const bool two = end + 1 < text.size() && text[end] == '\r' && text[end + 1] == '\n';
        text.remove_prefix(std::min(end + (two ? 2 : 1), text.size()));
    }
    return lines;
}

std::string_view trimmedText(std::string_view text) {
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    return text;
}

std::vector<TextCell> cellsOf(std::string_view line, char delimiter) {
    std::vector<TextCell> cells;
    std::size_t at = 0;
    while (true) {
        while (at < line.size() && isBlank(line[at]) && line[at] != (delimiter == '\t' ? '\t' : '\0')) ++at;
        if (delimiter == ' ' && at == line.size()) return cells;
        const auto column = static_cast<int>(at) + 1;
        const std::size_t closing =
            at < line.size() && line[at] == '"' ? line.find('"', at + 1) : std::string_view::npos;
        std::string_view text;
        if (closing != std::string_view::npos) {
            text = line.substr(at + 1, closing - at - 1);
            at = closing + 1;
        }
        const std::size_t end =
            std::min(delimiter == ' ' ? line.find_first_of(" \t", at) : line.find(delimiter, at), line.size());
        if (closing == std::string_view::npos) text = line.substr(at, end - at);
        cells.push_back({trimmedText(text), column});
        if (end == line.size()) return cells;
        at = end + 1;
    }
}

std::optional<double> cellNumber(std::string_view cell, bool decimal_comma) {
    if (cell.empty() || cell.size() > kLongestNumber) return {};
    std::string with_point(cell);
    const std::size_t comma = cell.find(',');
    if (decimal_comma && comma != std::string_view::npos) with_point[comma] = '.';
    return cell.find(':') == std::string_view::npos ? plainNumber(with_point) : clockTime(with_point);
}

std::string quotedCell(std::string_view cell) {
    return quote(cell, 40);
}

}  // namespace tread
