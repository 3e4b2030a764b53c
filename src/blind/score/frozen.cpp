#include "blind/score/frozen.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

namespace tread::blind::score {
namespace {

using answers::CaseAnswer;
using key::Program;

std::string inWords(const std::string& hash) {
    return hash.empty() ? "no program that is known" : "program " + hash.substr(0, 12);
}

std::string answerers(const std::set<std::string>& hashes) {
    if (hashes.empty()) return "there are no answers";
    std::vector<std::string> names;
    for (const std::string& hash : hashes) names.push_back(inWords(hash));
    return fmt::format("the answers were given by {}", fmt::join(names, " and "));
}

}  // namespace

Frozen frozen(const Program& key, const std::vector<CaseAnswer>& answers, const Program& own) {
    std::set<std::string> answered;
    for (const CaseAnswer& answer : answers) answered.insert(answer.program.diagnosis);
    Frozen result;
    result.frozen = !own.diagnosis.empty() && key.diagnosis == own.diagnosis && answered == std::set{own.diagnosis};
    result.scoring = !own.scoring.empty() && key.scoring == own.scoring;
    result.words = result.frozen
                       ? fmt::format("frozen: cases, answers and this score are of {}", inWords(own.diagnosis))
                       : fmt::format("NOT frozen: the key records {}, {}, this is {}", inWords(key.diagnosis),
                                     answerers(answered), inWords(own.diagnosis));
    if (!result.scoring) {
        result.words += fmt::format("; the examiner's scoring changed: the key records {}, this is {}",
                                    inWords(key.scoring), inWords(own.scoring));
    }
    return result;
}

}  // namespace tread::blind::score
