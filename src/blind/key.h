// What is wrong with the cars of a blind check, and what their drives show of it: the sealed key.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "blind/drives.h"
#include "blind/program_hash.h"
#include "tread/describe.h"

namespace tread {

// one, two: so many effects of the catalogue; outside: something that the catalogue does not have; mixed: one effect
// and something outside of the catalogue; small: an effect of at most 15 % of its typical size.
enum class CaseKind { one, two, none, outside, mixed, small };
constexpr auto enumNames(CaseKind) {
    return std::array<std::string_view, 6>{"one", "two", "none", "outside", "mixed", "small"};
}

// Where the errors, disturbances and noise of the cases come from. `own`: a source of the examiner's (errors.h,
// surroundings.h, gauges.h). `assumed`: what the diagnosis itself assumes, to compare with.
enum class World { own, assumed };
constexpr auto enumNames(World) {
    return std::array<std::string_view, 2>{"own", "assumed"};
}

// Outsiders of the first family may be used to develop the diagnosis, those of the second only in a frozen check.
enum class Family { first, second };
constexpr auto enumNames(Family) {
    return std::array<std::string_view, 2>{"first", "second"};
}

struct PlantedNumber {
    double nominal = 0, value = 0, change = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(nominal), About{"-", "of the car as its file says"});
        field(TREAD_FIELD(value), About{"-", "of the car that was driven, its error included"});
        field(TREAD_FIELD(change), About{"-", "that the effect makes, in units of its typical size"});
    }
    bool operator==(const PlantedNumber&) const = default;
};
static_assert(describesEveryMember<PlantedNumber>());

// What the drives from which to learn show of something that is wrong, as the examiner finds it with the true car, the
// true size and the noise that was put in (shows.h).
struct Shows {
    double nats = 0;
    std::string rival;
    double separation = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(nats), About{"nat",
                                       "expected evidence: half the squared signal over noise, of which the "
                                       "tolerances can absorb nothing more"});
        field(TREAD_FIELD(rival), About{"", "effect of the catalogue that imitates it best; empty: none was tried"});
        field(TREAD_FIELD(separation), About{"nat", "the same, when the rival may absorb what it can, too"});
    }
    bool operator==(const Shows&) const = default;
};
static_assert(describesEveryMember<Shows>());

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
    std::map<std::string, Shows> shows;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(name), About{"", "of its folder"});
        field(TREAD_FIELD(kind), About{"", "kind of the case"});
        field(TREAD_FIELD(draw), About{"", "the how manieth car that was drawn: those before could not be driven"});
        field(TREAD_FIELD(effects), About{"", "effects of the catalogue that act"});
        field(TREAD_FIELD(outsider), About{"", "what acts besides and is not in the catalogue"});
        field(TREAD_FIELD(family), About{"", "of the outsider"});
        field(TREAD_FIELD(generalised_forces), About{"",
                                                     "of these one is where the outsider must be found; none: it is "
                                                     "an instrument"});
        field(TREAD_FIELD(structure), About{"",
                                            "in what the car that was driven is modelled otherwise, before and after; "
                                            "empty: tread's own model"});
        field(TREAD_FIELD(numbers), About{"", "of the effects, by path"});
        field(TREAD_FIELD(shows), About{"", "of each effect and of the outsider, by name"});
    }
    bool operator==(const CaseKey&) const = default;
};
static_assert(describesEveryMember<CaseKey>());

struct BlindKey {
    std::string tread_version;
    Program program;
    std::uint64_t seed = 0;
    std::string vehicle, generator;
    DriveSet drives = DriveSet::all;
    World world = World::own;
    bool frozen = false;
    bool references = false;
    std::vector<CaseKey> cases;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(tread_version), About{"", "version of tread that made the cases"});
        field(TREAD_FIELD(program), About{"", "that made them, by the hashes of its sources"});
        field(TREAD_FIELD(seed), About{"", "another number, other cases"});
        field(TREAD_FIELD(vehicle), About{"", "file of the nominal car"});
        field(TREAD_FIELD(generator), About{"", "another simulator that drove the cars; empty: tread"});
        field(TREAD_FIELD(drives), About{"", "set of drives"});
        field(TREAD_FIELD(world), About{"", "source of errors, disturbances and noise"});
        field(TREAD_FIELD(frozen),
              About{"", "outsiders of both families were drawn, to check what is no longer changed"});
        field(TREAD_FIELD(references), About{"", "each drive also of the car as it was before"});
        field(TREAD_FIELD(cases), About{"", "in the order of their names"});
    }
};
static_assert(describesEveryMember<BlindKey>());

std::string keyText(const BlindKey& key);  // JSON
// Throws LoadError that names the file.
BlindKey parseKey(std::string_view text, const std::string& file);

// Throws LoadError with the names that there are.
CaseKind caseKind(std::string_view name);
World world(std::string_view name);

}  // namespace tread
