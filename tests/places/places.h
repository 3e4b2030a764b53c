// Where the tests find the project's files and its program. Compiled into one file, so that every other object of the
// tests is the same wherever the project lies.
#pragma once

#include <string>

namespace tread {

// Absolute path of a file or folder of the project; path is relative to the project's root.
std::string sourceFile(const std::string& path = "");

// Absolute path of the built program.
std::string programFile();

}  // namespace tread
