#include "blind/score/outcomes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "blind/score/bands.h"
#include "blind/score/claims.h"
#include "diagnose/answer/diagnosis_json.h"

namespace tread::blind::score {
namespace {

using answers::CaseAnswer;
using key::CaseKey;
using key::CaseKind;

std::vector<Band> bandsOf(const CaseKey& key) {
    std::vector<Band> bands;
    for (const std::string& name : faultsOf(key)) bands.push_back(bandOf(detectabilityOf(key, name).nats));
    if (key.kind == CaseKind::two) std::sort(bands.begin(), bands.end());
    return bands;
}

std::string joined(std::vector<std::string> names) {
    std::sort(names.begin(), names.end());
    return fmt::format("{}", fmt::join(names, " + "));
}

bool right(const CaseKey& key, const CaseAnswer& answer) {
    switch (key.kind) {
        case CaseKind::one:
        case CaseKind::small:
            return firstIsTrue(key, answer);
        case CaseKind::two:
            return namesExactly(key, answer);
        case CaseKind::none:
            return !alarms(answer);
        case CaseKind::outside:
            return callsUnknown(answer) && !blames(answer);
        case CaseKind::mixed:
            return firstIsTrue(key, answer) && callsUnknown(answer);
    }
    return false;
}

}  // namespace

Outcome outcomeOf(const CaseKey& key, const CaseAnswer& answer) {
    if (!answer.failure.empty()) return Outcome::no_answer;
    if (right(key, answer)) return Outcome::right;
    if (namesAnyTrue(key, answer) || (callsUnknown(answer) && !key.outsider.empty() && blames(answer)))
        return Outcome::partly;
    if (blames(answer)) return Outcome::wrong;
    return callsUnknown(answer) ? Outcome::unknown : Outcome::nothing;
}

int OutcomeRow::cases() const {
    return std::accumulate(counts.begin(), counts.end(), 0);
}

std::vector<OutcomeRow> outcomes(const std::vector<CaseKey>& keys, const std::vector<CaseAnswer>& answers) {
    std::map<std::pair<CaseKind, std::vector<Band>>, OutcomeRow> rows;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        OutcomeRow& row = rows[{keys[i].kind, bandsOf(keys[i])}];
        row.kind = keys[i].kind;
        row.bands = bandsInWords(keys[i]);
        ++row.counts[static_cast<std::size_t>(outcomeOf(keys[i], answers[i]))];
    }
    std::vector<OutcomeRow> list;
    for (const auto& [which, row] : rows) list.push_back(row);
    return list;
}

std::string bandsInWords(const CaseKey& key) {
    std::vector<std::string_view> words;
    for (const Band band : bandsOf(key)) words.push_back(nameOf(band));
    return fmt::format("{}", fmt::join(words, ", "));
}

Confusion confusion(const std::vector<CaseKey>& keys, const std::vector<CaseAnswer>& answers) {
    Confusion table;
    for (std::size_t i = 0; i < keys.size(); ++i) ++table[wordsOf(keys[i])][wordsOf(answers[i])];
    return table;
}

std::string wordsOf(const CaseKey& key) {
    std::vector<std::string> parts;
    if (!key.effects.empty()) parts.push_back(joined(key.effects));
    if (!key.outsider.empty()) parts.push_back("outside: " + key.outsider);
    if (parts.empty()) return "nothing";
    return (key.kind == CaseKind::small ? "small: " : "") + fmt::format("{}", fmt::join(parts, " + "));
}

std::string wordsOf(const CaseAnswer& answer) {
    if (!answer.failure.empty()) return "no answer";
    if (!blames(answer)) return std::string(nameOf(answer.verdict));
    std::set<std::string> either{joined(answer.causes)};
    for (const auto& alternative : answer.alternatives) either.insert(joined(alternative));
    return fmt::format("{}{}", fmt::join(either, " or "), callsUnknown(answer) ? " + unknown" : "");
}

}  // namespace tread::blind::score
