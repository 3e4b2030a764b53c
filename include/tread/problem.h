// What is wrong with a file or an option, and the exception that carries every such fault at once.
#pragma once

#include "tread/cpp20.h"

#include <stdexcept>
#include <string>
#include <vector>

#include "tread/api.h"

namespace tread {

struct Problem {
    std::string file;  // or the option that was given
    int line = 0;      // from 1; 0 when the fault concerns the whole file
    int column = 0;    // from 1, counted in characters
    std::string path;  // of the field, "front.damper.bump"; empty when the fault concerns no field
    std::string text;  // what was found, what was expected, what to do

    bool operator==(const Problem&) const = default;
};

// "file:line:column: path: text", without the parts that the problem does not have.
TREAD_API std::string toText(const Problem& problem);

// Thrown once, with all that is wrong; what() has one line for each problem.
class TREAD_API LoadError : public std::runtime_error {
public:
    explicit LoadError(std::vector<Problem> problems);

    const std::vector<Problem>& problems() const noexcept { return problems_; }

private:
    std::vector<Problem> problems_;
};

}  // namespace tread
