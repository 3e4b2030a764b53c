// Faults of an input file: where they are and what was expected. A reader collects all it finds and throws once.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tread {

struct Problem {
    std::string file;
    int line = 0;    // from 1; 0: the file as a whole
    int column = 0;  // from 1; 0: the line as a whole
    std::string path;
    std::string text;
};

class LoadError : public std::runtime_error {
public:
    explicit LoadError(std::vector<Problem> found) : std::runtime_error(listed(found)), problems(std::move(found)) {}

    std::vector<Problem> problems;

private:
    // One `file:line:column: path: text` per line; parts that do not apply are left out.
    static std::string listed(const std::vector<Problem>& problems) {
        std::string out;
        for (const Problem& problem : problems) {
            if (!out.empty()) out += '\n';
            out += problem.file;
            if (problem.line > 0) out += ':' + std::to_string(problem.line);
            if (problem.column > 0) out += ':' + std::to_string(problem.column);
            if (!problem.path.empty()) out += ": " + problem.path;
            out += ": " + problem.text;
        }
        return out;
    }
};

}  // namespace tread
