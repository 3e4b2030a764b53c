#include "diagnose/answer/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "diagnose/settings.h"
#include "log/log_columns.h"
#include "recording/observation.h"

namespace tread::diagnose::answer {
namespace {

constexpr double kUsual = 2;  // sizes of a force in the remainder up to which it is usual

std::string words(std::string_view name) {
    std::string out(name);
    std::replace(out.begin(), out.end(), '_', ' ');
    return out;
}

// " and " between the last two, commas between the others.
std::string listed(const std::vector<std::string>& all) {
    std::string list;
    for (std::size_t i = 0; i < all.size(); ++i) list += (i == 0 ? "" : i + 1 == all.size() ? " and " : ", ") + all[i];
    return list;
}

bool sameSet(const std::vector<std::string>& a, const std::vector<std::string>& b) {
    return a.size() == b.size() && std::is_permutation(a.begin(), a.end(), b.begin());
}

}  // namespace

std::string effectInWords(std::string_view name) {
    const std::string_view source = sourceOf(name);
    if (source.empty()) return words(name);
    return words(quantityOf(name)) + " (" + words(source) + ")";
}

std::string capitalised(std::string sentence) {
    if (!sentence.empty() && sentence[0] >= 'a' && sentence[0] <= 'z')
        sentence[0] = static_cast<char>(sentence[0] - 'a' + 'A');
    return sentence;
}

std::string roundedPercent(double share) {
    return fmt::format("{:.0f} %", std::round(100 * share) + 0.0);  // no negative zero
}

std::string percentInWords(double share) {
    constexpr double kLeast = 0.005;
    return share > 0 && share < kLeast ? "less than 1 %" : roundedPercent(share);
}

std::string shortNumber(double value, int significant_digits) {
    constexpr double kLong = 1e6;  // up to it, whole numbers read better than powers of ten
    const std::string text = fmt::format("{:.{}g}", value, significant_digits);
    const bool power = text.find('e') != std::string::npos && std::abs(value) >= 1 && std::abs(value) < kLong;
    return power ? fmt::format("{:.0f}", value) : text;
}

std::string kindOfForceInWords(const std::string& kind) {
    static const std::map<std::string, std::string> known{
        {"longitudinal", "longitudinal disturbances"},
        {"lateral", "lateral disturbances"},
        {"yaw", "disturbances in yaw"},
        {"roll", "disturbances in roll"},
        {"steering", "tremor of the road wheels"},
        {"longitudinal error", "errors of the longitudinal forces, in proportion to the longitudinal acceleration"},
        {"lateral error", "errors of the side forces, in proportion to the lateral acceleration"},
        {"yaw error", "errors of the yaw moment, in proportion to the lateral acceleration"},
        {"roll error", "errors of the roll moment, in proportion to the lateral acceleration"},
        {"rate readings", "drift of the rate sensors"},
        {"acceleration readings", "drift of the accelerometers"},
        {"angle readings", "drift of the measured angles"},
        {"speed readings", "drift of the measured speed"},
        {"wheel-speed readings", "drift of the wheel speeds"},
        {"rate scale", "yaw or roll rates whose scale differs from drive to drive, or with the reading"},
        {"acceleration scale", "accelerations whose scale differs from drive to drive, or with the reading"},
        {"angle scale", "roll or sideslip angles whose scale differs from drive to drive, or with the reading"},
        {"rate timing", "yaw or roll rates that come late or early in some drives"},
        {"acceleration timing", "accelerations that come late or early in some drives"},
        {"angle timing", "roll or sideslip angles that come late or early in some drives"},
        {"speed timing", "speeds that come late or early in some drives"},
        {"wheel-speed timing", "wheel speeds that come late or early at some wheels or in some drives"},
        {"imperfections of tyres", "small errors everywhere in the tyres"},
        {"imperfections of suspension", "small errors everywhere in the suspension"},
        {"imperfections of steering", "small errors everywhere in the steering"},
        {"imperfections of drive", "small errors everywhere in engine, driveline and brakes"},
        {"imperfections of body", "small errors everywhere in masses, inertias and aerodynamics"},
        {"imperfections of surroundings", "small errors of road and wind"},
        {"imperfections of instruments", "small errors everywhere in the instruments"}};
    const auto found = known.find(kind);
    return found == known.end() ? kind : found->second;
}

std::vector<std::pair<double, std::string>> largeForces(const Unexplained& unexplained) {
    std::vector<std::pair<double, std::string>> large;
    for (const auto& [kind, size] : unexplained.sizes)
        if (size > kUsual) large.push_back({size, kind});
    std::stable_sort(large.begin(), large.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    return large;
}

bool isAnswered(const Diagnosis& d) {
    return d.verdict != Verdict::unknown && d.verdict != Verdict::not_testable;
}

std::vector<std::string> unseenEffects(const Diagnosis& d) {
    const std::vector<std::string> rivals = namesOnlyIn(d.alternatives, d.causes);
    std::vector<std::string> unseen;
    for (const auto& [name, nats] : d.expected_evidence) {
        const bool named = isCause(d, name) || std::find(rivals.begin(), rivals.end(), name) != rivals.end();
        if (nats < kTestable && !named) unseen.push_back(name);
    }
    return unseen;
}

bool isUncertain(const Diagnosis& d) {
    constexpr double kLikely = 0.5;
    return d.verdict == Verdict::nothing && !d.effects.empty() &&
           1 - d.probability_of_nothing - d.probability_of_unknown > kLikely;
}

bool isCause(const Diagnosis& d, const std::string& effect) {
    return std::find(d.causes.begin(), d.causes.end(), effect) != d.causes.end();
}

std::vector<std::string> causesInOrder(const Diagnosis& d) {
    std::vector<std::string> causes = d.causes;
    const auto share = [&](const std::string& name) {
        for (const CausePart& one : d.training.each)
            if (one.name == name) return one.first.share;
        return 0.0;
    };
    std::stable_sort(causes.begin(), causes.end(), [&](const auto& a, const auto& b) { return share(a) > share(b); });
    return causes;
}

std::string tellingDrive(const Diagnosis& d) {
    const auto isRival = [&](const std::vector<std::string>& set) {
        return std::any_of(d.alternatives.begin(), d.alternatives.end(),
                           [&](const auto& one) { return sameSet(one, set); });
    };
    for (const NextDrive& next : d.next) {
        const bool tells = (sameSet(next.one, d.causes) && isRival(next.other)) ||
                           (sameSet(next.other, d.causes) && isRival(next.one));
        if (tells) return next.scenario;
    }
    return {};
}

std::string momentInWords(const Moment& moment) {
    return moment.recording.empty() ? "" : fmt::format("{}, at about {:.1f} s", moment.recording, moment.time);
}

std::string separatesInWords(const NextDrive& next) {
    return together(next.one) + " from " + (next.other.empty() ? "no effect" : together(next.other));
}

std::string evidenceInWords(const NextDrive& next) {
    constexpr double kCertain = 100;  // nats
    return next.nats > kCertain ? fmt::format("more than {:.0f} nats", kCertain)
                                : fmt::format("{:.0f} nats", next.nats);
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

std::string followsInWords(const ForceLaw& law) {
    if (law.follows.empty()) return {};
    return law.unit.empty() ? "is constant" : "follows " + law.follows;
}

std::string lawInWords(const ForceLaw& law) {
    if (law.follows.empty()) return {};
    std::string forces;
    for (const auto& [kind, value] : law.coefficients) {
        const bool moment = kind == "yaw" || kind == "roll";
        forces += fmt::format("{}{} {:.3g} {}", forces.empty() ? "" : ", ", kind, value, moment ? "N m" : "N");
    }
    return fmt::format("a force that {}: {}{} ({:.0f} nats)", followsInWords(law), forces,
                       law.unit.empty() ? "" : " per " + law.unit, law.gain);
}

std::string vibrationInWords(const Vibration& vibration) {
    if (vibration.growth.empty()) return {};
    std::vector<std::pair<double, std::string>> channels;
    for (const auto& [name, growth] : vibration.growth) channels.push_back({growth, channelInWords(name)});
    std::stable_sort(channels.begin(), channels.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<std::string> grown;
    for (const auto& [growth, name] : channels) grown.push_back(fmt::format("{} {:.2g} times", name, growth));
    return fmt::format("a vibration at {:.0f} Hz that the references lack: {} their amplitude ({:.0f} nats)",
                       vibration.frequency, fmt::join(grown, ", "), vibration.gain);
}

std::string together(const std::vector<std::string>& causes) {
    std::vector<std::string> names;
    for (const std::string& cause : causes) names.push_back(effectInWords(cause));
    return listed(names);
}

std::vector<std::string> eachTogether(const std::vector<std::vector<std::string>>& alternatives) {
    std::vector<std::string> words;
    for (const auto& alternative : alternatives) words.push_back(together(alternative));
    return words;
}

std::string certainly(const Diagnosis& d, const std::string& cause) {
    for (const RankedEffect& effect : d.effects)
        if (effect.name == cause)
            return fmt::format("{} ({})", effectInWords(cause), probabilityInWords(effect.probability));
    return effectInWords(cause);
}

std::vector<RankedEffect> otherEffects(const Diagnosis& d, double least_probability) {
    const std::vector<std::string> rivals = namesOnlyIn(d.alternatives, d.causes);
    std::vector<RankedEffect> others;
    for (const RankedEffect& effect : d.effects) {
        const bool named =
            isCause(d, effect.name) || std::find(rivals.begin(), rivals.end(), effect.name) != rivals.end();
        if (!named && effect.probability >= least_probability) others.push_back(effect);
    }
    return others;
}

std::vector<ConfusablePair> pairsOfCauses(const Diagnosis& d) {
    std::vector<ConfusablePair> pairs;
    for (const ConfusablePair& pair : d.confusable)
        if (isCause(d, pair.a) || isCause(d, pair.b)) pairs.push_back(pair);
    return pairs;
}

std::vector<std::string> namesOnlyIn(const std::vector<std::vector<std::string>>& alternatives,
                                     const std::vector<std::string>& causes) {
    std::set<std::string> names;
    for (const auto& alternative : alternatives) names.insert(alternative.begin(), alternative.end());
    for (const std::string& cause : causes) names.erase(cause);
    return {names.begin(), names.end()};
}

}  // namespace tread::diagnose::answer
