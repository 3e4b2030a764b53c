// Causes that no effect of the catalogue can express, at any size.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "blind/draws.h"
#include "blind/truth.h"

namespace tread {

struct Outsider {
    std::string name;
    std::string what;
    Family family;
    // Of these, one is where a diagnosis must find it: longitudinal, lateral, yaw, roll; empty: on an instrument.
    std::vector<std::string> generalised_forces;
    void (*plant)(Truth&, Random&);  // with a size of its own
};

// Those of the first family, then those of the second.
const std::vector<Outsider>& outsiders();
std::vector<const Outsider*> outsiders(Family family);

std::vector<Outsider> firstOutsiders();
std::vector<Outsider> secondOutsiders();

}  // namespace tread
