// Draws the faults of a car of the other simulator.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "base/math/random.h"
#include "blind/faults/outsiders.h"
#include "blind/key/key.h"
#include "blind/other_truth.h"
#include "diagnose/catalogue/effect.h"
#include "recording/subject.h"

namespace other_car {

// Two or three structural choices; at most one of them replaces the tyre curve.
Structure drawStructure(tread::Random& random);
std::vector<std::string> namesOf(const Structure& structure);
// Throws std::invalid_argument for an unknown name.
Structure structureOf(const std::vector<std::string>& names);

// The car of a case, without day-to-day differences.
struct Drawn {
    struct Planted {
        tread::diagnose::catalogue::Effect effect;
        std::vector<double> changes;  // of its knobs, in units of each knob
    };
    Truth known;                        // car of the other simulator that corresponds to `nominal`
    tread::recording::Subject nominal;  // tread's car
    tread::recording::Subject erring;   // `nominal` with the errors of the true car, without its faults
    std::vector<Planted> planted;
    const tread::blind::faults::Outsider* outsider = nullptr;
    std::uint64_t outsider_seed = 0;
    tread::blind::key::CaseKey key;
};

// Draws errors of all shared numbers, effects and outsider according to the kind; outsiders of the second family only
// when `frozen`, then as often as those of the first. Throws std::invalid_argument when there are too few effects.
Drawn draw(const Truth& known, const tread::recording::Subject& nominal,
           const std::vector<tread::diagnose::catalogue::Effect>& effects, bool frozen,
           tread::blind::key::CaseKind kind, tread::Random& random);

// Seeds of the circumstances of one drive (other_errors.h).
struct Day {
    std::uint64_t day_seed = 0, drive_seed = 0;
};

// The true car less the faults named in `without`. Without a day there are no day-to-day differences.
Truth drivenCar(const Drawn& drawn, const std::set<std::string>& without = {}, const Day* day = nullptr);
// Names of all faults.
std::set<std::string> faultNames(const Drawn& drawn);

}  // namespace other_car
