#include "diagnose/catalogue/catalogue.h"

#include <utility>

namespace tread::diagnose::catalogue {
namespace {

std::vector<Effect>& catalogue() {
    static std::vector<Effect> all = [] {
        std::vector<Effect> effects;
        for (const auto& part : {tyreEffects(), steeringEffects(), suspensionEffects(), drivelineEffects(),
                                 brakeEffects(), bodyEffects(), surroundingsEffects(), instrumentEffects()})
            effects.insert(effects.end(), part.begin(), part.end());
        for (Effect& effect : effects) effect.alike = alikeTo(effect.name);
        return effects;
    }();
    return all;
}

}  // namespace

const std::vector<Effect>& effectCatalogue() {
    return catalogue();
}

bool addEffect(Effect effect) {
    catalogue().push_back(std::move(effect));
    return true;
}

}  // namespace tread::diagnose::catalogue
