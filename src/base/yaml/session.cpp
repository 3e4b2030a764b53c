#include "base/yaml/session.h"

#include <algorithm>
#include <set>
#include <string>
#include <tuple>

namespace tread {

OpenFile::OpenFile(YamlSession& session, const std::filesystem::path& file) : session_(session) {
    std::error_code error;
    session_.open_files.push_back(std::filesystem::weakly_canonical(file, error));
}

void addFurther(std::vector<Problem>& problems, std::vector<Problem> further) {
    const std::size_t known = problems.size();
    const auto within = [](const std::string& inner, const std::string& outer) {
        return inner == outer || (inner.starts_with(outer) && inner[outer.size()] == '.');
    };
    for (Problem& problem : further) {
        const bool follows = std::any_of(
            problems.begin(), problems.begin() + static_cast<std::ptrdiff_t>(known), [&](const Problem& before) {
                return !before.path.empty() && (within(before.path, problem.path) || within(problem.path, before.path));
            });
        if (!follows) problems.push_back(std::move(problem));
    }
}

void throwIfAny(std::vector<Problem> problems) {
    if (problems.empty()) return;
    // Files in the order in which they came up, each from top to bottom; a file that is included twice is wrong once.
    std::vector<std::string> files;
    const auto rank = [&](const std::string& file) {
        return std::find(files.begin(), files.end(), file) - files.begin();
    };
    for (const Problem& problem : problems) {
        if (rank(problem.file) == std::ssize(files)) files.push_back(problem.file);
    }
    const auto key = [&](const Problem& problem) {
        return std::tuple(rank(problem.file), problem.line, problem.column);
    };
    std::stable_sort(problems.begin(), problems.end(),
                     [&](const Problem& a, const Problem& b) { return key(a) < key(b); });
    std::set<std::tuple<std::string, int, int, std::string>> seen;
    std::erase_if(problems, [&](const Problem& problem) {
        return problem.line > 0 && !seen.emplace(problem.file, problem.line, problem.column, problem.text).second;
    });
    throw LoadError(std::move(problems));
}

}  // namespace tread
