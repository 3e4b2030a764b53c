// The paths of all numbers that some subject has, whatever parts a car is made of.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/reference_table.h"

namespace tread::recording {

// The row of the number at a path (an element of a list stands for all of them); nullptr when no subject has one there.
const ReferenceRow* subjectNumber(std::string_view path);

// What is wrong with a path or a pattern with *, empty when some subject has a number there.
std::string pathFault(std::string_view path);

// Neither road nor wind nor instruments.
bool isOfTheCar(std::string_view path);

}  // namespace tread::recording
