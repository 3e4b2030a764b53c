#include "report/diagnosis_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "diagnose/answer/diagnosis.h"
#include "diagnose/answer/words.h"
#include "report/diagnosis_charts.h"
#include "report/diagnosis_tables.h"
#include "report/html.h"

namespace tread {
namespace {

using diagnose::answer::Diagnosis;
using diagnose::answer::isAnswered;
using diagnose::answer::isUncertain;
using DiagnosisVerdict = diagnose::answer::Verdict;

std::string badge(const Diagnosis& d) {
    switch (d.verdict) {
        case DiagnosisVerdict::explained:
            return "explained";
        case DiagnosisVerdict::nothing:
            return isUncertain(d) ? "nothing certain" : "nothing found";
        case DiagnosisVerdict::ambiguous:
            return "ambiguous";
        case DiagnosisVerdict::unknown:
            return d.causes.empty() ? "cause unknown" : "cause mostly unknown";
        case DiagnosisVerdict::not_testable:
            return "not testable";
        case DiagnosisVerdict::partly_explained:
            return "partly explained";
    }
    return {};
}

std::string countOfWarnings(std::size_t count) {
    if (count == 0) return {};
    return fmt::format("{} {} about the data, listed below under What was left out", count,
                       count == 1 ? "warning" : "warnings");
}

void addHead(HtmlPage& page, const DiagnosisReport& content) {
    const Diagnosis& d = content.diagnosis;
    page.answer(d.answer + ".", badge(d), isAnswered(d) && !isUncertain(d));
    page.keyValues(
        {{"Car", content.vehicle},
         {"Compared with", d.compared ? "the same drives before the car was changed: the gap of the model to them is "
                                        "subtracted from the measurements"
                                      : ""},
         {"Drive next", d.next.empty() ? "" : d.next.front().scenario + ": " + separatesInWords(d.next.front())},
         {"Warnings", countOfWarnings(d.data_warnings.size())},
         {"Made by", fmt::format("tread {}, {} simulations in {:.0f} s", content.version, d.simulations, d.seconds)}});
}

}  // namespace

std::string diagnosisReport(const DiagnosisReport& content) {
    const Diagnosis& d = content.diagnosis;
    HtmlPage page(content.title, d.answer);
    addHead(page, content);

    if (d.training.gap > 0) {
        page.section("Parts of the gap");
        addParts(page, d);
    }
    if (!d.causes.empty()) {
        page.section("What the causes mean for the car");
        addChanges(page, d);
    }
    page.section("The car within its tolerances");
    addMoved(page, d.nuisance);
    if (d.before.fitted > 0) {
        page.section("The car before the change");
        addCarBefore(page, d.before);
    }
    if (!d.overlays.empty()) {
        page.section("Measured and simulated");
        addOverlays(page, d,
                    {.calibrated = "", .extended = d.causes.empty() ? "tolerances fitted" : "with the causes"});
    }
    page.section("Rivals");
    addRivals(page, d);
    page.section("What was left out");
    addLeftOut(page, d);
    page.section("What remains");
    addRemainder(page, d);
    page.section("Where the gap lies");
    addWhere(page, d.where);
    page.section("What to drive next");
    addNextDrives(page, d);
    page.section("Priors and thresholds");
    addSettings(page);
    return page.finish();
}

}  // namespace tread
