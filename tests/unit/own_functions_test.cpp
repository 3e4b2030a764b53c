// What computes a run takes elementary functions from base/math/elementary.h and base/math/power.h, and sums in an
// order of its own: those of the C library and the vectorised products of Eigen differ between machines.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <regex>
#include <string>

#include "places/places.h"
#include "shared/source_files.h"

namespace tread::own_functions_test {
namespace {

// Folders of src that compute a run.
const std::array<std::string, 8> kFolders{"base", "road", "tyre", "vehicle", "host", "bullet", "scenario", "run"};

// Files that only judge numbers of a file or put them into words.
const std::array<std::string, 3> kExceptions{"src/base/fields/implausible.cpp", "src/base/units/slip.cpp",
                                             "src/vehicle/relations.cpp"};

// Functions of the C library that are not exact; distributions, which each library has of its own; turns and inverses
// of Eigen.
const std::regex kForeign(
    R"(\bstd::(a?sinh?|a?cosh?|a?tanh?|atan2|exp2?|expm1|log|log2|log10|log1p|pow|cbrt|hypot|polar|[lt]gamma|erfc?)\()"
    R"(|\bstd::(cyl|sph)_|\bstd::\w+_distribution|\bAngleAxis|\.inverse\(\)|\bEigen::FFT|\bslerp\()"
    R"(|\busing std::(sin|cos|tan|exp|log|pow)\b)");

bool computesRuns(const std::filesystem::path& name) {
    if (name.extension() != ".h" && name.extension() != ".cpp") return false;
    const std::string top = name.begin()->string();
    if (top == "include") return true;
    if (top != "src" || std::ranges::count(kExceptions, name.string()) > 0) return false;
    return std::ranges::count(kFolders, std::next(name.begin())->string()) > 0;
}

TEST(OwnFunctions, AreUsedByAllThatComputesRuns) {
    const std::vector<SourceFile> files = sourceFiles(sourceFile(), computesRuns);
    EXPECT_GT(files.size(), 150u) << "the search must find the project";
    for (const SourceFile& file : files) {
        std::smatch found;
        if (!std::regex_search(file.text, found, kForeign)) continue;
        const auto line = 1 + std::count(file.text.begin(), found[0].first, '\n');
        ADD_FAILURE()
            << file.name.string() << ':' << line << ": found " << found.str()
            << ", which differs between machines; use base/math/elementary.h, base/math/power.h, base/math/turn.h or "
               "vehicle/vectors.h";
    }
}

TEST(OwnFunctions, OthersAreFound) {
    for (const char* text : {"x = std::sin(y)", "std::atan2(", "std::pow(", "std::hypot(", "std::tanh(", "std::exp(",
                             "std::normal_distribution<double> n;", "Eigen::AngleAxisd(", "mass.inverse()"}) {
        EXPECT_TRUE(std::regex_search(text, kForeign)) << text;
    }
    for (const char* text : {"sine(x)", "std::sqrt(x)", "std::remainder(x, y)", "std::round(x)", "std::expected("})
        EXPECT_FALSE(std::regex_search(text, kForeign)) << text;
}

}  // namespace
}  // namespace tread::own_functions_test
