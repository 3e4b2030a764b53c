// Answers as JSON, and back.
#include "blind/answers/answer.h"
#include "store/described_json.h"
#include "tread/problem.h"

namespace tread::blind::answers {

std::string answerText(const CaseAnswer& answer) {
    return jsonOf(answer).dump(2) + "\n";
}

CaseAnswer parseAnswer(std::string_view text, const std::string& file) {
    try {
        CaseAnswer answer;
        readJson(answer, nlohmann::ordered_json::parse(text));
        return answer;
    } catch (const std::exception& error) {
        throw LoadError({{file, 0, 0, "",
                          "found no answer to a blind case, expected one that `tread blind score` wrote (delete it to "
                          "have the case diagnosed again): " +
                              std::string(error.what())}});
    }
}

}  // namespace tread::blind::answers
