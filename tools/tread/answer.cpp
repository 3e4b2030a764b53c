#include "answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace tread::program {
namespace {

constexpr std::size_t kPhrases = 3;  // longest list in an answer; further entries are not listed

// Rounded, without trailing zeros and without the sign of a negative zero.
std::string shortNumber(double value, int decimals) {
    std::string text = fmt::format("{:.{}f}", value, decimals);
    if (decimals > 0) {
        while (text.back() == '0') text.pop_back();
        if (text.back() == '.') text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

std::string inWords(std::vector<Metric> metrics) {
    std::erase_if(metrics, [](const Metric& metric) { return metric.say.rank == 0 || !std::isfinite(metric.value); });
    std::sort(metrics.begin(), metrics.end(), [](const Metric& a, const Metric& b) { return a.say.rank < b.say.rank; });
    metrics.resize(std::min(metrics.size(), kPhrases));
    std::string words;
    for (const Metric& metric : metrics) {
        const std::string number = shortNumber(metric.say.scale * metric.value, metric.say.decimals);
        words += (words.empty() ? "" : ", ") + fmt::format(fmt::runtime(metric.say.text), number);
    }
    return words;
}

}  // namespace

std::string runAnswer(const RunRecord& record, const Log& log, const std::vector<Metric>& metrics) {
    const std::string title = record.scenario.title.empty() ? "A scenario without title" : record.scenario.title;
    const std::string car = record.vehicle.name.empty() ? "car without name" : record.vehicle.name;
    std::string words = inWords(metrics);
    if (words.empty()) words = fmt::format("drove {} s", shortNumber(log.channels.front().values.back(), 2));
    return fmt::format("{}, {}: {}", title, car, words);
}

std::string withVerdict(const std::string& answer, const std::vector<Verdict>& verdicts) {
    return verdicts.empty() ? answer : answer + "; " + tread::answer(verdicts);
}

}  // namespace tread::program
