#include "tread/problem.h"

#include <map>
#include <utility>

#include "base/text/problem_texts.h"

namespace tread {
namespace {

constexpr std::size_t kMostOfAKind = 20;

// The text without quoted words and numbers.
std::string kindOf(const Problem& problem) {
    std::string kind = problem.file + ": ";
    bool quoted = false;
    for (const char c : problem.text) {
        if (c == '"') quoted = !quoted;
        else if (!quoted && (c < '0' || c > '9')) kind += c;
    }
    return kind;
}

}  // namespace

std::string toText(const Problem& problem) {
    std::string text = problem.file;
    if (problem.line > 0) {
        text += ':';
        text += std::to_string(problem.line);
        text += ':';
        text += std::to_string(problem.column);
    }
    if (!text.empty()) text += ": ";
    if (!problem.path.empty()) text += problem.path + ": ";
    return text + problem.text;
}

std::string textOf(const std::vector<Problem>& problems) {
    std::map<std::string, std::size_t> counts;
    std::string texts;
    const auto add = [&](const std::string& line) { texts += (texts.empty() ? "" : "\n") + line; };
    for (const Problem& problem : problems) {
        if (++counts[kindOf(problem)] <= kMostOfAKind) add(toText(problem));
    }
    for (const auto& [kind, count] : counts) {
        if (count > kMostOfAKind)
            add("... and " + std::to_string(count - kMostOfAKind) + " more of this kind: " + kind);
    }
    return texts;
}

LoadError::LoadError(std::vector<Problem> problems)
    : std::runtime_error(textOf(problems)), problems_(std::move(problems)) {}

}  // namespace tread
