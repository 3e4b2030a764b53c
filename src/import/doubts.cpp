#include "import/doubts.h"

#include <fmt/format.h>

#include <algorithm>

#include "import/relations.h"
#include "import/vehicle_reach.h"
#include "log/log_columns.h"

namespace tread {
namespace {

std::string joined(const std::vector<std::string>& names, std::string_view last) {
    std::string out;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) out += i + 1 == names.size() ? std::string(last) : ", ";
        out += names[i];
    }
    return out;
}

// Where the votes do not settle it, the odd one out is one of several.
void judgeSigns(std::vector<Change>& found, const std::vector<BodyRelation>& relations) {
    const OddOnes odd = oddOnes(relations);
    for (const std::string& channel : odd.turned) {
        std::size_t contradict = 0, all = 0;
        std::vector<std::string> others;
        for (const BodyRelation& relation : relations) {
            if (relation.channel != channel && relation.other != channel) continue;
            const std::string& other = relation.channel == channel ? relation.other : relation.channel;
            if (std::find(others.begin(), others.end(), other) == others.end()) others.push_back(other);
            contradict += relation.correlation < 0;
            ++all;
        }
        found.push_back({"doubt", channel, 1,
                         fmt::format("is the odd one out: {} of {} rigid-body checks against {} contradict its sign; "
                                     "set its sign to -1, or swap its axis",
                                     contradict, all, joined(others, " and "))});
    }
    if (odd.either.empty()) return;
    found.push_back({"doubt", odd.either.front(), 1,
                     fmt::format("one of {} has the wrong sign, and no other channel shows which; compare with a turn "
                                 "to the left, where all are positive in ISO 8855",
                                 joined(odd.either, " and "))});
}

// Values that no road vehicle reaches. Angles that may be counted on, or that a spin takes all round, have no such
// limit.
void judgeReach(std::vector<Change>& found, const Log& log) {
    for (const Channel& channel : log.channels) {
        const std::string_view name = quantityOf(channel.name);
        const bool moves = name.starts_with("chassis.") || name == "driver.steering_wheel_angle";
        if (!moves || name == "chassis.yaw" || name == "chassis.sideslip") continue;
        const std::string why = implausible(name, channel.unit, channel.values);
        if (!why.empty()) found.push_back({"doubt", channel.name, 1, why + "; is its unit wrong?"});
    }
}

void judgeWheel(std::vector<Change>& found, const BodyRelation& relation) {
    constexpr double kSmallest = 0.2, kLargest = 0.6;  // m
    const double radius = 1 / relation.factor;
    if (!relation.channel.ends_with(".spin") || (radius > kSmallest && radius < kLargest)) return;
    found.push_back(
        {"doubt", relation.channel, 1,
         fmt::format("turns as if its rolling radius were {:.3g} m; is its unit or rolling_radius wrong?", radius)});
}

}  // namespace

std::vector<Change> doubts(const Log& log) {
    std::vector<Change> found;
    judgeReach(found, log);
    const std::vector<Swapped> swapped = swappedChannels(log);
    for (const Swapped& pair : swapped) {
        found.push_back({"doubt", pair.one, 1,
                         fmt::format("seems swapped with {} ({}): exchange their columns", pair.other, pair.why)});
    }
    if (!swapped.empty()) return found;  // signs and units of swapped channels say nothing

    const std::vector<BodyRelation> relations = bodyRelations(log);
    for (const BodyRelation& relation : relations) {
        if (relation.correlation < 0) {
            found.push_back({"doubt", relation.channel, 1,
                             fmt::format("{} have opposite signs (correlation {:.2f}): one of them is not ISO 8855 "
                                         "(forward, left and up positive); its sign should be -1",
                                         relation.says, relation.correlation)});
        }
        judgeWheel(found, relation);
        const std::string look = lookOfFactor(relation.factor);
        if (relation.sized && !look.empty()) {
            found.push_back({"doubt", relation.channel, 1,
                             fmt::format("{} differ by a factor of {:.3g}{}; is a unit wrong?", relation.says,
                                         relation.factor, look)});
        }
    }
    judgeSigns(found, relations);
    return found;
}

}  // namespace tread
