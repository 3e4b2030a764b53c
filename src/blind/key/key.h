// The sealed key of a blind check: the faults of its cars, and how detectable each is in the drives.
//
// An effect is a fault that the catalogue of the diagnosis has; an outsider is one that no effect can express.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "blind/drives/drives.h"
#include "blind/key/program_hash.h"
#include "blind/world/truth.h"
#include "tread/describe.h"

namespace tread::blind::key {

// one, two: number of effects; outside: an outsider; mixed: an effect and an outsider; small: one effect of at most 15
// % of its typical size.
enum class CaseKind { one, two, none, outside, mixed, small };
constexpr auto enumNames(CaseKind) {
    return std::array<std::string_view, 6>{"one", "two", "none", "outside", "mixed", "small"};
}

// Outsiders of the first family may be used to develop the diagnosis; those of the second only in a frozen check.
enum class Family { first, second };
constexpr auto enumNames(Family) {
    return std::array<std::string_view, 2>{"first", "second"};
}

// A number of the car that an effect changes.
struct PlantedNumber {
    double nominal = 0, value = 0, change = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(nominal), About{"-", "value in the file of the nominal car"});
        field(TREAD_FIELD(value), About{"-", "value of the true car, its error included"});
        field(TREAD_FIELD(change), About{"-", "change by the effect, over its typical size"});
    }
    bool operator==(const PlantedNumber&) const = default;
};
static_assert(describesEveryMember<PlantedNumber>());

// Detectability of a fault in the training drives, computed from the true car, the true size of the fault and the true
// statistics of the noise (detectability.h).
struct Detectability {
    double nats = 0;
    std::string rival;
    double separation = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(nats), About{"nat",
                                       "expected evidence: half the squared signal-to-noise ratio that "
                                       "remains after tolerances have absorbed what they can"});
        field(TREAD_FIELD(rival), About{"", "effect of the catalogue that imitates it best; empty: there is none"});
        field(TREAD_FIELD(separation),
              About{"nat", "evidence that remains when the rival absorbs what it can as well"});
    }
    bool operator==(const Detectability&) const = default;
};
static_assert(describesEveryMember<Detectability>());

struct CaseKey {
    std::string name;
    CaseKind kind = CaseKind::none;
    int draw = 0;
    std::vector<std::string> effects;
    std::string outsider;
    Family family = Family::first;
    std::vector<std::string> generalised_forces;
    std::vector<std::string> structure;
    std::map<std::string, PlantedNumber> numbers;
    std::map<std::string, Detectability> shows;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(name), About{"", "name of its folder"});
        field(TREAD_FIELD(kind), About{"", "kind of the case"});
        field(TREAD_FIELD(draw), About{"", "number of cars drawn before this one because they could not be driven"});
        field(TREAD_FIELD(effects), About{"", "planted effects of the catalogue"});
        field(TREAD_FIELD(outsider), About{"", "planted outsider; empty: none"});
        field(TREAD_FIELD(family), About{"", "family of the outsider"});
        field(TREAD_FIELD(generalised_forces), About{"",
                                                     "the outsider must be found in one of these; empty: it is in an "
                                                     "instrument"});
        field(TREAD_FIELD(structure), About{"",
                                            "structural choices of another simulator, which differ from tread's model; "
                                            "empty: tread"});
        field(TREAD_FIELD(numbers), About{"", "numbers that the effects change, by path"});
        field(TREAD_FIELD(shows), About{"", "detectability of each effect and of the outsider, by name"});
    }
    bool operator==(const CaseKey&) const = default;
};
static_assert(describesEveryMember<CaseKey>());

struct SealedKey {
    std::string tread_version;
    Program program;
    std::uint64_t seed = 0;
    std::string vehicle, generator;
    drives::DriveSet drives = drives::DriveSet::all;
    world::World world = world::World::own;
    bool frozen = false;
    bool references = false;
    std::vector<CaseKey> cases;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(tread_version), About{"", "version of tread that made the cases"});
        field(TREAD_FIELD(program), About{"", "program that made them, by the hashes of its sources"});
        field(TREAD_FIELD(seed), About{"", "seed of all draws"});
        field(TREAD_FIELD(vehicle), About{"", "file of the nominal car"});
        field(TREAD_FIELD(generator), About{"", "simulator that drove the cars, if not tread"});
        field(TREAD_FIELD(drives), About{"", "set of drives"});
        field(TREAD_FIELD(world), About{"", "source of errors, disturbances and noise"});
        field(TREAD_FIELD(frozen),
              About{"", "outsiders of both families were drawn: the diagnosis may not be changed any more"});
        field(TREAD_FIELD(references), About{"", "every drive has a reference: the same drive before the fault"});
        field(TREAD_FIELD(cases), About{"", "in the order of their names"});
    }
};
static_assert(describesEveryMember<SealedKey>());

std::string keyText(const SealedKey& key);  // JSON
// Throws LoadError that names the file.
SealedKey parseKey(std::string_view text, const std::string& file);

// Throws LoadError that lists the valid names.
CaseKind caseKindNamed(std::string_view name);

}  // namespace tread::blind::key
