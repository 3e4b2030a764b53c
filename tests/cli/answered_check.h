// A blind check of one case whose answer is there already: nothing has to be diagnosed.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "blind/answers/answer.h"
#include "blind/key/key.h"
#include "diagnose/answer/diagnosis.h"

namespace tread {

struct AnsweredCheck {
    blind::key::SealedKey key;
    blind::answers::CaseAnswer answer;

    explicit AnsweredCheck(const std::string& cause = "drag_area") {
        key.generator = "another simulator";
        key.program = answer.program = blind::key::programHash();
        blind::key::CaseKey one;
        one.name = answer.name = "case_001";
        one.kind = blind::key::CaseKind::one;
        one.effects = {cause};
        one.shows[cause] = {.nats = 40, .rival = cause == "mass" ? "drag_area" : "mass", .separation = 30};
        key.cases = {one};
        answer.causes = {"drag_area"};
        answer.verdict = diagnose::answer::Verdict::explained;
        answer.effects = {{.name = "drag_area", .probability = 0.98, .parameters = {}}};
    }

    void write(const std::filesystem::path& cases, const std::filesystem::path& answers,
               const std::filesystem::path& key_file) const {
        std::filesystem::create_directories(cases / "case_001");
        std::filesystem::create_directories(answers / "case_001");
        std::ofstream(cases / "case_001/diagnosis.yaml") << "";
        std::ofstream(answers / "case_001/answer.json") << blind::answers::answerText(answer);
        std::ofstream(key_file) << blind::key::keyText(key);
    }
};

}  // namespace tread
