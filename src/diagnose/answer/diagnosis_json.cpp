#include "diagnose/answer/diagnosis_json.h"

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

Json whereOf(const WhereItLies& where) {
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

Json numbersOf(const std::map<std::string, NuisanceEstimate>& numbers) {
    Json all = Json::object();
    for (const auto& [path, n] : numbers) all[path] = {{"value", n.value}, {"sd", n.sd}, {"z", n.z}};
    return all;
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
        {"effects", jsonOf(d.effects)},
        {"probability_of_nothing", d.probability_of_nothing},
        {"probability_of_unknown", d.probability_of_unknown},
        {"where", whereOf(d.where)},
        {"training", jsonOf(d.training)},
        {"held_out", jsonOf(d.held_out)},
        {"how_far",
         {{"training", levelsOf(d.how_far.training)},
          {"held_out", levelsOf(d.how_far.held_out)},
          {"closure", d.how_far.closure},
          {"closure_low", d.how_far.closure_low},
          {"closure_high", d.how_far.closure_high},
          {"in_sample", d.how_far.in_sample}}},
        {"nuisance", numbersOf(d.nuisance)},
        {"expected_evidence", d.expected_evidence},
        {"confusable", confusableJson(d.confusable)},
        {"next", listOf(d.next,
                        [](const NextDrive& n) {
                            return Json{{"scenario", n.scenario}, {"separates", separatesInWords(n)}, {"nats", n.nats}};
                        })},
        {"before", {{"nominal", d.before.nominal}, {"fitted", d.before.fitted}, {"moved", numbersOf(d.before.moved)}}},
        {"unexplained",
         {{"share", d.unexplained.share},
          {"generalised_force", d.unexplained.generalised_force},
          {"sizes", d.unexplained.sizes},
          {"beyond_ordinary", d.unexplained.beyond_ordinary},
          {"when", momentInWords(d.unexplained.when)},
          {"law",
           {{"follows", d.unexplained.law.follows},
            {"unit", d.unexplained.law.unit},
            {"coefficients", d.unexplained.law.coefficients},
            {"gain", d.unexplained.law.gain}}}}},
        {"credible_set", d.credible_set},
        {"baselines", jsonOf(d.baselines)},
        {"compared", d.compared},
        {"data_warnings", d.data_warnings},
        {"settings", jsonOf(kSettings)},
        {"seconds", d.seconds},
        {"simulations", d.simulations}};
}

}  // namespace tread::diagnose::answer
