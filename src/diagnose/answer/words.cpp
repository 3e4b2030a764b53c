#include "diagnose/answer/words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "log/log_columns.h"
#include "recording/observation.h"

namespace tread::diagnose::answer {
namespace {

// Probability of the least certain cause.
double probabilityOfCauses(const Diagnosis& d) {
    double p = 1;
    for (const RankedEffect& effect : d.effects) {
        if (std::find(d.causes.begin(), d.causes.end(), effect.name) != d.causes.end())
            p = std::min(p, effect.probability);
    }
    return p;
}

}  // namespace

std::string inWords(const Diagnosis& d) {
    switch (d.verdict) {
        case Verdict::explained:
            return fmt::format("The gap is caused by {} ({})", together(d.causes),
                               probabilityInWords(probabilityOfCauses(d)));
        case Verdict::ambiguous:
            return fmt::format("The gap is caused by {} or {}: these drives cannot separate them", together(d.causes),
                               fmt::join(eachTogether(d.alternatives), " or "));
        case Verdict::nothing:
            return "No effect found: the model explains the recordings within its tolerances";
        case Verdict::unknown:
            return fmt::format("The cause is unknown: no effect of the catalogue explains the missing force ({}){}{}",
                               d.unexplained.generalised_force,
                               d.unexplained.law.follows.empty() ? "" : "; it follows ", d.unexplained.law.follows);
        case Verdict::partly_explained:
            return fmt::format("The gap is partly caused by {} ({}); the rest is unexplained", together(d.causes),
                               probabilityInWords(probabilityOfCauses(d)));
        case Verdict::not_testable:
            return "Not testable: these drives excite all effects too weakly";
    }
    return {};
}

std::string momentInWords(const Moment& moment) {
    return moment.recording.empty() ? "" : fmt::format("{}, at about {:.1f} s", moment.recording, moment.time);
}

std::string separatesInWords(const NextDrive& next) {
    return together(next.one) + " from " + (next.other.empty() ? "none" : together(next.other));
}

std::string channelInWords(const std::string& channel) {
    const recording::ObservedQuantity* quantity = recording::observedQuantity(channel);
    if (!quantity) return channel;
    const std::string source(sourceOf(channel));
    return source.empty() ? quantity->subsystem : quantity->subsystem + " (" + source + ")";
}

std::string probabilityInWords(double p) {
    return p >= 0.995 ? "p > 0.99" : fmt::format("p = {:.2f}", p);
}

std::string lawInWords(const ForceLaw& law) {
    if (law.follows.empty()) return {};
    std::string forces;
    for (const auto& [kind, value] : law.coefficients) {
        const bool moment = kind == "yaw" || kind == "roll";
        forces += fmt::format("{}{} {:.3g} {}", forces.empty() ? "" : ", ", kind, value, moment ? "N m" : "N");
    }
    return fmt::format("a force follows {}: {} per {} ({:.0f} nats)", law.follows, forces, law.unit, law.gain);
}

std::string together(const std::vector<std::string>& causes) {
    return fmt::format("{}", fmt::join(causes, " and "));
}

std::vector<std::string> eachTogether(const std::vector<std::vector<std::string>>& alternatives) {
    std::vector<std::string> words;
    for (const auto& alternative : alternatives) words.push_back(together(alternative));
    return words;
}

std::vector<std::string> namesOnlyIn(const std::vector<std::vector<std::string>>& alternatives,
                                     const std::vector<std::string>& causes) {
    std::set<std::string> names;
    for (const auto& alternative : alternatives) names.insert(alternative.begin(), alternative.end());
    for (const std::string& cause : causes) names.erase(cause);
    return {names.begin(), names.end()};
}

}  // namespace tread::diagnose::answer
