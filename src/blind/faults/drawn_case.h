// Draws the true car of a case: a car without fault (world/truth.h), in which effects of the catalogue and an outsider
// are planted. The key records them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "blind/key/key.h"
#include "blind/world/truth.h"
#include "diagnose/catalogue/effect.h"

namespace tread::blind::faults {

struct DrawnCase {
    world::Truth truth;
    key::CaseKey key;
    world::Truth healthy;                         // the same car without its faults
    std::map<std::string, world::Truth> without;  // the true car less one fault, by name of the fault
};

// Options that all cases of a check share.
struct Drawing {
    world::World world = world::World::own;
    bool frozen = false;  // draw outsiders of both families, else of the first
};

// Throws LoadError when fewer effects apply to the car than the kind needs.
DrawnCase drawCase(const VehicleParams& nominal, const std::vector<diagnose::catalogue::Effect>& effects,
                   key::CaseKind kind, Random& random, const Drawing& drawing = {});

// Whether two effects move a common number.
bool sharePaths(const diagnose::catalogue::Effect& a, const diagnose::catalogue::Effect& b);

}  // namespace tread::blind::faults
