// What the named causes change on the car, number by number.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "diagnose/answer/diagnosis.h"

namespace tread::diagnose::answer {

// One number, or several that mean the same and change alike, as those of both axles.
struct ChangedNumber {
    std::vector<std::string> paths;
    Estimate estimate;
};

// True for a number at the end of its plausible range that is not the nominal value.
bool atItsEnd(const Estimate& estimate);

std::vector<ChangedNumber> changedNumbers(const RankedEffect& effect);

// The effects that are causes, in the order of their shares.
std::vector<const RankedEffect*> namedEffects(const Diagnosis& diagnosis);

// "front, rear: lateral carcass stiffness": where the numbers are, and what they mean. A path may be followed by
// " in " and the name of a recording.
std::string numberInWords(const std::vector<std::string>& paths);

// SI unit of a number; "-" for a pure number.
std::string unitOf(const std::string& path);

// "-32 ± 4 %", with this sign between the change and its standard deviation; empty where the nominal value is next to
// zero: the change is more than ten times as large, or its standard deviation larger.
std::string changeInPercent(const Estimate& estimate, std::string_view plus_minus);

// A number that moved within its tolerance.
struct MovedNumber {
    std::string name;  // its path, and " in " with the name of a recording if it concerns one; or that of a quantity
    NuisanceEstimate estimate;
};

// Numbers that moved by at least one standard deviation of their tolerance, or stand at an end of their range; those
// that moved most first.
std::vector<MovedNumber> movedNumbers(const std::map<std::string, NuisanceEstimate>& numbers);

}  // namespace tread::diagnose::answer
