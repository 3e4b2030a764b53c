// What the fuzzer and the tests do with a text as the answer to a blind case.
#pragma once

#include <string_view>

#include "blind/answers/answer.h"
#include "fuzz/demand.h"
#include "tread/problem.h"

namespace tread::fuzz {

// True when the text was taken.
inline bool readHostileAnswer(std::string_view text) {
    try {
        const std::string written = blind::answers::answerText(blind::answers::parseAnswer(text, "answer.json"));
        demand(blind::answers::answerText(blind::answers::parseAnswer(written, "written.json")) == written);
        return true;
    } catch (const LoadError& error) {
        demand(!error.problems().empty());
        for (const Problem& problem : error.problems()) demand(problem.file == "answer.json" && !problem.text.empty());
        return false;
    }
}

}  // namespace tread::fuzz
