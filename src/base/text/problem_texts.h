// Many problems as a text that people read.
#pragma once

#include <string>
#include <vector>

#include "tread/problem.h"

namespace tread {

// One line for each problem. Of those that differ only in quoted names and numbers, 20; a line says how many more there
// are.
std::string textOf(const std::vector<Problem>& problems);

}  // namespace tread
