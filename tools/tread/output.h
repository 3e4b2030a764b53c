// Where answers go: standard output, or a file that gets its name only when it is complete. A full disk and a folder
// that cannot be written throw FileError with one sentence.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "commands.h"

namespace tread::program {

void print(std::string_view text);
void printJson(const nlohmann::json& value);

void writeFile(const Path& path, std::string_view text);

}  // namespace tread::program
