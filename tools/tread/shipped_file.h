// The files that tread brings along: cars and manoeuvres.
#pragma once

#include <optional>
#include <string>

#include "commands.h"

namespace tread::program {

// The shipped folder of that name, "scenarios" or "vehicles": in this folder, or where the program, or the library that
// holds this function, is built or installed. Empty when there is none.
Path shippedFolder(const std::string& name);

// The shipped file of a name without extension: in the folder "vehicles", "compact" is vehicles/compact.yaml. Nothing
// when there is none. Files that name others resolve these names by it (store/named_file.h).
std::optional<Path> shippedFileNamed(const std::string& name, const std::string& folder);

// A file as a user names it: with the folder "vehicles", "compact" is the shipped vehicles/compact.yaml, unless there
// is a file of that name. Anything else stays as it is.
std::string shippedFile(const std::string& given, const std::string& folder);

}  // namespace tread::program
