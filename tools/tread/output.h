// Where answers go: standard output, or a file that gets its name only when it is complete. A full disk and a folder
// that cannot be written throw FileError with one sentence.
#pragma once

#include <cstdio>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "commands.h"
#include "terminal.h"

namespace tread::program {

// A file in the making: `<name>.part`, removed when the writer gives up, until finish() gives it its name. A device or
// a pipe is written to directly; a link stays, and the file that it points to is replaced.
class OutputFile {
public:
    explicit OutputFile(const Path& path);  // an empty path is standard output
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void write(std::string_view text);
    void finish();

private:
    [[noreturn]] void fail(int error) const;
    void removePart() const;

    Path name_;    // as given
    Path target_;  // without links
    Path part_;    // empty: written to directly
    std::FILE* file_ = nullptr;
};

void writeFile(const Path& path, std::string_view text);

// What was asked for as data.
void print(std::string_view text);
void printJson(const nlohmann::json& value);

// An answer in words, in the colour of its tone; nothing with --quiet.
void say(std::string_view text, Tone tone = Tone::plain);

std::string jsonText(const nlohmann::json& value);

}  // namespace tread::program
