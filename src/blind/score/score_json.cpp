#include "blind/score/groups.h"
#include "blind/score/score.h"
#include "store/described_json.h"

namespace tread::blind::score {
namespace {

using Json = nlohmann::ordered_json;

Json countJson(const Count& count) {
    const Interval interval = count.interval();
    return {{"hits", count.hits},
            {"of", count.of},
            {"share", count.of > 0 ? Json(count.share()) : Json(nullptr)},
            {"low", interval.low},
            {"high", interval.high}};
}

Json figureJson(const Figure& figure) {
    Json json{{"words", figure.words}};
    json.update(countJson(figure));
    if (figure.target > 0) json[figure.at_least ? "at_least" : "at_most"] = figure.target;
    if (figure.largest_reduction.of > 0) json["largest_reduction"] = countJson(figure.largest_reduction);
    if (figure.bic.of > 0) json["bic"] = countJson(figure.bic);
    return json;
}

// Figures of a group, without those that have no case; of all cases, every figure.
Json figuresOf(const BlindScore& score, const std::string& group) {
    Json json = Json::object();
    for (const Figure& figure : score.figures)
        if (figure.group == group && (group.empty() || figure.of > 0)) json[figure.name] = figureJson(figure);
    return json;
}

Json outcomeJson(const OutcomeRow& row) {
    Json json{{"kind", enumNames(row.kind)[static_cast<std::size_t>(row.kind)]}, {"nats", row.bands}};
    json["cases"] = row.cases();
    for (std::size_t i = 0; i < row.counts.size(); ++i) json[std::string(enumNames(Outcome{})[i])] = row.counts[i];
    return json;
}

Json orNull(const std::optional<double>& value) {
    return value ? jsonOf(*value) : Json(nullptr);
}

}  // namespace

std::string scoreJson(const BlindScore& score) {
    Json groups_json = Json::object(), bins = Json::array(), rows = Json::array(), errors = Json::array();
    for (const CaseGroup& group : caseGroups()) {
        Json figures = figuresOf(score, group.name);
        if (!figures.empty()) groups_json[group.name] = {{"words", group.words}, {"figures", std::move(figures)}};
    }
    for (const ReliabilityBin& bin : score.reliability)
        bins.push_back(
            {{"from", bin.from}, {"to", bin.to}, {"claims", bin.claims}, {"right", bin.right}, {"stated", bin.stated}});
    for (const OutcomeRow& row : score.outcomes) rows.push_back(outcomeJson(row));
    for (const EstimateError& error : score.number_errors)
        errors.push_back({{"in_sd", jsonOf(error.in_sd)}, {"relative", jsonOf(error.relative)}});
    const Json json{{"cases", score.cases},
                    {"failed", score.failed},
                    {"frozen", score.frozen.frozen},
                    {"same_scoring", score.frozen.scoring},
                    {"frozen_in_words", score.frozen.words},
                    {"references", score.references},
                    {"figures", figuresOf(score, "")},
                    {"groups", groups_json},
                    {"outcomes", rows},
                    {"reliability", bins},
                    {"calibration_error", score.calibration_error},
                    {"calibration_error_by_chance", score.calibration_error_by_chance},
                    {"number_errors", errors},
                    {"median_relative_error", orNull(score.median_relative_error)},
                    {"median_closure", orNull(score.median_closure)},
                    {"mean_credible_set", orNull(score.mean_credible_set)},
                    {"median_credible_set", orNull(score.median_credible_set)},
                    {"median_seconds", score.median_seconds},
                    {"longest_seconds", score.longest_seconds},
                    {"confusion", score.confusion}};
    return json.dump(2) + "\n";
}

}  // namespace tread::blind::score
