// Drawing what is wrong with a car of the other simulator.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "base/random.h"
#include "blind/key.h"
#include "blind/other_truth.h"
#include "blind/outsiders.h"
#include "diagnose/catalogue/effect.h"
#include "recording/subject.h"

namespace other_car {

// Two or three structural choices, of which no two say what the tyre's curve is.
Structure drawStructure(tread::Random& random);
std::vector<std::string> namesOf(const Structure& structure);
// Throws std::invalid_argument for a name that is none.
Structure structureOf(const std::vector<std::string>& names);

// A car of a case: what it is without day-to-day differences.
struct Drawn {
    struct Planted {
        tread::diagnose::catalogue::Effect effect;
        std::vector<double> changes;  // of its knobs, in their own units
    };
    Truth known;                        // goes with
    tread::recording::Subject nominal;  // , of which
    tread::recording::Subject erring;   // is the real one without what is wrong
    std::vector<Planted> planted;
    const tread::Outsider* outsider = nullptr;
    std::uint64_t outsider_seed = 0;
    tread::CaseKey key;
};

// A car that errs in all shared numbers, with effects and outsiders as the kind wants them; outsiders of
// the second family only when `frozen`, then as often as those of the first. Throws std::invalid_argument when there
// are not enough effects.
Drawn draw(const Truth& known, const tread::recording::Subject& nominal,
           const std::vector<tread::diagnose::catalogue::Effect>& effects, bool frozen, tread::CaseKind kind,
           tread::Random& random);

// What the drive `drive` of a day meets (other_errors.h).
struct Day {
    std::uint64_t day_seed = 0, drive_seed = 0;
};

// The car that is driven, without those wrong things that are named; without a day nothing differs from day to day.
Truth drivenCar(const Drawn& drawn, const std::set<std::string>& without = {}, const Day* day = nullptr);
// All that is wrong.
std::set<std::string> wrongThings(const Drawn& drawn);

}  // namespace other_car
