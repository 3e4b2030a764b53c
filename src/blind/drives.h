// The drives of a blind case: what a test driver would do in half an hour on a proving ground.
#pragma once

#include <string>
#include <vector>

#include "scenario/scenario.h"

namespace tread {

struct Drive {
    std::string name;
    Scenario scenario;
    int repeats = 1;
    bool hold_out = false;
};

// Eight manoeuvres to find the cause and two to judge the answer. Each holds its gear from beginning to end.
std::vector<Drive> blindDrives();

}  // namespace tread
