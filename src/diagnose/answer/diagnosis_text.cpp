#include "diagnose/answer/diagnosis_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "diagnose/answer/words.h"
#include "diagnose/settings.h"

namespace tread::diagnose::answer {
namespace {

constexpr double kWorthNaming = 0.05;  // share of the gap, or probability of an effect
constexpr double kMostly = 0.5;        // share of side forces in the missing force from which the axle is named
constexpr std::size_t kMostShares = 3, kMostEffects = 5;  // entries printed

// "yaw rate 62 %, lateral acceleration 30 %"
std::string largest(const Shares& shares, bool channels = false) {
    std::vector<std::pair<double, std::string>> sorted;
    for (const auto& [name, share] : shares) sorted.push_back({-share, name});
    std::sort(sorted.begin(), sorted.end());
    std::string list;
    for (std::size_t i = 0; i < sorted.size() && i < kMostShares; ++i) {
        if (-sorted[i].first < kWorthNaming) break;
        list += fmt::format("{}{} {:.0f} %", i > 0 ? ", " : "",
                            channels ? channelInWords(sorted[i].second) : sorted[i].second, -100 * sorted[i].first);
    }
    return list.empty() ? "none" : list;
}

// "; front axle side force 80 %" when side forces make up most of the missing force; otherwise empty.
std::string axleOf(const WhereItLies& where) {
    const auto share = [](const Shares& shares, std::string_view name) {
        const auto found = shares.find(std::string(name));
        return found == shares.end() ? 0.0 : found->second;
    };
    const double side = share(where.generalised_force, "lateral") + share(where.generalised_force, "yaw");
    if (side < kMostly) return {};
    const double front = share(where.axle_force, "front");
    return fmt::format("; {} axle side force {:.0f} %", front >= 0.5 ? "front" : "rear",
                       100 * std::max(front, 1 - front));
}

std::string parametersOf(const RankedEffect& effect) {
    std::string list;
    for (const auto& [path, e] : effect.parameters)
        list += fmt::format("{}{} {:.4g} +- {:.2g} (nominal {:.4g})", list.empty() ? "" : ", ", path, e.value, e.sd,
                            e.neutral);
    return list;
}

std::string whichOf(const Diagnosis& d) {
    std::string text;
    std::size_t rank = 0;
    for (const RankedEffect& effect : d.effects) {
        const bool named = std::find(d.causes.begin(), d.causes.end(), effect.name) != d.causes.end();
        if (!named && (rank >= kMostEffects || effect.probability < kWorthNaming)) continue;
        text += fmt::format("{}{}. {:<28} {}   {}\n", rank == 0 ? "WHICH     " : "          ", rank + 1, effect.name,
                            probabilityInWords(effect.probability), parametersOf(effect));
        ++rank;
    }
    if (!text.empty()) return text;
    const std::string law = lawInWords(d.unexplained.law);
    return fmt::format("WHICH     no effect of the catalogue{}{}\n", law.empty() ? "" : "; ", law);
}

std::string howFarOf(const Diagnosis& d) {
    const GapLevels& level = d.how_far.in_sample ? d.how_far.training : d.how_far.held_out;
    std::string text = fmt::format("HOW FAR   gap {:.2f} -> {:.2f} (tolerances alone {:.2f}, noise floor {:.2f})",
                                   level.nominal, level.extended, level.calibrated, level.floor);
    text += d.how_far.in_sample ? "; in-sample because no recording is held out:" : "; in held-out drives:";
    text += fmt::format(" {:.0f} % of the gap closed [{:.0f}, {:.0f}]\n", 100 * d.how_far.closure,
                        100 * d.how_far.closure_low, 100 * d.how_far.closure_high);
    return text;
}

std::string hiddenOf(const Diagnosis& d) {
    std::string list;
    for (const auto& [name, nats] : d.expected_evidence)
        if (nats < kTestable) list += (list.empty() ? "" : ", ") + name;
    return list.empty() ? "" : "NOT SEEN  excited too weakly in these drives: " + list + "\n";
}

}  // namespace

std::string diagnosisText(const Diagnosis& d) {
    std::string text = d.answer + "\n";
    if (d.compared) text += "COMPARED  with the same drives before the car was changed\n";
    text += "WHERE     ";
    text += d.where.channels.empty() ? "no single channel exceeds the usual disturbances"
                                     : fmt::format("{} of the gap; {}; {}", largest(d.where.channels, true),
                                                   largest(d.where.phases), largest(d.where.bands));
    text += fmt::format("; force: {}{}\n", largest(d.where.generalised_force), axleOf(d.where));
    text += whichOf(d) + howFarOf(d);
    for (std::size_t i = 0; i < d.next.size(); ++i) {
        text += fmt::format("{}{} would separate {} by {:.0f} nats\n", i == 0 ? "NEXT      " : "          ",
                            d.next[i].scenario, separatesInWords(d.next[i]), d.next[i].nats);
    }
    return text + hiddenOf(d);
}

}  // namespace tread::diagnose::answer
