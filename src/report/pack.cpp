#include "report/pack.h"

#include <bit>
#include <nlohmann/json.hpp>
#include <string_view>

#include "store/sha256.h"

namespace tread {
namespace {

std::string base64(const std::string& bytes) {
    static constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t taken = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            bits = bits << 8 | (k < taken ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        }
        for (std::size_t k = 0; k < 4; ++k) out += k <= taken ? kDigits[bits >> (18 - 6 * k) & 63] : '=';
    }
    return out;
}

template <class Bits, class Number>
std::string pack(std::span<const Number> values) {
    std::string bytes;
    bytes.reserve(values.size() * sizeof(Bits));
    for (const Number value : values) {
        const Bits bits = std::bit_cast<Bits>(value);
        for (std::size_t i = 0; i < sizeof(Bits); ++i) bytes += static_cast<char>(bits >> (8 * i) & 0xFF);
    }
    return base64(bytes);
}

}  // namespace

std::string packed(std::span<const double> values) {
    return pack<std::uint64_t>(values);
}
std::string packed(std::span<const float> values) {
    return pack<std::uint32_t>(values);
}
std::string packed(std::span<const std::uint16_t> values) {
    return pack<std::uint16_t>(values);
}

std::string sha256Base64(std::string_view text) {
    const std::string hex = sha256(text);
    std::string bytes;
    for (std::size_t i = 0; i < hex.size(); i += 2)
        bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
    return base64(bytes);
}

std::string scriptJson(const nlohmann::ordered_json& json) {
    const std::string text = json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    std::string safe;
    safe.reserve(text.size());
    for (const char c : text) {
        if (c == '<') {
            safe += "\\u003c";
        } else {
            safe += c;
        }
    }
    return safe;
}

}  // namespace tread
