#include "wrapped.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>

namespace tread::program {
namespace {

constexpr std::size_t kColumns = 100;
constexpr std::size_t kFewest = 60;  // below, the columns of a table leave no room for words

// Bytes that continue a UTF-8 character take no column.
std::size_t columnsOf(std::string_view word) {
    return static_cast<std::size_t>(
        std::count_if(word.begin(), word.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

}  // namespace

std::size_t outputColumns() {
    winsize size{};
    if (isatty(STDOUT_FILENO) == 0 || ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return kColumns;
    return std::max<std::size_t>(size.ws_col, kFewest);
}

std::string wrapped(std::string_view words, std::size_t indent, std::size_t columns) {
    std::string out;
    std::size_t at = indent;
    while (!words.empty()) {
        const std::size_t end = std::min(words.find(' '), words.size());
        const std::string_view word = words.substr(0, end);
        words.remove_prefix(std::min(end + 1, words.size()));
        if (word.empty()) continue;
        const std::size_t width = columnsOf(word);
        if (at > indent && at + 1 + width > columns) {
            out += "\n" + std::string(indent, ' ');
            at = indent;
        } else if (at > indent) {
            out += ' ';
            ++at;
        }
        out += word;
        at += width;
    }
    return out;
}

}  // namespace tread::program
