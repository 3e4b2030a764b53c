#include "blind/answer.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "blind/gauges.h"
#include "diagnose/answer/diagnosis.h"
#include "diagnose/answer/diagnosis_json.h"
#include "diagnose/settings.h"
#include "log/resample.h"
#include "tread/problem.h"

namespace tread {
namespace {

using diagnose::kSettings;

using diagnose::answer::baselinesJson;
using diagnose::answer::ConfusablePair;
using diagnose::answer::Diagnosis;
using diagnose::answer::effectJson;
using diagnose::answer::Overlay;
using diagnose::answer::RankedEffect;
using diagnose::answer::Verdict;
using diagnose::answer::verdictNamed;

using Json = nlohmann::json;

Json jsonOf(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

double numberOf(const Json& json) {
    return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

RankedEffect effectOf(const Json& json) {
    RankedEffect effect{json.at("name"), numberOf(json.at("probability")), numberOf(json.at("log_evidence")), {}};
    for (const auto& [path, e] : json.at("parameters").items()) {
        effect.parameters[path] = {numberOf(e.at("value")), numberOf(e.at("sd")),      numberOf(e.at("low")),
                                   numberOf(e.at("high")),  numberOf(e.at("neutral")), e.at("at_bound")};
    }
    return effect;
}

Verdict verdictOf(const std::string& word) {
    if (const auto verdict = verdictNamed(word)) return *verdict;
    throw LoadError({{"", 0, 0, "verdict", "found \"" + word + "\", expected a verdict"}});
}

// Sum of the squared differences of the measured channels, in units of their noise.
double squaredGap(const Log& log, const Log& clean) {
    double sum = 0;
    for (const Gauge& gauge : gauges()) {
        const Channel *channel = log.find(gauge.channel), *real = clean.find(gauge.channel);
        if (!channel || !real || gauge.channel.starts_with("driver.")) continue;
        for (std::size_t i = 0; i < log.samples(); ++i) {
            const double gap = channel->values[i] -
                               valueAt(clean.channels.front().values, real->values, log.channels.front().values[i]);
            if (std::isfinite(gap)) sum += (gap / gauge.noise) * (gap / gauge.noise);
        }
    }
    return sum;
}

}  // namespace

CaseAnswer answerOf(const std::string& name, const Diagnosis& d) {
    CaseAnswer answer;
    answer.name = name;
    answer.verdict = d.verdict;
    answer.causes = d.causes;
    answer.alternatives = d.alternatives;
    answer.credible_set = d.credible_set;
    answer.effects = d.effects;
    answer.probability_of_nothing = d.probability_of_nothing;
    answer.probability_of_unknown = d.probability_of_unknown;
    answer.testable = d.expected_evidence;
    std::set<std::string> confusable;
    for (const ConfusablePair& pair : d.confusable) {
        for (const std::string& effect : {pair.a, pair.b})
            if (d.expected_evidence.at(effect) * (1 - pair.cosine * pair.cosine) < kSettings.separable)
                confusable.insert(effect);
    }
    answer.confusable.assign(confusable.begin(), confusable.end());
    answer.generalised_force = d.unexplained.generalised_force;
    answer.baselines = d.baselines;
    answer.closure = d.how_far.closure;
    answer.closure_low = d.how_far.closure_low;
    answer.closure_high = d.how_far.closure_high;
    answer.seconds = d.seconds;
    answer.simulations = d.simulations;
    return answer;
}

double obtainedClosure(const std::vector<Overlay>& overlays, const std::map<std::string, Log>& clean) {
    double nominal = 0, extended = 0;
    for (const Overlay& overlay : overlays) {
        const auto found = clean.find(overlay.recording);
        if (!overlay.hold_out || found == clean.end()) continue;
        nominal += squaredGap(overlay.nominal, found->second);
        extended += squaredGap(overlay.extended, found->second);
    }
    return nominal > 0 ? 1 - extended / nominal : std::numeric_limits<double>::quiet_NaN();
}

std::string answerText(const CaseAnswer& a) {
    Json effects = Json::array(), testable = Json::object();
    for (const RankedEffect& effect : a.effects) effects.push_back(Json(effectJson(effect)));
    for (const auto& [name, nats] : a.testable) testable[name] = jsonOf(nats);
    const Json json{{"name", a.name},
                    {"verdict", nameOf(a.verdict)},
                    {"causes", a.causes},
                    {"alternatives", a.alternatives},
                    {"credible_set", a.credible_set},
                    {"effects", effects},
                    {"probability_of_nothing", jsonOf(a.probability_of_nothing)},
                    {"probability_of_unknown", jsonOf(a.probability_of_unknown)},
                    {"testable", testable},
                    {"confusable", a.confusable},
                    {"generalised_force", a.generalised_force},
                    {"baselines", Json(baselinesJson(a.baselines))},
                    {"closure", jsonOf(a.closure)},
                    {"closure_low", jsonOf(a.closure_low)},
                    {"closure_high", jsonOf(a.closure_high)},
                    {"closure_obtained", jsonOf(a.closure_obtained)},
                    {"seconds", jsonOf(a.seconds)},
                    {"simulations", a.simulations},
                    {"failure", a.failure}};
    return json.dump(2) + "\n";
}

CaseAnswer parseAnswer(std::string_view text, const std::string& file) {
    try {
        const Json json = Json::parse(text);
        CaseAnswer a;
        a.name = json.at("name");
        a.verdict = verdictOf(json.at("verdict"));
        a.causes = json.at("causes");
        a.alternatives = json.at("alternatives");
        a.credible_set = json.at("credible_set");
        for (const Json& effect : json.at("effects")) a.effects.push_back(effectOf(effect));
        a.probability_of_nothing = numberOf(json.at("probability_of_nothing"));
        a.probability_of_unknown = numberOf(json.at("probability_of_unknown"));
        for (const auto& [name, nats] : json.at("testable").items()) a.testable[name] = numberOf(nats);
        a.confusable = json.at("confusable");
        a.generalised_force = json.at("generalised_force");
        if (const auto simpler = json.find("baselines"); simpler != json.end())  // older answers have none
            a.baselines = {simpler->at("largest_reduction"), simpler->at("bic")};
        a.closure = numberOf(json.at("closure"));
        a.closure_low = numberOf(json.at("closure_low"));
        a.closure_high = numberOf(json.at("closure_high"));
        a.closure_obtained = numberOf(json.at("closure_obtained"));
        a.seconds = numberOf(json.at("seconds"));
        a.simulations = json.at("simulations");
        a.failure = json.at("failure");
        return a;
    } catch (const Json::exception& error) {
        throw LoadError({{file, 0, 0, "",
                          "found no answer to a blind case, expected one that `tread blind score` wrote (delete it to "
                          "have the case diagnosed again): " +
                              std::string(error.what())}});
    }
}

}  // namespace tread
