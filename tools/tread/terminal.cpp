#include "terminal.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

namespace tread::program {
namespace {

bool quiet = false;

bool isSet(const char* variable) {
    const char* const value = std::getenv(variable);
    return value && *value != '\0';
}

bool showsColours(std::FILE* stream) {
    const char* const terminal = std::getenv("TERM");
    const bool dumb = !terminal || std::string_view(terminal) == "dumb";
    return isatty(fileno(stream)) != 0 && !dumb && !isSet("NO_COLOR");
}

const char* codeOf(Tone tone) {
    switch (tone) {
        case Tone::good:
            return "\033[1;32m";
        case Tone::bad:
            return "\033[1;31m";
        case Tone::plain:
            break;
    }
    return "\033[1m";
}

constexpr std::size_t kUsualWidth = 100;
constexpr std::size_t kNarrowest = 40;

// Bytes that continue a UTF-8 character take no column.
std::size_t columnsOf(std::string_view word) {
    return static_cast<std::size_t>(
        std::count_if(word.begin(), word.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

}  // namespace

void beQuiet() {
    quiet = true;
}

bool isQuiet() {
    return quiet;
}

std::string coloured(std::string_view text, Tone tone, std::FILE* stream) {
    if (!showsColours(stream)) return std::string(text);
    const std::size_t end = std::min(text.find('\n'), text.size());
    return fmt::format("{}{}\033[0m{}", codeOf(tone), text.substr(0, end), text.substr(end));
}

std::size_t lineWidth() {
    winsize window{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) == 0 && window.ws_col > 0)
        return std::max<std::size_t>(window.ws_col, kNarrowest);
    const char* const columns = std::getenv("COLUMNS");
    const long given = columns ? std::strtol(columns, nullptr, 10) : 0;
    return given > 0 ? std::max(static_cast<std::size_t>(given), kNarrowest) : kUsualWidth;
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

void warn(std::string_view text) {
    static std::set<std::string, std::less<>> said;
    if (quiet || !said.emplace(text).second) return;
    const char* const yellow = showsColours(stderr) ? "\033[1;33m" : "";
    fmt::print(stderr, "{}warning:{} {}\n", yellow, *yellow ? "\033[0m" : "", text);
}

void note(std::string_view text) {
    if (!quiet) fmt::print(stderr, "{}\n", text);
}

Progress::~Progress() {
    if (shown_) std::fputs("\r\033[K", stderr);
}

void Progress::at(double done) {
    at(done, total_);
}

void Progress::at(double done, double total) {
    const auto now = Clock::now();
    if (quiet || now < next_ || isatty(STDERR_FILENO) == 0) return;
    next_ = now + std::chrono::milliseconds(100);
    shown_ = true;
    const double elapsed = std::chrono::duration<double>(now - begun_).count();
    fmt::print(stderr, "\r{}\033[K", progressLine(done, total, unit_, elapsed));
}

std::string progressLine(double done, double total, const char* unit, double elapsed) {
    constexpr int kWidth = 40;
    const double share = total > 0 ? std::clamp(done / total, 0.0, 1.0) : 0;
    std::string bar(kWidth, ' ');
    std::fill_n(bar.begin(), static_cast<int>(kWidth * share), '#');
    std::string line = fmt::format("[{}] {:3.0f} %", bar, std::floor(100 * share));
    if (share > 0) {
        const auto left = static_cast<long>(std::ceil(elapsed * (1 - share) / share));
        line += fmt::format(", {}:{:02} left", left / 60, left % 60);
    }
    const bool is_share = std::string_view(unit) == "%";
    return is_share ? line : line + fmt::format(" ({:.4g} of {:.4g} {})", done, total, unit);
}

}  // namespace tread::program
