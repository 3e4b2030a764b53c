#include "report/chart_data.h"

#include <bit>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "report/decimate.h"
#include "report/text.h"

namespace tread {
namespace {

constexpr std::size_t kMostRows = 4000;  // about four times the pixels of a chart: one can zoom in before it shows

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

template <class Bits>
void append(std::string& bytes, Bits bits) {
    for (std::size_t i = 0; i < sizeof(Bits); ++i) bytes += static_cast<char>(bits >> (8 * i) & 0xFF);
}

std::string packTime(std::span<const double> time, const std::vector<std::size_t>& rows) {
    std::string bytes;
    for (const std::size_t row : rows) append(bytes, std::bit_cast<std::uint64_t>(time[row]));
    return base64(bytes);
}

std::string packCurve(const TimeChart::Curve& curve, const std::vector<std::size_t>& rows) {
    std::string bytes;
    for (const std::size_t row : rows) {
        append(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(curve.values[row] * curve.scale)));
    }
    return base64(bytes);
}

}  // namespace

std::string chartData(const TimeChart& chart) {
    std::vector<std::span<const double>> curves;
    for (const auto& curve : chart.curves)
        curves.push_back(curve.values.first(std::min(curve.values.size(), chart.time.size())));
    const std::vector<std::size_t> rows = keepExtremes(curves, kMostRows);

    nlohmann::ordered_json json;
    json["title"] = chart.title;
    json["unit"] = prettyUnit(chart.unit);
    json["time"] = packTime(chart.time, rows);
    json["curves"] = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < chart.curves.size(); ++i) {
        const auto& curve = chart.curves[i];
        const bool automatic = curve.colour == Colour::automatic;
        const CurveLook look = automatic ? automaticLook(i) : CurveLook{curve.colour, false};
        json["curves"].push_back({{"name", curve.name},
                                  {"colour", hex(look.colour)},
                                  {"dashed", look.dashed || curve.dashed},
                                  {"width", curve.width},
                                  {"values", packCurve(curve, rows)}});
    }
    if (chart.band > 0) json["band"] = chart.band;
    json["marks"] = chart.marks;

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
