// What the causes change on the car, and what moved within tolerances.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "diagnose/answer/changed_numbers.h"
#include "diagnose/answer/words.h"
#include "diagnose/catalogue/effect.h"
#include "log/log_columns.h"
#include "report/diagnosis_tables.h"
#include "report/text.h"

namespace tread {
namespace {

using diagnose::answer::capitalised;
using diagnose::answer::ChangedNumber;
using diagnose::answer::Diagnosis;
using diagnose::answer::effectInWords;
using diagnose::answer::Estimate;
using diagnose::answer::FittedBefore;
using diagnose::answer::MovedNumber;
using diagnose::answer::NuisanceEstimate;
using diagnose::answer::RankedEffect;
using diagnose::catalogue::Effect;
using diagnose::catalogue::effectCatalogue;

constexpr std::size_t kMostOpen = 8;  // rows of a table that is not folded away
constexpr double kDoubtful = 2;       // change in standard deviations, from which a tolerance is doubtful

std::string questionOf(const std::string& effect) {
    for (const Effect& known : effectCatalogue())
        if (known.name == quantityOf(effect)) return known.question;
    return {};
}

// Numbers in the unit in which a number is shown.
struct Shown {
    explicit Shown(const std::string& path) : unit(displayUnit(diagnose::answer::unitOf(path))) {}
    std::string bare(double value, int digits = 4) const { return formatNumber(value * unit.scale, digits); }
    std::string symbol() const {
        const std::string pretty = prettyUnit(unit.unit);
        return pretty.empty() ? "" : " " + pretty;
    }
    DisplayUnit unit;
};

// "-32 ± 4 %", or "+0.2 ± 0.1 deg" where the nominal value is 0.
std::string changeOf(const Estimate& e, const Shown& shown) {
    const std::string percent = diagnose::answer::changeInPercent(e, "±");
    if (!percent.empty()) return percent;
    return fmt::format("{}{} ± {}{}", e.value > e.neutral ? "+" : "", shown.bare(e.value - e.neutral, 2),
                       shown.bare(e.sd, 2), shown.symbol());
}

std::vector<Cell> rowOf(const ChangedNumber& number) {
    const Estimate& e = number.estimate;
    const Shown shown(number.paths.front());
    return {{diagnose::answer::numberInWords(number.paths)},
            {fmt::format("{} → {}{}", shown.bare(e.neutral), shown.bare(e.value), shown.symbol()), true},
            {changeOf(e, shown), true},
            {fmt::format("{}; 90 %: {} to {}{}{}", fmt::join(number.paths, ", "), shown.bare(e.low), shown.bare(e.high),
                         shown.symbol(), atItsEnd(e) ? "; at the end of its plausible range" : ""),
             false, atItsEnd(e)}};
}

void addChangesOf(HtmlPage& page, const RankedEffect& effect, bool compared) {
    const std::string question = questionOf(effect.name);
    page.text(fmt::format("{} ({}){}{}", capitalised(effectInWords(effect.name)),
                          diagnose::answer::probabilityInWords(effect.probability), question.empty() ? "." : ": ",
                          question));
    std::vector<std::vector<Cell>> rows;
    for (const ChangedNumber& number : changedNumbers(effect)) rows.push_back(rowOf(number));
    if (!rows.empty())
        page.table({"Number", compared ? "Before → after" : "Nominal → found", "Change", "Path and 90 % interval"},
                   rows, true);
}

}  // namespace

void addChanges(HtmlPage& page, const Diagnosis& diagnosis) {
    for (const RankedEffect* effect : namedEffects(diagnosis)) addChangesOf(page, *effect, diagnosis.compared);
}

void addMoved(HtmlPage& page, const std::map<std::string, NuisanceEstimate>& numbers) {
    const std::vector<MovedNumber> moved = movedNumbers(numbers);
    if (moved.empty()) {
        page.text(fmt::format("None of {} uncertain numbers moved by a standard deviation of its tolerance.",
                              numbers.size()));
        return;
    }
    std::vector<std::vector<Cell>> rows;
    for (const auto& [name, e] : moved) {
        const Shown shown(name);
        rows.push_back({{diagnose::answer::numberInWords({name})},
                        {fmt::format("{} ± {} → {}{}", shown.bare(e.nominal), shown.bare(e.prior_sd, 2),
                                     shown.bare(e.value), shown.symbol()),
                         true},
                        {fmt::format("{:+.1f}", e.z), true, std::abs(e.z) > kDoubtful},
                        {name + (e.at_bound ? "; at the end of its plausible range" : ""), false, e.at_bound}});
    }
    const bool fold = rows.size() > kMostOpen;
    page.text(fmt::format(
        "{} of {} uncertain numbers moved by a standard deviation of their tolerance or more; beyond {:.0f}, the "
        "tolerance is doubtful.",
        moved.size(), numbers.size(), kDoubtful));
    if (fold) page.fold(fmt::format("The {} numbers", rows.size()));
    page.table({"Number", "Nominal ± tolerance → found", "Change, in ±", "Path"}, rows, true);
    if (fold) page.unfold();
}

void addCarBefore(HtmlPage& page, const FittedBefore& before) {
    page.text(fmt::format(
        "Rms gap in the references (the same drives before the car was changed), relative to that of a perfect model: "
        "{:.1f} for the nominal car, {:.1f} after the fit. Causes are sought relative to the fitted car. The further "
        "the gap is above 1, the less the sensitivities of the model match those of the car.",
        before.nominal, before.fitted));
    addMoved(page, before.moved);
}

}  // namespace tread
