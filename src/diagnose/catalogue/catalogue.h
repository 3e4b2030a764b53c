// The catalogue by subsystem; effectCatalogue() joins these lists.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "diagnose/catalogue/effect.h"

namespace tread::diagnose::catalogue {

std::vector<Effect> tyreEffects();
std::vector<Effect> steeringEffects();
std::vector<Effect> suspensionEffects();
std::vector<Effect> drivelineEffects();
std::vector<Effect> brakeEffects();
std::vector<Effect> bodyEffects();
std::vector<Effect> surroundingsEffects();
std::vector<Effect> instrumentEffects();

// Names of the effects that can imitate this one; the relation is symmetric.
std::vector<std::string> alikeTo(std::string_view name);

// The rows of the instruments for the further instruments of each source, with their numbers in place of those of the
// first instruments: "yaw_rate_delay@can" for "yaw_rate_delay".
std::vector<Effect> furtherInstrumentEffects(const recording::Instruments& instruments);

}  // namespace tread::diagnose::catalogue
