// Manoeuvres of a blind case: half an hour of a test driver on a proving ground.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "scenario/scenario.h"

namespace tread::blind::drives {

// One manoeuvre. The gear is held throughout.
struct Drive {
    std::string name;
    Scenario scenario;
    int repeats = 1;        // recordings of it in a case
    bool hold_out = false;  // not used to find the cause, only to check the answer
};

// The small sets leave several causes possible.
enum class DriveSet { all, step_steers, coast_and_accelerate };
constexpr auto enumNames(DriveSet) {
    return std::array<std::string_view, 3>{"all", "step_steers", "coast_and_accelerate"};
}
// Throws LoadError that lists the valid names.
DriveSet driveSetNamed(std::string_view name);

// Eight training manoeuvres and two held out. The small sets keep two of the training manoeuvres and repeat none.
std::vector<Drive> caseDrives(DriveSet set = DriveSet::all);

}  // namespace tread::blind::drives
