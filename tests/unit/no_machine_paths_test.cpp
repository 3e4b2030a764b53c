// The project must build wherever it lies: no file of it names a folder of the machine on which it was written.
#include <gtest/gtest.h>

#include <array>
#include <cctype>
#include <string_view>

#include "places/places.h"
#include "shared/source_files.h"

namespace tread::no_machine_paths_test {
namespace {

// Written in two halves, so that this file does not contain them.
const std::array<std::string, 4> kFolders{
    "/wo"
    "rk/",
    "/tmp/"
    "wt",
    "/ro"
    "ot/",
    "/ho"
    "me/"};

// "${build}/x/" and "a/x/" are not absolute; "-I/x/" is.
bool isAbsolute(const std::string& text, std::size_t slash) {
    const auto belongsToName = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) ||
               std::string_view("_-.})").find(c) != std::string_view::npos;
    };
    std::size_t begin = slash;
    while (begin > 0 && belongsToName(text[begin - 1])) --begin;
    return begin == slash || text[begin] == '-';
}

// Line (from 1) and text of the first absolute path below one of the folders; 0 when there is none.
std::pair<long, std::string> machinePath(const std::string& text) {
    for (const std::string& folder : kFolders) {
        for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder, at + 1)) {
            if (!isAbsolute(text, at)) continue;
            const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
            return {line, text.substr(at, text.find_first_of("\n\"' ", at) - at)};
        }
    }
    return {};
}

TEST(MachinePaths, AreInNoFile) {
    const auto files = sourceFiles(sourceFile(), [](const auto&) { return true; });
    EXPECT_GT(files.size(), 150u) << "the search must find the project";
    for (const SourceFile& file : files) {
        const auto [line, path] = machinePath(file.text);
        EXPECT_EQ(line, 0) << file.name.string() << ":" << line << ": names " << path;
    }
}

TEST(MachinePaths, AreFound) {
    for (const std::string& folder : kFolders) {
        EXPECT_EQ(machinePath("a\nb \"" + folder + "x\"").first, 2) << folder;
        EXPECT_EQ(machinePath(folder).first, 1) << folder;
        EXPECT_EQ(machinePath("\n\n-I" + folder).first, 3) << folder;
    }
    EXPECT_EQ(machinePath("${build}" + kFolders[0] + "x, frame" + kFolders[0].substr(1)).first, 0);
}

}  // namespace
}  // namespace tread::no_machine_paths_test
