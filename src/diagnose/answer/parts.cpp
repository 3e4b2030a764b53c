#include "diagnose/answer/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnose/answer/words.h"

namespace tread::diagnose::answer {
namespace {

constexpr double kWorthTelling = 0.005;  // share of the gap: less is written as 0 %

ToldPart partOf(PartKind kind, const Part& part) {
    return {.kind = kind, .share = part.share, .interval = part};
}

double sumOf(const std::vector<CausePart>& causes, Part CausePart::*part) {
    double sum = 0;
    for (const CausePart& cause : causes) sum += (cause.*part).share;
    return sum;
}

// The causes, and what several of them explain. Where causes overlap, each explains less after the others than alone;
// the difference is shared. Where they need each other it is the other way round.
std::vector<ToldPart> partsOfCauses(const Decomposition& gap) {
    const std::vector<CausePart> causes = inOrder(gap);
    std::vector<ToldPart> parts;
    if (causes.empty()) return parts;
    const double shared = gap.causes.share - sumOf(causes, &CausePart::last);
    const double together = gap.causes.share - sumOf(causes, &CausePart::first);
    const bool overlap = shared >= 0 || together < 0;
    std::vector<std::string> names;
    for (const CausePart& cause : causes) {
        parts.push_back(partOf(PartKind::cause, overlap ? cause.last : cause.first));
        parts.back().causes = {cause.name};
        names.push_back(cause.name);
    }
    if (causes.size() > 1)
        parts.push_back({.kind = overlap ? PartKind::shared : PartKind::together,
                         .causes = names,
                         .share = overlap ? shared : together});
    return parts;
}

void normalise(Shares& shares) {
    double sum = 0;
    for (const auto& [name, share] : shares) sum += share;
    for (auto& [name, share] : shares) share = sum > 0 ? share / sum : 0;
}

}  // namespace

std::vector<CausePart> inOrder(const Decomposition& gap) {
    std::vector<CausePart> causes = gap.each;
    std::stable_sort(causes.begin(), causes.end(),
                     [](const CausePart& a, const CausePart& b) { return a.first.share > b.first.share; });
    return causes;
}

std::vector<ToldPart> toldParts(const Decomposition& gap) {
    std::vector<ToldPart> parts{partOf(PartKind::tolerances, gap.tolerances)};
    const std::vector<ToldPart> causes = partsOfCauses(gap);
    parts.insert(parts.end(), causes.begin(), causes.end());
    parts.push_back(partOf(PartKind::remainder, gap.remainder));
    parts.push_back(partOf(PartKind::noise, gap.noise));
    double length = 0;
    for (const ToldPart& part : parts) length += std::max(0.0, part.share);
    for (ToldPart& part : parts) part.drawn = length > 0 ? std::max(0.0, part.share) / length : 0;
    return parts;
}

std::string partInWords(const ToldPart& part) {
    switch (part.kind) {
        case PartKind::tolerances:
            return "tolerances";
        case PartKind::cause:
            return effectInWords(part.causes.front());
        case PartKind::shared:
            return "shared by " + together(part.causes);
        case PartKind::together:
            return together(part.causes) + " only together";
        case PartKind::remainder:
            return "unexplained";
        case PartKind::noise:
            return "noise";
    }
    return {};
}

double shareOfTheRest(const Decomposition& gap, double share) {
    const double rest = gap.causes.share + gap.remainder.share;
    return rest > 0 ? share / rest : 0;
}

double closedShare(const Decomposition& gap) {
    const double most = 1 - gap.noise.share;
    return most > 0 ? 1 - gap.remainder.share / most : std::numeric_limits<double>::quiet_NaN();
}

double closedShare(const GapLevels& levels, double after) {
    const double most = levels.nominal * levels.nominal - levels.floor * levels.floor;
    if (!(most > 0)) return std::numeric_limits<double>::quiet_NaN();
    return (levels.nominal * levels.nominal - after * after) / most;
}

std::string closedInWords(const Decomposition& gap) {
    const double closed = closedShare(gap);
    if (!(gap.gap > 0) || std::isnan(closed)) return {};
    return fmt::format("1 - unexplained {:.1f} / (100 - noise {:.1f}) = {}", 100 * gap.remainder.share,
                       100 * gap.noise.share, roundedPercent(closed));
}

std::vector<std::string> enlargingInWords(const Decomposition& gap) {
    std::vector<std::string> sentences;
    for (const ToldPart& part : toldParts(gap)) {
        if (part.share > -kWorthTelling) continue;
        sentences.push_back(fmt::format(
            "{} increases the gap by {:.0f} % of that of the nominal car.",
            part.kind == PartKind::tolerances ? "Fitting the tolerances alone" : capitalised(partInWords(part)),
            -100 * part.share));
    }
    return sentences;
}

Shares remainderOfChannels(const Diagnosis& diagnosis) {
    Shares shares;
    for (const Overlay& overlay : diagnosis.overlays)
        for (const auto& [channel, squares] : overlay.remainder)
            if (!overlay.hold_out) shares[channel] += squares;
    normalise(shares);
    return shares;
}

Shares remainderOfRecordings(const Diagnosis& diagnosis) {
    Shares shares;
    for (const Overlay& overlay : diagnosis.overlays)
        for (const auto& [channel, squares] : overlay.remainder)
            if (!overlay.hold_out) shares[overlay.recording] += squares;
    normalise(shares);
    return shares;
}

}  // namespace tread::diagnose::answer
