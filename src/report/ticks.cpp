#include "report/ticks.h"

#include <fmt/format.h>

#include <cmath>

namespace tread {
namespace {

constexpr double kRounding =
    1e-9;  // of a step: a tick that misses the end of the range by rounding still belongs to it
constexpr std::size_t kMostTicks = 1000;  // guards against a step that does not fit the range

}  // namespace

double niceStep(double span, int most) {
    if (!(span > 0) || !std::isfinite(span) || most < 1) return 1;
    const double rough = span / most;
    const double decade = std::pow(10, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * decade >= rough * (1 - kRounding)) return factor * decade;
    }
    return 10 * decade;
}

std::vector<double> ticks(AxisRange range, double step) {
    std::vector<double> out;
    const double first = std::ceil(range.lowest / step - kRounding);
    const double last = std::floor(range.highest / step + kRounding);
    for (double i = first; i <= last && out.size() < kMostTicks; ++i) out.push_back(i == 0 ? 0.0 : i * step);
    return out;
}

std::string tickLabel(double value, double step) {
    const double rounded = std::abs(value) < kRounding * step ? 0.0 : value;
    const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + kRounding)));
    if (decimals > 4 || std::abs(value) >= 1e6) return fmt::format("{:.4g}", rounded);
    return fmt::format("{:.{}f}", rounded, decimals);
}

}  // namespace tread
