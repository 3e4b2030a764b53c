// What is wrong with the cars of a blind check: the sealed key.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "blind/drives.h"

namespace tread {

enum class CaseKind { one, two, none, outside, small };
constexpr auto enumNames(CaseKind) {
    return std::array<std::string_view, 5>{"one", "two", "none", "outside", "small"};
}

struct PlantedNumber {
    double nominal = 0;
    double value = 0;   // of the car that was driven, its small error included
    double change = 0;  // that the effect makes, in units of its typical size
    bool operator==(const PlantedNumber&) const = default;
};

struct CaseKey {
    std::string name;  // of its folder
    CaseKind kind = CaseKind::none;
    int draw = 0;                      // the how manieth car that was drawn: those before could not be driven
    std::vector<std::string> effects;  // of the catalogue
    std::string outsider;              // of none, in the kind `outside`
    std::vector<std::string> generalised_forces;   // of these one is where it must be found; none: an instrument
    std::map<std::string, PlantedNumber> numbers;  // of the effects, by path
    bool operator==(const CaseKey&) const = default;
};

struct BlindKey {
    std::string tread_version;
    std::uint64_t seed = 0;
    std::string vehicle;
    std::string generator;  // another simulator that drove the cars; empty: tread
    DriveSet drives = DriveSet::all;
    std::vector<CaseKey> cases;
};

std::string keyText(const BlindKey& key);  // JSON
// Throws LoadError that names the file.
BlindKey parseKey(std::string_view text, const std::string& file);

// Throws LoadError with the names that there are.
CaseKind caseKind(std::string_view name);

}  // namespace tread
