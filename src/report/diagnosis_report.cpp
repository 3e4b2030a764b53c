#include "report/diagnosis_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "diagnose/answer/diagnosis.h"
#include "diagnose/answer/diagnosis_text.h"
#include "diagnose/answer/words.h"
#include "report/diagnosis_charts.h"
#include "report/diagnosis_tables.h"
#include "report/html.h"
#include "report/text.h"

namespace tread {
namespace {

using diagnose::answer::momentInWords;
using diagnose::answer::separatesInWords;

using diagnose::answer::Diagnosis;
using diagnose::answer::eachTogether;
using diagnose::answer::GapLevels;
using diagnose::answer::lawInWords;
using diagnose::answer::RankedEffect;
using diagnose::answer::Shares;
using diagnose::answer::Unexplained;
using diagnose::answer::Verdict;

std::string badge(Verdict verdict) {
    switch (verdict) {
        case Verdict::explained:
            return "explained";
        case Verdict::nothing:
            return "nothing found";
        case Verdict::ambiguous:
            return "ambiguous";
        case Verdict::unknown:
            return "cause unknown";
        case Verdict::not_testable:
            return "not testable";
        case Verdict::partly_explained:
            return "partly explained";
    }
    return {};
}

std::string percentNumber(double share) {
    return fmt::format("{:.0f}", 100 * share);
}

// The largest share, such as "yaw_rate 62 %".
std::string largest(const Shares& shares) {
    const auto most = std::max_element(shares.begin(), shares.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == shares.end() ? "" : fmt::format("{} {} %", shownName(most->first), percentNumber(most->second));
}

std::string whereInWords(const diagnose::answer::WhereItLies& gap) {
    const std::string force = "force: " + largest(gap.generalised_force);
    if (gap.channels.empty()) return "no single channel exceeds the usual disturbances; " + force;
    return fmt::format("{} of the gap; {}; band: {}; when: {}", largest(gap.channels), force, largest(gap.bands),
                       largest(gap.phases));
}

void addHead(HtmlPage& page, const DiagnosisReport& content) {
    const Diagnosis& d = content.diagnosis;
    const bool good = d.verdict == Verdict::explained || d.verdict == Verdict::nothing;
    page.answer(d.answer + ".", badge(d.verdict), good);
    const GapLevels& judged = d.how_far.in_sample ? d.how_far.training : d.how_far.held_out;
    std::vector<Card> cards;
    for (const RankedEffect& effect : d.effects) {
        if (std::find(d.causes.begin(), d.causes.end(), effect.name) != d.causes.end())
            cards.push_back({"probability of " + shownName(effect.name),
                             effect.probability > 0.9995 ? "> 99.9" : formatNumber(100 * effect.probability, 3), "%"});
    }
    const std::string where = d.how_far.in_sample ? "in the same drives" : "in held-out drives";
    cards.push_back({"gap " + where + ", in noise units: nominal", formatNumber(judged.nominal, 3), ""});
    cards.push_back({"with the tolerances fitted", formatNumber(judged.calibrated, 3), ""});
    cards.push_back({d.causes.empty() ? "noise floor" : "with the effect added (noise floor: 1)",
                     formatNumber(d.causes.empty() ? judged.floor : judged.extended, 3), ""});
    if (d.verdict == Verdict::unknown)
        cards.push_back({"probability of an unknown cause", formatNumber(100 * d.probability_of_unknown, 3), "%"});
    cards.push_back(
        {"of the closable gap is closed", percentNumber(d.how_far.closure),
         fmt::format("% [{}, {}]", percentNumber(d.how_far.closure_low), percentNumber(d.how_far.closure_high))});
    page.cards(cards);
    page.keyValues(
        {{"Where", whereInWords(d.where)},
         {"Could also be", fmt::format("{}", fmt::join(shownNames(eachTogether(d.alternatives)), ", "))},
         {"90 % credible set",
          std::is_permutation(d.causes.begin(), d.causes.end(), d.credible_set.begin(), d.credible_set.end())
              ? ""
              : fmt::format("{}", fmt::join(shownNames(d.credible_set), ", "))},
         {"Drive next", d.next.empty() ? "" : d.next.front().scenario + ": " + separatesInWords(d.next.front())},
         {"Car", content.vehicle},
         {"Compared with", d.compared ? "the same drives before the car was changed: the gap of the model to them is "
                                        "subtracted from the measurements"
                                      : ""},
         {"Made by", fmt::format("tread {}, {} simulations in {:.0f} s", content.version, d.simulations, d.seconds)}});
    page.warnings(d.data_warnings);
}

void addUnexplained(HtmlPage& page, const Unexplained& rest) {
    if (rest.share < 0.005) return;
    page.text(fmt::format("The best answer leaves {} % of the gap{}{}.", percentNumber(rest.share),
                          rest.generalised_force.empty() ? "" : "; missing force: " + rest.generalised_force,
                          rest.when.recording.empty() ? "" : ", " + momentInWords(rest.when)));
    const std::string law = lawInWords(rest.law);
    if (!law.empty() && rest.law.generalised_force.empty()) page.text("In addition to the best answer, " + law + ".");
}

}  // namespace

std::string diagnosisReport(const DiagnosisReport& content) {
    const Diagnosis& d = content.diagnosis;
    HtmlPage page(content.title);
    addHead(page, content);

    page.section("Which effect");
    addEffects(page, d);

    page.section("How far the gap shrinks");
    page.text(
        "Root mean square of measured minus simulated, in units of the noise; a perfect model leaves 1. "
        "Nominal: the car as described by its file. Calibrated: its numbers fitted within their tolerances. With the "
        "effect: the cause added. The effect is credited only with its improvement over the calibrated car.");
    addLevels(page, d.how_far);
    addUnexplained(page, d.unexplained);

    page.section("Where it lies");
    addWhere(page, d.where);

    if (!d.overlays.empty()) {
        page.section("Measured and simulated");
        addOverlays(page, d);
    }

    page.section("Limits of these drives");
    addLimits(page, d);

    page.section("The car within its tolerances");
    addNuisances(page, d);

    page.section("Priors and thresholds");
    addSettings(page);
    return page.finish();
}

}  // namespace tread
