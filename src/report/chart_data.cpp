#include "report/chart_data.h"

#include <nlohmann/json.hpp>

#include "report/decimate.h"
#include "report/pack.h"
#include "report/text.h"

namespace tread {
namespace {

constexpr std::size_t kMostRows = 4000;  // about four times the pixels of a chart: one can zoom in before it shows

std::string packTime(std::span<const double> time, const std::vector<std::size_t>& rows) {
    std::vector<double> kept;
    for (const std::size_t row : rows) kept.push_back(time[row]);
    return packed(kept);
}

std::string packValues(std::span<const double> values, double scale, const std::vector<std::size_t>& rows) {
    std::vector<float> kept;
    for (const std::size_t row : rows) kept.push_back(static_cast<float>(values[row] * scale));
    return packed(kept);
}

}  // namespace

std::string chartData(const TimeChart& chart) {
    std::vector<std::span<const double>> curves;
    for (const auto& curve : chart.curves)
        curves.push_back(curve.values.first(std::min(curve.values.size(), chart.time.size())));
    if (chart.envelope) curves.insert(curves.end(), {chart.envelope->low, chart.envelope->high});
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
                                  {"values", packValues(curve.values, curve.scale, rows)}});
    }
    if (const auto& envelope = chart.envelope) {
        json["envelope"] = {{"name", envelope->name},
                            {"colour", hex(envelope->colour)},
                            {"low", packValues(envelope->low, envelope->scale, rows)},
                            {"high", packValues(envelope->high, envelope->scale, rows)}};
    }
    if (chart.band > 0) json["band"] = chart.band;
    json["marks"] = chart.marks;
    return scriptJson(json);
}

}  // namespace tread
