#include "base/text/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace tread {
namespace {

// Between these, plain digits are easier to read than an exponent.
constexpr double kSmallestPlain = 1e-5;
constexpr double kLargestPlain = 1e15;

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

// A number may end at the end of the text, before a space, or before a unit.
bool mayFollowNumber(std::string_view rest) {
    if (rest.empty()) return true;
    const char c = rest.front();
    if ((c == 'x' || c == 'X') && rest.size() > 1) return false;
    return c == ' ' || c == '%' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           static_cast<unsigned char>(c) >= 0x80;
}

std::string endText(double value, bool open, std::string_view closed_word, std::string_view open_word) {
    return std::string(open ? open_word : closed_word) + " " + numberText(value);
}

}  // namespace

std::string numberText(double value) {
    char buffer[64];
    const double size = std::abs(value);
    const bool plain = size == 0 || (size >= kSmallestPlain && size < kLargestPlain);
    const auto format = plain ? std::chars_format::fixed : std::chars_format::scientific;
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, format).ptr;
    std::string text(buffer, end);
    // Some YAML readers take "1e+20" for a word, but none "1.0e+20".
    if (!plain && text.find('.') == std::string::npos && text.find('e') != std::string::npos) {
        text.insert(text.find('e'), ".0");
    }
    return text;
}

void appendNumber(std::string& out, double value) {
    if (std::isnan(value)) {
        out += "nan";
        return;
    }
    char digits[32];  // the longest double has 24 characters
    out.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

std::optional<double> takeNumber(std::string_view& text) {
    std::string_view digits = text;
    if (digits.starts_with('+')) digits.remove_prefix(1);
    const std::string_view unsigned_digits =
        digits.substr(digits.starts_with('-') && digits.data() == text.data() ? 1 : 0);
    const bool begins_well =
        !unsigned_digits.empty() && (isDigit(unsigned_digits.front()) || unsigned_digits.front() == '.');
    if (!begins_well) return {};

    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc{} || !std::isfinite(value)) return {};
    digits.remove_prefix(static_cast<std::size_t>(end - digits.data()));
    if (!mayFollowNumber(digits)) return {};
    text = digits;
    return value;
}

std::string limitsText(const Limits& limits) {
    const bool below = limits.lowest > -kInfinity;
    const bool above = limits.highest < kInfinity;
    if (below && above && !limits.lowest_open && !limits.highest_open) {
        return "from " + numberText(limits.lowest) + " to " + numberText(limits.highest);
    }
    std::string text;
    if (below) text = endText(limits.lowest, limits.lowest_open, "at least", "above");
    if (below && above) text += " and ";
    if (above) text += endText(limits.highest, limits.highest_open, "at most", "below");
    return text;
}

std::string counted(std::size_t number, std::string_view what) {
    return std::to_string(number) + " " + std::string(what) + (number == 1 ? "" : "s");
}

std::string quote(std::string_view text, std::size_t longest) {
    std::string out = "\"";
    std::size_t length = std::min(text.size(), longest);
    while (length < text.size() && length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80) --length;
    for (const char c : text.substr(0, length)) {
        out += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? '?' : c;
    }
    return out + (length < text.size() ? "...\"" : "\"");
}

}  // namespace tread
