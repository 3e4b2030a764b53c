#include "blind/answers/answer.h"

#include <cmath>

#include "blind/world/instruments.h"
#include "diagnose/answer/diagnosis.h"
#include "log/resample.h"

namespace tread::blind::answers {
namespace {

using diagnose::answer::Diagnosis;
using diagnose::answer::Overlay;
using key::programHash;
using world::InstrumentSheet;
using world::instrumentSheets;

// Sum of squared differences of all channels but the driver's inputs, in units of their noise.
double squaredGap(const Log& log, const Log& clean) {
    double sum = 0;
    for (const InstrumentSheet& sheet : instrumentSheets()) {
        const Channel *channel = log.find(sheet.channel), *real = clean.find(sheet.channel);
        if (!channel || !real || sheet.channel.starts_with("driver.")) continue;
        for (std::size_t i = 0; i < log.samples(); ++i) {
            const double gap = channel->values[i] -
                               valueAt(clean.channels.front().values, real->values, log.channels.front().values[i]);
            if (std::isfinite(gap)) sum += (gap / sheet.noise) * (gap / sheet.noise);
        }
    }
    return sum;
}

}  // namespace

CaseAnswer answerOf(const std::string& name, const Diagnosis& d) {
    CaseAnswer answer;
    answer.name = name;
    answer.program = programHash();
    answer.compared = d.compared;
    answer.verdict = d.verdict;
    answer.causes = d.causes;
    answer.alternatives = d.alternatives;
    answer.credible_set = d.credible_set;
    answer.effects = d.effects;
    answer.probability_of_nothing = d.probability_of_nothing;
    answer.probability_of_unknown = d.probability_of_unknown;
    answer.expected_evidence = d.expected_evidence;
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

}  // namespace tread::blind::answers
