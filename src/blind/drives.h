// The drives of a blind case: what a test driver would do in half an hour on a proving ground.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "scenario/scenario.h"

namespace tread {

struct Drive {
    std::string name;
    Scenario scenario;
    int repeats = 1;
    bool hold_out = false;
};

// All, or so few that several causes must remain possible.
enum class DriveSet { all, step_steers, coast_and_accelerate };
constexpr auto enumNames(DriveSet) {
    return std::array<std::string_view, 3>{"all", "step_steers", "coast_and_accelerate"};
}
// Throws LoadError with the names that there are.
DriveSet driveSet(std::string_view name);

// Eight manoeuvres to find the cause and two to judge the answer; of a small set only two to find it, driven once. Each
// holds its gear from beginning to end.
std::vector<Drive> blindDrives(DriveSet set = DriveSet::all);

}  // namespace tread
