#include "diagnose/catalogue.h"

namespace tread {

const std::vector<Effect>& effectCatalogue() {
    static const std::vector<Effect> all = [] {
        std::vector<Effect> effects;
        for (const auto& part : {tyreEffects(), steeringEffects(), suspensionEffects(), drivelineEffects(),
                                 brakeEffects(), bodyEffects(), surroundingsEffects(), instrumentEffects()})
            effects.insert(effects.end(), part.begin(), part.end());
        return effects;
    }();
    return all;
}

}  // namespace tread
