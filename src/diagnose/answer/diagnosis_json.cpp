#include "diagnose/answer/diagnosis_json.h"

#include <cmath>

#include "diagnose/answer/parts.h"
#include "diagnose/answer/words.h"
#include "diagnose/settings.h"
#include "store/described_json.h"

namespace tread::diagnose::answer {
namespace {

using Json = nlohmann::ordered_json;

Json levelsOf(const GapLevels& levels) {
    return {{"nominal", levels.nominal},
            {"calibrated", levels.calibrated},
            {"extended", levels.extended},
            {"floor", levels.floor}};
}

Json whereJson(const WhereItLies& where) {
    return {{"channels", where.channels},     {"recordings", where.recordings},
            {"phases", where.phases},         {"bands", where.bands},
            {"regimes", where.regimes},       {"generalised_force", where.generalised_force},
            {"axle_force", where.axle_force}, {"channels_of_recording", where.channels_of_recording}};
}

// JSON array of the values, each converted by `to_json`.
template <class T, class ToJson>
Json listOf(const std::vector<T>& values, ToJson to_json) {
    Json list = Json::array();
    for (const T& value : values) list.push_back(to_json(value));
    return list;
}

// The parts of a gap, as the report draws them.
Json partsJson(const Decomposition& gap) {
    return listOf(toldParts(gap), [](const ToldPart& part) {
        return Json{{"part", partInWords(part)}, {"share", part.share}};
    });
}

// Null where nothing can be closed, or no such drive is there.
Json closedJson(const Decomposition& gap) {
    const double closed = gap.gap > 0 ? closedShare(gap) : std::nan("");
    return std::isfinite(closed) ? Json(closed) : Json(nullptr);
}

// What no cause explains, and where it acts.
Json unexplainedOf(const Diagnosis& d) {
    const Unexplained& rest = d.unexplained;
    return {
        {"generalised_force", rest.generalised_force},
        {"channels", remainderOfChannels(d)},
        {"recordings", remainderOfRecordings(d)},
        {"instrument", rest.instrument},
        {"sizes", rest.sizes},
        {"beyond_ordinary", rest.beyond_ordinary},
        {"when", momentInWords(rest.when)},
        {"law",
         {{"follows", rest.law.follows},
          {"unit", rest.law.unit},
          {"coefficients", rest.law.coefficients},
          {"gain", rest.law.gain}}},
        {"vibration",
         {{"frequency", rest.vibration.frequency}, {"growth", rest.vibration.growth}, {"gain", rest.vibration.gain}}}};
}

}  // namespace

std::string_view nameOf(Verdict verdict) {
    return enumNames(verdict)[static_cast<std::size_t>(verdict)];
}

Json confusableJson(const std::vector<ConfusablePair>& pairs) {
    return listOf(pairs, [](const ConfusablePair& p) {
        return Json{
            {"a", p.a}, {"b", p.b}, {"cosine", p.cosine}, {"separation", p.separation}, {"manoeuvre", p.manoeuvre}};
    });
}

Json diagnosisJson(const Diagnosis& d) {
    return {
        {"answer", d.answer},
        {"verdict", nameOf(d.verdict)},
        {"causes", d.causes},
        {"alternatives", namesOnlyIn(d.alternatives, d.causes)},
        {"rivals", d.alternatives},
        {"effects", jsonOf(d.effects)},
        {"ruled_out", jsonOf(d.ruled_out)},
        {"probability_of_nothing", d.probability_of_nothing},
        {"probability_of_unknown", d.probability_of_unknown},
        {"where", whereJson(d.where)},
        {"training", jsonOf(d.training)},
        {"held_out", jsonOf(d.held_out)},
        {"parts", {{"training", partsJson(d.training)}, {"held_out", partsJson(d.held_out)}}},
        {"closed", {{"training", closedJson(d.training)}, {"held_out", closedJson(d.held_out)}}},
        {"how_far",
         {{"training", levelsOf(d.how_far.training)},
          {"held_out", levelsOf(d.how_far.held_out)},
          {"closure", d.how_far.closure},
          {"closure_low", d.how_far.closure_low},
          {"closure_high", d.how_far.closure_high},
          {"in_sample", d.how_far.in_sample}}},
        {"nuisance", jsonOf(d.nuisance)},
        {"expected_evidence", d.expected_evidence},
        {"confusable", confusableJson(d.confusable)},
        {"next", listOf(d.next,
                        [](const NextDrive& n) {
                            return Json{{"scenario", n.scenario}, {"separates", separatesInWords(n)}, {"nats", n.nats}};
                        })},
        {"before", jsonOf(d.before)},
        {"unexplained", unexplainedOf(d)},
        {"credible_set", d.credible_set},
        {"baselines", jsonOf(d.baselines)},
        {"compared", d.compared},
        {"cuts", jsonOf(d.cuts)},
        {"data_warnings", d.data_warnings},
        {"settings", jsonOf(kSettings)},
        {"seconds", d.seconds},
        {"simulations", d.simulations}};
}

}  // namespace tread::diagnose::answer
