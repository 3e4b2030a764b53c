// Outsiders: faults that no effect of the catalogue can express at any size.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "blind/key/key.h"
#include "blind/world/truth.h"

namespace tread::blind::faults {

struct Outsider {
    std::string name;
    std::string what;
    key::Family family;
    // A diagnosis must locate it in one of these: longitudinal, lateral, yaw, roll. Empty: it is in an instrument.
    std::vector<std::string> generalised_forces;
    void (*plant)(world::Truth&, Random&);  // draws its size
};

// First family, then second.
const std::vector<Outsider>& outsiders();
std::vector<const Outsider*> outsiders(key::Family family);

std::vector<Outsider> firstOutsiders();
std::vector<Outsider> secondOutsiders();

}  // namespace tread::blind::faults
