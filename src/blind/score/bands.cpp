#include "blind/score/bands.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tread/problem.h"

namespace tread::blind::score {
namespace {

using key::CaseKey;
using key::Detectability;

double normalBelow(double z) {
    return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}

}  // namespace

double chanceToGain(double gained, double expected) {
    const double z = std::sqrt(2 * gained), mean = std::sqrt(2 * expected);
    return normalBelow(mean - z) + normalBelow(-mean - z);
}

Band bandOf(double nats) {
    return nats < kDetectable ? Band::hidden
           : nats < kTestable ? Band::faint
           : nats < kStrong   ? Band::testable
                              : Band::strong;
}

std::string_view nameOf(Band band) {
    return enumNames(band)[static_cast<std::size_t>(band)];
}

std::vector<std::string> faultsOf(const CaseKey& key) {
    std::vector<std::string> names = key.effects;
    if (!key.outsider.empty()) names.push_back(key.outsider);
    return names;
}

const Detectability& detectabilityOf(const CaseKey& key, const std::string& name) {
    const auto found = key.shows.find(name);
    if (found == key.shows.end() || !std::isfinite(found->second.nats) || !std::isfinite(found->second.separation)) {
        throw LoadError({{"", 0, 0, key.name + ".shows",
                          "found in the key no evidence that the drives show of \"" + name +
                              "\", expected nats and separation: the cases must be made again with this version"}});
    }
    return found->second;
}

double weakest(const CaseKey& key, const std::vector<std::string>& names) {
    double nats = kInfinity;
    for (const std::string& name : names) nats = std::min(nats, detectabilityOf(key, name).nats);
    return nats;
}

double strongest(const CaseKey& key, const std::vector<std::string>& names) {
    double nats = 0;
    for (const std::string& name : names) nats = std::max(nats, detectabilityOf(key, name).nats);
    return nats;
}

bool toldApart(const CaseKey& key, const std::vector<std::string>& names) {
    return std::all_of(names.begin(), names.end(),
                       [&](const std::string& name) { return detectabilityOf(key, name).separation >= kToldApart; });
}

bool anyDetectable(const CaseKey& key) {
    const std::vector<std::string> names = faultsOf(key);
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& name) { return detectabilityOf(key, name).nats >= kDetectable; });
}

}  // namespace tread::blind::score
