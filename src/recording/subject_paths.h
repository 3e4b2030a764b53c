// Paths of all numbers that a subject can have, whatever parts its car is made of.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/fields/reference_table.h"

namespace tread::recording {

// Description of the number at a path; any index into a list is accepted. nullptr when no subject has such a number.
const ReferenceRow* subjectNumber(std::string_view path);

// Error text for a path, or for a pattern with *; empty when some subject has a number there.
std::string pathFault(std::string_view path);

// True for numbers of the car itself; false for those of road, wind and instruments.
bool isOfTheCar(std::string_view path);

}  // namespace tread::recording
