// Groups of cases of which figures are given besides those of all: by what the drives show, by family and kind.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "blind/key.h"

namespace tread {

struct CaseGroup {
    std::string name;   // in the JSON
    std::string words;  // for people
    // Whether a case belongs to it when so much of what is wrong is meant.
    std::function<bool(const CaseKey&, const std::vector<std::string>& about)> holds;
};
const std::vector<CaseGroup>& caseGroups();

inline constexpr const char* kTestableAndApart = "testable_told_apart";
inline constexpr const char* kTestableAlike = "testable_alike";
inline constexpr const char* kOneTestable = "one_testable";

// Of each band, by the weakest of what is meant, or by the strongest of two or more.
std::vector<std::string> weakerBandGroups();
std::vector<std::string> strongerBandGroups();
std::vector<std::string> familyGroups();
std::vector<std::string> kindGroups();

}  // namespace tread
