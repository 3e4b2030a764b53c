#include "diagnose/answer/headline.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/text/did_you_mean.h"
#include "diagnose/answer/changed_numbers.h"
#include "diagnose/answer/parts.h"
#include "diagnose/answer/words.h"

namespace tread::diagnose::answer {
namespace {

constexpr double kFar = 3;  // standard deviations of its tolerance beyond which a number is doubtful: 1 in 400
constexpr std::size_t kMostNumbers = 3;  // such numbers that are named
// Share above which a part is the main one: of the gap for tolerances, of what they and noise leave for a cause.
constexpr double kMostly = 0.5;

bool isDecomposed(const Decomposition& gap) {
    return gap.gap > 0;
}

// "grip (p = 0.97), with mass (p = 0.8) and drag (p = 0.7)"
std::string ranked(const Diagnosis& d, const std::vector<std::string>& causes) {
    std::vector<std::string> others;
    for (std::size_t i = 1; i < causes.size(); ++i) others.push_back(certainly(d, causes[i]));
    return certainly(d, causes.front()) + (others.empty() ? "" : fmt::format(", with {}", fmt::join(others, " and ")));
}

std::vector<std::string> without(std::vector<std::string> causes, const std::vector<std::string>& others) {
    std::erase_if(causes,
                  [&](const std::string& one) { return std::find(others.begin(), others.end(), one) != others.end(); });
    return causes;
}

// Causes that every alternative has too.
std::vector<std::string> undisputed(const Diagnosis& d, std::vector<std::string> causes) {
    for (const std::vector<std::string>& other : d.alternatives) causes = without(causes, without(causes, other));
    return causes;
}

// "grip or mass: these drives cannot tell them apart; straight_braking_100 would", "grip (p = 0.97), with mass or drag,
// which these drives cannot tell apart"
std::string rivals(const Diagnosis& d, const std::vector<std::string>& causes) {
    const std::vector<std::string> sure = undisputed(d, causes);
    std::vector<std::string> names{together(without(causes, sure))};
    for (const std::vector<std::string>& other : d.alternatives) names.push_back(together(without(other, sure)));
    const std::string drive = tellingDrive(d), would = drive.empty() ? "" : "; " + drive + " would";
    const std::string either = fmt::format("{}", fmt::join(names, " or "));
    return sure.empty()
               ? either + ": these drives cannot tell them apart" + would
               : fmt::format("{}, with {}, which these drives cannot tell apart{}", ranked(d, sure), either, would);
}

// Share of the leading cause, or of the family of rivals, in what tolerances and noise leave.
double leadingShare(const Diagnosis& d) {
    const Decomposition& gap = d.training;
    if (gap.each.empty()) return 0;
    return shareOfTheRest(gap, d.alternatives.empty() ? inOrder(gap).front().first.share : gap.causes.share);
}

// " (15 % in the held-out drives)", where anything remains
std::string inHeldOutDrives(const Diagnosis& d) {
    const double held_out = d.held_out.remainder.share;
    return isDecomposed(d.held_out) && (d.training.remainder.share > 0 || held_out > 0)
               ? fmt::format(" ({} in the held-out drives)", percentInWords(held_out))
               : "";
}

// "the car vibrates at 5 Hz, unlike before the change"; empty when it does not.
std::string vibrates(const Diagnosis& d) {
    const Vibration& vibration = d.unexplained.vibration;
    if (vibration.growth.empty()) return {};
    return fmt::format("the car vibrates at {:.0f} Hz, unlike before the change", vibration.frequency);
}

// "looks like an error of an instrument: speeds that come late or early in some drives"; empty for other remainders.
std::string misreadInWords(const Diagnosis& d) {
    const std::string& kind = d.unexplained.instrument;
    return kind.empty() ? "" : "looks like an error of an instrument: " + kindOfForceInWords(kind);
}

// What speaks for an unknown cause where nothing is left that exceeds noise.
std::string pattern(const Diagnosis& d) {
    const std::string vibration = vibrates(d), law = followsInWords(d.unexplained.law), misread = misreadInWords(d);
    const std::string what_remains = "what remains " + (!law.empty()       ? law
                                                        : !misread.empty() ? misread
                                                                           : "has a pattern");
    return "nothing of the gap exceeds noise" + inHeldOutDrives(d) + ", but " +
           (vibration.empty() ? what_remains : vibration);
}

// "12 % of the gap remains unexplained (15 % in the held-out drives), and the car vibrates at 5 Hz, unlike before ..."
std::string remainder(const Diagnosis& d) {
    if (!isDecomposed(d.training)) return {};
    const double share = d.training.remainder.share;
    if (share <= 0 && d.verdict == Verdict::partly_explained) return pattern(d);
    const std::string vibration = vibrates(d);
    return (share > 0 ? percentInWords(share) + " of the gap" : "nothing") + " remains unexplained" +
           inHeldOutDrives(d) + (vibration.empty() ? "" : (share > 0 ? ", and " : ", but ") + vibration);
}

// "explains 20 % of the gap"
std::string effectOf(const Part& causes) {
    return causes.share < 0 ? "makes the gap " + percentInWords(-causes.share) + " larger"
                            : "explains " + percentInWords(causes.share) + " of the gap";
}

std::string ofCauses(const Diagnosis& d) {
    const std::vector<std::string> causes = causesInOrder(d);
    std::string text = d.alternatives.empty() ? ranked(d, causes) : rivals(d, causes);
    const double tolerances = d.training.tolerances.share;
    const bool mostly = tolerances <= kMostly && leadingShare(d) > kMostly;
    text = mostly ? "Mostly " + text : capitalised(text);
    if (tolerances > kMostly)
        text += fmt::format("; tolerances alone would explain {} of the gap, but with unlikely values; {} is noise",
                            percentInWords(tolerances), percentInWords(d.training.noise.share));
    else if (!mostly && isDecomposed(d.training))
        text += (d.alternatives.empty() ? " " : "; it ") + effectOf(d.training.causes);
    const std::string rest = remainder(d);
    return text + (rest.empty() ? "" : "; " + rest);
}

// Tolerances that explain a gap only because they are too narrow are no explanation.
std::string doubtOfTolerances(const Diagnosis& d) {
    std::vector<std::string> far;
    for (const MovedNumber& number : movedNumbers(d.nuisance))
        if (std::abs(number.estimate.z) > kFar) far.push_back(number.name);
    if (far.empty()) return {};
    const std::size_t told = std::min(far.size(), kMostNumbers), others = far.size() - told;
    const std::string names = fmt::format("{}", fmt::join(far.begin(), far.begin() + static_cast<long>(told), ", "));
    return fmt::format("; but {}{} moved by more than {:.0f} standard deviations of {}", names,
                       others > 0 ? fmt::format(" and {} other number{}", others, others == 1 ? "" : "s") : "", kFar,
                       far.size() == 1 ? "its tolerance" : "their tolerances");
}

// "Mostly unknown: 60 % of the gap remains unexplained", "Mostly tolerances: they explain 70 % of the gap; 20 % of the
// gap remains unexplained", "Unknown: nothing of the gap exceeds noise, but what remains has a pattern"
std::string unknownPart(const Diagnosis& d) {
    if (!isDecomposed(d.training)) return "Mostly unknown";
    if (d.training.remainder.share > 0) {
        const double tolerances = d.training.tolerances.share;
        return (tolerances > kMostly
                    ? fmt::format("Mostly tolerances: they explain {} of the gap; ", percentInWords(tolerances))
                    : "Mostly unknown: ") +
               remainder(d);
    }
    return "Unknown: " + pattern(d);
}

std::string ofUnknown(const Diagnosis& d) {
    std::string text = unknownPart(d);
    if (d.causes.empty()) text += "; no effect in the catalogue explains it";
    else text += fmt::format("; {} {}", ranked(d, causesInOrder(d)), effectOf(d.training.causes));
    const bool exceeds_noise = !isDecomposed(d.training) || d.training.remainder.share > 0;
    const std::string law = exceeds_noise ? followsInWords(d.unexplained.law) : "";  // else the pattern tells it
    const std::string misread = followsInWords(d.unexplained.law).empty() ? misreadInWords(d) : "";
    if (!misread.empty()) text += exceeds_noise ? "; it " + misread : "";
    else if (!d.unexplained.generalised_force.empty() && (exceeds_noise || vibrates(d).empty()))
        text += fmt::format("; missing force: {}{}", d.unexplained.generalised_force, law.empty() ? "" : ", it " + law);
    return text + doubtOfTolerances(d);
}

// "Nothing certain, perhaps mass (p = 0.9)", "Nothing certain, perhaps mass (p = 0.4) or drag (p = 0.3)": it may be
// likely that some effect acts, although none is certain enough to be a cause.
std::string nothingNamed(const Diagnosis& d) {
    constexpr double kLikely = 0.5, kLeast = 0.1;  // probability of an effect that is told alone, or beside others
    constexpr std::size_t kMostTold = 3;
    if (!isUncertain(d)) return "Nothing found";
    const bool one_is_likely = d.effects.front().probability > kLikely;
    std::vector<std::string> perhaps;
    for (const RankedEffect& effect : d.effects) {
        const bool told = !one_is_likely && effect.probability >= kLeast && perhaps.size() < kMostTold;
        if (perhaps.empty() || told) perhaps.push_back(certainly(d, effect.name));
    }
    const std::vector<std::string_view> names(perhaps.begin(), perhaps.end());
    return "Nothing certain, perhaps " + tread::listed(names);
}

std::string ofNothing(const Diagnosis& d) {
    const Decomposition& gap = d.training;
    if (!isDecomposed(gap)) return nothingNamed(d) + ": the model explains the recordings within its tolerances";
    return fmt::format("{}: tolerances explain {} of the gap, {} is noise, {}{}", nothingNamed(d),
                       percentInWords(std::max(0.0, gap.tolerances.share)), percentInWords(gap.noise.share),
                       remainder(d), doubtOfTolerances(d));
}

}  // namespace

std::string headline(const Diagnosis& d) {
    switch (d.verdict) {
        case Verdict::explained:
        case Verdict::ambiguous:
        case Verdict::partly_explained:
            return ofCauses(d);
        case Verdict::nothing:
            return ofNothing(d);
        case Verdict::unknown:
            return ofUnknown(d);
        case Verdict::not_testable:
            return "Not testable: these drives excite all effects too weakly";
    }
    return {};
}

}  // namespace tread::diagnose::answer
