#include "tread/problem.h"

#include <utility>

namespace tread {
namespace {

std::string allTexts(const std::vector<Problem>& problems) {
    std::string texts;
    for (const Problem& problem : problems) {
        if (!texts.empty()) texts += '\n';
        texts += toText(problem);
    }
    return texts;
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

LoadError::LoadError(std::vector<Problem> problems)
    : std::runtime_error(allTexts(problems)), problems_(std::move(problems)) {}

}  // namespace tread
