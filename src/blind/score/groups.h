// Groups of cases with figures of their own: by detectability, family of outsiders and kind.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "blind/key/key.h"

namespace tread::blind::score {

struct CaseGroup {
    std::string name;   // key in the JSON
    std::string words;  // for people
    // Whether a case belongs to the group when the question is about the faults `about`.
    std::function<bool(const key::CaseKey&, const std::vector<std::string>& about)> holds;
};
const std::vector<CaseGroup>& caseGroups();

inline constexpr const char* kTestableAndApart = "testable_told_apart";
inline constexpr const char* kTestableAlike = "testable_alike";
inline constexpr const char* kOneTestable = "one_testable";

// One group per band: by the least detectable of the faults in question, or by the most detectable of two or more.
std::vector<std::string> weakerBandGroups();
std::vector<std::string> strongerBandGroups();
std::vector<std::string> familyGroups();
std::vector<std::string> kindGroups();

}  // namespace tread::blind::score
