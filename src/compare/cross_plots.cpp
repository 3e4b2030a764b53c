#include "compare/cross_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace tread {
namespace {

constexpr std::size_t kRepeats = 3;  // measurements that the standard asks for

std::string pair(const CrossPlot& plot) {
    return plot.channel + " over " + plot.against;
}

const CrossPlotJudgement* worst(const CrossPlotResult& result) {
    const auto found = std::max_element(result.plots.begin(), result.plots.end(), [](const auto& a, const auto& b) {
        if (a.envelope.inside != b.envelope.inside) return a.envelope.inside;
        return a.envelope.worst < b.envelope.worst;
    });
    return found == result.plots.end() ? nullptr : &*found;
}

std::string answer(const CrossPlotResult& result) {
    const CrossPlotJudgement* const far = worst(result);
    if (!far) return "Not judged: the logs share none of the cross-plots";
    if (result.inside) {
        return fmt::format(
            "Inside: the measurements lie within the boundaries of {} cross-plots, using at most {:.0f} % of the "
            "tolerance ({})",
            result.plots.size(), 100 * far->envelope.worst, pair(far->plot));
    }
    if (far->envelope.judged == 0) {
        return fmt::format("Outside: no point of {} of {} lies alongside the simulated curve", pair(far->plot),
                           far->measurement);
    }
    return fmt::format(
        "Outside: {} of {} points of {} lie outside the boundaries, the farthest at {:.3g} times the tolerance ({})",
        far->envelope.outside, far->envelope.judged, pair(far->plot), far->envelope.worst, far->measurement);
}

}  // namespace

CrossPlotResult judgeCrossPlots(const Log& simulated, const std::vector<NamedLog>& measured, const CrossPlots& plots) {
    CrossPlotResult result;
    if (measured.size() < kRepeats) {
        result.notes.push_back(fmt::format("ISO 19364 requires at least {} measurements of the manoeuvre; {} {} given.",
                                           kRepeats, measured.size(), measured.size() == 1 ? "is" : "are"));
    }
    for (const CrossPlot& plot : plots.plots) {
        for (const NamedLog& log : measured) {
            try {
                result.plots.push_back(
                    {plot, log.name, judgeEnvelope(simulated, log.log, plot.against, plot.channel, plot.tolerance)});
            } catch (const std::invalid_argument& error) {
                result.notes.push_back(fmt::format("{} of {} was not judged: {}.", pair(plot), log.name, error.what()));
            }
        }
    }
    const CrossPlotJudgement* const far = worst(result);
    result.inside = far && far->envelope.inside;
    return result;
}

std::string text(const CrossPlotResult& result) {
    std::string out = answer(result) + "\n";
    for (const std::string& note : result.notes) out += note + "\n";
    if (result.plots.empty()) return out;
    std::size_t width = 10;
    for (const auto& judged : result.plots) width = std::max(width, pair(judged.plot).size());
    out += fmt::format("\n{:<{}}  {:<8}  {:>10}  {:>8}  {:>8}  {:>11}  {:>9}  measurement\n", "cross-plot", width,
                       "verdict", "worst", "points", "outside", "not covered", "first [s]");
    for (const auto& [plot, measurement, envelope] : result.plots) {
        const std::string first =
            envelope.first_outside_time ? fmt::format("{:.6g}", *envelope.first_outside_time) : "-";
        out += fmt::format("{:<{}}  {:<8}  {:>10.3g}  {:>8}  {:>8}  {:>11}  {:>9}  {}\n", pair(plot), width,
                           envelope.inside ? "inside" : "outside", envelope.worst, envelope.judged, envelope.outside,
                           envelope.not_covered, first, measurement);
    }
    return out;
}

nlohmann::json json(const CrossPlotResult& result) {
    nlohmann::json list = nlohmann::json::array();
    for (const auto& [plot, measurement, envelope] : result.plots) {
        const auto first = envelope.first_outside_time;
        list.push_back({{"channel", plot.channel},
                        {"against", plot.against},
                        {"measurement", measurement},
                        {"inside", envelope.inside},
                        {"worst", envelope.worst},
                        {"judged", envelope.judged},
                        {"outside", envelope.outside},
                        {"not_covered", envelope.not_covered},
                        {"first_outside", first ? nlohmann::json(*first) : nlohmann::json(nullptr)}});
    }
    return {{"inside", result.inside}, {"answer", answer(result)}, {"plots", list}, {"notes", result.notes}};
}

}  // namespace tread
