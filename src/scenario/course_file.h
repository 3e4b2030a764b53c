// The centreline of a course from its file.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "scenario/scenario.h"
#include "tread/problem.h"

namespace tread {

// The points of a text: CSV with a header of `name [unit]`, columns x and y and, if wanted, width, bank and speed. All
// faults with their place; then the points are of no use.
std::vector<LinePoint> parseCourse(std::string_view text, const std::string& file, bool closed,
                                   std::vector<Problem>& problems);

// The scenario with the points of the file that its course names, in place of the name. Throws LoadError with every
// fault, also when a driver follows a speed that the course does not have.
Scenario withCourseRead(Scenario scenario, const std::filesystem::path& scenario_file);

}  // namespace tread
