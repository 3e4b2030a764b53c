#include "diagnose/answer/diagnosis_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "diagnose/answer/changed_numbers.h"
#include "diagnose/answer/parts.h"
#include "diagnose/answer/words.h"
#include "diagnose/settings.h"

namespace tread::diagnose::answer {
namespace {

constexpr double kWorthNaming = 0.05;  // share of the gap, or probability of an effect
constexpr double kLarger = 0.005;      // share of the gap: a part that is less than zero by more makes it larger
constexpr double kMostlySide = 0.5;    // share of side forces in the missing force from which the axle is named
constexpr std::size_t kMostListed = 3, kMostHidden = 8;  // entries of a list that are printed

// Lines below one headline.
std::string listed(const char* headline, const std::vector<std::string>& lines) {
    std::string text;
    for (std::size_t i = 0; i < lines.size(); ++i) text += fmt::format("{:<10}{}\n", i == 0 ? headline : "", lines[i]);
    return text;
}

// "yaw rate 62 %, lateral acceleration 30 %"
std::string largest(const Shares& shares, bool channels = false) {
    std::vector<std::pair<double, std::string>> sorted;
    for (const auto& [name, share] : shares) sorted.push_back({-share, name});
    std::sort(sorted.begin(), sorted.end());
    std::string list;
    for (std::size_t i = 0; i < sorted.size() && i < kMostListed; ++i) {
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
    if (side < kMostlySide) return {};
    const double front = share(where.axle_force, "front");
    return fmt::format("; {} axle side force {:.0f} %", front >= 0.5 ? "front" : "rear",
                       100 * std::max(front, 1 - front));
}

// "tolerances 50 %, tyre relaxation 43 %, unexplained 1 %, noise 6 %"
std::string partsInWords(const Decomposition& gap) {
    std::vector<std::string> parts;
    for (const ToldPart& part : toldParts(gap))
        parts.push_back(fmt::format("{} {}{}", partInWords(part), roundedPercent(part.share),
                                    part.share < -kLarger ? " (makes it larger)" : ""));
    return fmt::format("{}", fmt::join(parts, ", "));
}

std::string gapOf(const Diagnosis& d) {
    const Decomposition& gap = d.training;
    if (!(gap.gap > 0)) return {};
    std::vector<std::string> lines{fmt::format(
        "{} times that of a perfect model{}: {}", shortNumber(gap.gap, 3),
        d.compared ? ", compared with that of the same drives before the car was changed" : "", partsInWords(gap))};
    if (d.held_out.gap > 0)
        lines.push_back(fmt::format("in the held-out drives, {} times: {}", shortNumber(d.held_out.gap, 3),
                                    partsInWords(d.held_out)));
    else lines.emplace_back("no drive is held out: judged in-sample, in the fitted drives, which is too optimistic");
    if (const std::string closed = closedInWords(d.held_out.gap > 0 ? d.held_out : gap); !closed.empty())
        lines.push_back(fmt::format("closed{}: {}", d.held_out.gap > 0 ? " there" : "", closed));
    return listed("GAP", lines);
}

std::string whereOf(const WhereItLies& where) {
    const std::string gap = where.channels.empty() ? "no single channel exceeds the usual disturbances"
                                                   : fmt::format("{} of the gap; {}; {}", largest(where.channels, true),
                                                                 largest(where.phases), largest(where.bands));
    return listed("WHERE", {fmt::format("{}; force: {}{}", gap, largest(where.generalised_force), axleOf(where))});
}

// "front, rear: lateral carcass stiffness 141800 -> 105000 N/m (-26 +- 4 %)"
std::string changeInWords(const ChangedNumber& number) {
    const Estimate& e = number.estimate;
    const std::string unit = unitOf(number.paths.front()), percent = changeInPercent(e, "+-");
    return fmt::format("{} {} -> {}{}{}{}{}", numberInWords(number.paths), shortNumber(e.neutral), shortNumber(e.value),
                       percent.empty() ? " +- " + shortNumber(e.sd, 2) : "", unit == "-" ? "" : " " + unit,
                       percent.empty() ? "" : " (" + percent + ")",
                       atItsEnd(e) ? ", at the end of its plausible range" : "");
}

std::string whichOf(const Diagnosis& d) {
    std::vector<std::string> lines;
    for (const RankedEffect* effect : namedEffects(d)) {
        std::vector<std::string> changes;
        for (const ChangedNumber& number : changedNumbers(*effect)) changes.push_back(changeInWords(number));
        lines.push_back(fmt::format("{} ({}): {}", effect->name, probabilityInWords(effect->probability),
                                    fmt::join(changes, "; ")));
    }
    if (!lines.empty()) return listed("WHICH", lines);
    const std::string none = d.verdict == Verdict::nothing ? fmt::format("none is certain (no effect at all: {})",
                                                                         probabilityInWords(d.probability_of_nothing))
                                                           : "no effect in the catalogue";
    const std::string law = lawInWords(d.unexplained.law);
    return listed("WHICH", {none + (law.empty() ? "" : "; " + law)});
}

// "mass 1362 (+0.8 sd), inertia.yaw 2010 (+1.8 sd), and 3 others"
std::string movedInWords(const std::map<std::string, NuisanceEstimate>& numbers) {
    const std::vector<MovedNumber> moved = movedNumbers(numbers);
    if (moved.empty()) return fmt::format("none of {} numbers by one standard deviation", numbers.size());
    std::string list;
    for (std::size_t i = 0; i < std::min(moved.size(), kMostListed); ++i) {
        const NuisanceEstimate& e = moved[i].estimate;
        list += fmt::format("{}{} {} -> {} ({:+.1f} sd{})", i > 0 ? ", " : "", moved[i].name, shortNumber(e.nominal),
                            shortNumber(e.value), e.z, e.at_bound ? ", at its end" : "");
    }
    if (moved.size() > kMostListed) list += fmt::format(" and {} others", moved.size() - kMostListed);
    return list;
}

std::string movedOf(const Diagnosis& d) {
    if (d.nuisance.empty()) return {};
    std::vector<std::string> lines{"within tolerances: " + movedInWords(d.nuisance)};
    if (d.before.fitted > 0)
        lines.push_back(fmt::format("the car before: gap in the references {:.1f} -> {:.1f} of the floor; {}",
                                    d.before.nominal, d.before.fitted, movedInWords(d.before.moved)));
    return listed("MOVED", lines);
}

std::string remainsOf(const Diagnosis& d) {
    if (!(d.training.gap > 0)) return {};
    std::string text = percentInWords(d.training.remainder.share) + " of the gap";
    const auto large = largeForces(d.unexplained);
    for (std::size_t i = 0; i < std::min(large.size(), kMostListed); ++i)
        text += fmt::format("; {}: {:.1f} times the usual size", kindOfForceInWords(large[i].second), large[i].first);
    if (large.empty()) text += "; no force is larger than in an ordinary drive";
    const std::string law = d.causes.empty() ? "" : lawInWords(d.unexplained.law);
    if (!law.empty()) text += "; " + law;
    if (const std::string vibration = vibrationInWords(d.unexplained.vibration); !vibration.empty())
        text += "; " + vibration;
    return listed("REMAINS", {text});
}

std::string rivalsOf(const Diagnosis& d) {
    std::vector<std::string> lines;
    std::vector<std::string> rivals, others;
    for (const std::string& name : namesOnlyIn(d.alternatives, d.causes)) rivals.push_back(certainly(d, name));
    if (!rivals.empty()) lines.push_back(fmt::format("{}", fmt::join(rivals, ", ")));
    for (const RankedEffect& effect : otherEffects(d, kWorthNaming))
        others.push_back(fmt::format("{} ({})", effect.name, probabilityInWords(effect.probability)));
    if (!others.empty()) lines.push_back(fmt::format("others: {}", fmt::join(others, ", ")));
    for (const ConfusablePair& pair : pairsOfCauses(d))
        lines.push_back(fmt::format("{} and {} are hard to tell apart; mostly {} does", effectInWords(pair.a),
                                    effectInWords(pair.b), pair.manoeuvre));
    lines.resize(std::min(lines.size(), kMostListed));
    return listed("RIVALS", lines);
}

std::string ruledOutOf(const Diagnosis& d) {
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < std::min(d.ruled_out.size(), kMostListed); ++i)
        lines.push_back(fmt::format("{} ({:.0f} nats): {}", together(d.ruled_out[i].effects),
                                    d.ruled_out[i].log_evidence, d.ruled_out[i].reason));
    return listed("RULED OUT", lines);
}

std::string leftOutOf(const Diagnosis& d) {
    std::vector<std::string> lines;
    for (const Cut& cut : d.cuts)
        lines.push_back(
            fmt::format("{} after {:.1f} s: {:.0f} % of its rows", cut.recording, cut.until, 100 * cut.share));
    if (lines.size() > kMostListed) {
        const std::size_t others = lines.size() - kMostListed;
        lines.resize(kMostListed);
        lines.back() += fmt::format(", and parts of {} other drive{}", others, others == 1 ? "" : "s");
    }
    return listed("LEFT OUT", lines);
}

std::string nextOf(const Diagnosis& d) {
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < std::min(d.next.size(), kMostListed); ++i)
        lines.push_back(fmt::format("{} would separate {} by {}", d.next[i].scenario, separatesInWords(d.next[i]),
                                    evidenceInWords(d.next[i])));
    return listed("NEXT", lines);
}

std::string hiddenOf(const Diagnosis& d) {
    std::vector<std::string> hidden = unseenEffects(d);
    if (hidden.empty()) return {};
    const std::size_t all = hidden.size();
    hidden.resize(std::min(all, kMostHidden));
    return listed("NOT SEEN",
                  {fmt::format("{} of {} effects, excited too weakly in these drives: {}{}", all,
                               d.expected_evidence.size(), fmt::join(hidden, ", "), all > kMostHidden ? ", ..." : "")});
}

}  // namespace

std::string diagnosisText(const Diagnosis& d) {
    return d.answer + "\n" + gapOf(d) + whereOf(d.where) + whichOf(d) + movedOf(d) + remainsOf(d) + rivalsOf(d) +
           ruledOutOf(d) + leftOutOf(d) + nextOf(d) + hiddenOf(d);
}

}  // namespace tread::diagnose::answer
