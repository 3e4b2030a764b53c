// Where answers go: standard output, or a whole file (store/whole_file.h). A full disk and a folder that cannot be
// written throw FileError with one sentence.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "commands.h"
#include "store/whole_file.h"
#include "terminal.h"

namespace tread::program {

// What was asked for as data.
void print(std::string_view text);
void printJson(const nlohmann::json& value);

// An answer in words, in the colour of its tone; nothing with --quiet.
void say(std::string_view text, Tone tone = Tone::plain);

std::string jsonText(const nlohmann::json& value);

}  // namespace tread::program
