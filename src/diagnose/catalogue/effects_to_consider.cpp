#include "diagnose/catalogue/effects_to_consider.h"

#include <algorithm>

#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "base/text/pattern.h"
#include "base/yaml/session.h"
#include "diagnose/catalogue/catalogue.h"

namespace tread::diagnose::catalogue {

std::vector<Effect> effectsToConsider(const recording::DiagnosisFile& file) {
    std::vector<Effect> all = effectCatalogue();
    const std::vector<Effect> further = furtherInstrumentEffects(file.instruments);
    all.insert(all.end(), further.begin(), further.end());
    if (!file.own_effects.empty()) {
        const std::vector<Effect> own = loadOwnEffects(file.own_effects);
        all.insert(all.end(), own.begin(), own.end());
    }
    if (file.effects.empty()) return all;

    std::vector<std::string_view> names;
    for (const Effect& effect : all) names.push_back(effect.name);
    std::vector<Problem> problems;
    for (std::size_t i = 0; i < file.effects.size(); ++i) {
        const std::string& pattern = file.effects[i];
        // The logs decide which further instruments there are, so that only the part before @ can be judged here.
        const std::string known = pattern.substr(0, pattern.find('@'));
        const auto fits = [&](std::string_view name) { return matches(pattern, name) || matches(known, name); };
        if (std::any_of(names.begin(), names.end(), fits)) continue;
        const std::string suggestion = didYouMean(pattern, names);
        problems.push_back({"", 0, 0, "effects." + std::to_string(i),
                            "found " + quote(pattern) + ", expected the name of an effect" +
                                (suggestion.empty() ? ";" : suggestion) + " `tread describe effects` lists them"});
    }
    throwIfAny(std::move(problems));
    std::erase_if(all, [&](const Effect& effect) {
        return std::none_of(file.effects.begin(), file.effects.end(),
                            [&](const std::string& pattern) { return matches(pattern, effect.name); });
    });
    return all;
}

}  // namespace tread::diagnose::catalogue
