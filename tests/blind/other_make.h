// Making blind cases of the other car.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "blind/key.h"
#include "blind/other_draw.h"
#include "blind/other_match.h"
#include "diagnose/catalogue/effect.h"

namespace other_car {

struct Order {
    int cases = 0;
    std::uint64_t seed = 0;
    std::vector<tread::CaseKind> kinds = {};  // none: all, in the proportions of a check
    bool references = false, frozen = false;
    std::string vehicle;  // file, for the key
};

// The keys of the same cases: scored with their references (as `--reference` makes them), and without.
struct Keys {
    tread::BlindKey with_references, without_references;
};

// A folder for each case; the keys. Throws FileError, and SimulationError when a car
// cannot be driven.
Keys makeCases(
    const Order& order, const tread::VehicleParams& nominal, const std::filesystem::path& folder,
    const std::function<void(int cases)>& progress = [](int) {});

// The car of a case as one knows it, `index` from 0, and a case with it: the same whenever it is drawn, but for what it
// shows. `draw_number` says the how manieth car for it this is: those before could not be driven.
Truth knownCar(const Order& order, int index, const Matching& matching);
Drawn drawnCase(const Order& order, int index, tread::CaseKind kind, const Truth& known,
                const tread::VehicleParams& nominal, const std::vector<tread::diagnose::catalogue::Effect>& effects,
                int draw_number = 0);

std::uint64_t caseSeed(std::uint64_t seed, int index);

// The day of a case before and after what is wrong happened, at one of its recordings.
Day dayOf(std::uint64_t case_seed, bool before, std::uint64_t recording_seed);

}  // namespace other_car
