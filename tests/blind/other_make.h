// Makes blind cases with the other simulator.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "blind/key/key.h"
#include "blind/other_draw.h"
#include "blind/other_match.h"
#include "diagnose/catalogue/effect.h"

namespace other_car {

struct Order {
    int cases = 0;
    std::uint64_t seed = 0;
    std::vector<tread::blind::key::CaseKind> kinds = {};  // repeated; empty: all kinds in the proportions of a check
    bool references = false, frozen = false;
    std::string vehicle;  // file name, for the key
};

// Keys of the same cases, with the detectability of a diagnosis with and without references.
struct Keys {
    tread::blind::key::SealedKey with_references, without_references;
};

// Writes a folder for each case and returns the keys. Throws FileError, and SimulationError when no drivable car was
// found for a case.
Keys makeCases(
    const Order& order, const tread::VehicleParams& nominal, const std::filesystem::path& folder,
    const std::function<void(int cases)>& progress = [](int) {});

// Case number `index` (from 0): its car without errors and faults, and the case drawn with it, without its
// detectability. Deterministic. `draw_number`: number of cars that were drawn for the case before and could not be
// driven.
Truth knownCar(const Order& order, int index, const Matching& matching);
Drawn drawnCase(const Order& order, int index, tread::blind::key::CaseKind kind, const Truth& known,
                const tread::VehicleParams& nominal, const std::vector<tread::diagnose::catalogue::Effect>& effects,
                int draw_number = 0);

std::uint64_t caseSeed(std::uint64_t seed, int index);

// Seeds of a recording of a case, before or after the fault.
Day dayOf(std::uint64_t case_seed, bool before, std::uint64_t recording_seed);

}  // namespace other_car
