#include "base/text/text_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>
#include <utility>

#include "base/text/byte_limit.h"

namespace tread {
namespace {

constexpr std::size_t kNowhere = std::string_view::npos;

bool continues(char c) {
    return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

// Length of the UTF-8 sequence at the beginning of `text`; 0 when there is none (RFC 3629, section 4).
std::size_t sequenceLength(std::string_view text) {
    const auto first = static_cast<unsigned char>(text.front());
    if (first < 0x80) return 1;
    const std::size_t length = first >= 0xF5 ? 0 : first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : first >= 0xC2 ? 2 : 0;
    if (length == 0 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i) {
        if (!continues(text[i])) return 0;
    }
    const auto second = static_cast<unsigned char>(text[1]);
    const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
    const bool surrogate = first == 0xED && second >= 0xA0;
    const bool beyond = first == 0xF4 && second >= 0x90;
    return overlong || surrogate || beyond ? 0 : length;
}

// The first tab that stands before the first word of a line.
std::size_t findTabInIndentation(std::string_view text) {
    for (std::size_t line = 0; line < text.size();) {
        const std::size_t end = std::min(text.find('\n', line), text.size());
        const std::size_t word = std::min(text.find_first_not_of(" \t\r", line), end);
        const std::size_t tab = text.substr(line, word - line).find('\t');
        const bool has_content = word < end && text[word] != '#';
        if (has_content && tab != kNowhere) return line + tab;
        line = end + 1;
    }
    return kNowhere;
}

constexpr const char* kNotRegular =
    "is a pipe, a socket or a device, expected a regular file; write its content into a file first";

bool isNotRegular(const std::filesystem::file_status& status) {
    return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
           !std::filesystem::is_directory(status);
}

// At most one byte more than `most`; false, with the reason, where the file ends in a fault.
bool readUpTo(std::FILE* file, std::size_t most, std::string& text, std::string& fault) {
    constexpr std::size_t kReadBytes = 1 << 16;  // at first; then as many as there are
    for (std::size_t size = 1; text.size() != size && text.size() <= most;) {
        size = text.size();
        text.resize(std::min(size + std::max(size, kReadBytes), most) + 1);
        const std::size_t wanted = text.size() - size;
        text.resize(size + std::fread(text.data() + size, 1, wanted, file));
        if (std::ferror(file) != 0) {
            fault = std::generic_category().message(errno);
            return false;
        }
    }
    return true;
}

// False, with the reason, where the file ends in a fault or beyond the most bytes.
bool readAll(std::FILE* file, std::string& text, std::string& fault) {
    const std::size_t most = byteLimit("TREAD_LARGEST_FILE", std::size_t{1} << 30);
    if (!readUpTo(file, most, text, fault)) return false;
    if (text.size() <= most) return true;
    fault = "it holds more than " + std::to_string(most) +
            " bytes; set the variable TREAD_LARGEST_FILE to a larger number of bytes to read it";
    return false;
}

struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

File opened(const std::filesystem::path& path) {
    File file(std::fopen(path.c_str(), "rb"));
    while (!file && errno == EINTR) file.reset(std::fopen(path.c_str(), "rb"));
    return file;
}

}  // namespace

std::optional<std::string> readWholeFile(const std::filesystem::path& path, std::string& fault) {
    std::string text;
    if (path == "-") return readAll(stdin, text, fault) ? std::optional(std::move(text)) : std::nullopt;
    std::error_code error;
    if (isNotRegular(std::filesystem::status(path, error))) {
        fault = kNotRegular;
        return {};
    }
    const File file = opened(path);
    if (!file) {
        fault = std::generic_category().message(errno);
        return {};
    }
    return readAll(file.get(), text, fault) ? std::optional(std::move(text)) : std::nullopt;
}

std::optional<std::string> readTextFile(const std::filesystem::path& file, std::string& fault) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) {
        fault = "found no file of this name; correct the path";
        return {};
    }
    if (std::filesystem::is_directory(status)) {
        fault = "found a directory, expected a file; name a file in it";
        return {};
    }
    if (isNotRegular(status)) {
        fault = kNotRegular;
        return {};
    }
    const File stream = opened(file);
    std::string text;
    if (!stream || !readUpTo(stream.get(), kLargestFile, text, fault)) {
        fault = "found a file that cannot be read; check its permissions";
        return {};
    }
    return text;
}

std::size_t findInvalidUtf8(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = sequenceLength(text.substr(i));
        if (length == 0) return i;
        i += length;
    }
    return kNowhere;
}

bool isUtf8(std::string_view text) {
    return findInvalidUtf8(text) == kNowhere;
}

bool isPlainText(std::string_view text, const std::string& file, std::vector<Problem>& problems) {
    const auto refuse = [&](std::size_t byte, std::string fault) {
        const TextPosition position = positionOf(text, byte);
        problems.push_back({file, position.line, position.column, "", std::move(fault)});
        return false;
    };
    if (text.size() > kLargestFile) {
        problems.push_back(
            {file, 0, 0, "", "found more than 4 MB, expected a description written by hand; check the path"});
        return false;
    }
    const std::size_t nul = text.find('\0');
    if (nul != kNowhere)
        return refuse(nul, "found a NUL byte, expected UTF-8 text; check that this is not a binary file");
    const std::size_t invalid = findInvalidUtf8(text);
    if (invalid != kNowhere) return refuse(invalid, "found a byte that is not UTF-8; save the file as UTF-8 text");
    const std::size_t tab = findTabInIndentation(text);
    if (tab != kNowhere) return refuse(tab, "found a tab in the indentation, expected spaces; replace it by spaces");
    return true;
}

TextPosition positionOf(std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, byte);
    const std::size_t line_end = before.rfind('\n');
    const std::string_view line = line_end == kNowhere ? before : before.substr(line_end + 1);
    const auto lines = std::count(before.begin(), before.end(), '\n');
    const auto characters = std::count_if(line.begin(), line.end(), [](char c) { return !continues(c); });
    return {static_cast<int>(lines) + 1, static_cast<int>(characters) + 1};
}

}  // namespace tread
