#include "report/diagnosis_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "diagnose/answer/diagnosis.h"
#include "diagnose/answer/diagnosis_text.h"
#include "diagnose/answer/words.h"
#include "diagnose/catalogue/effect.h"
#include "diagnose/settings.h"
#include "log/log_columns.h"
#include "recording/subject_paths.h"
#include "report/text.h"

namespace tread {
namespace {

using diagnose::answer::separatesInWords;

using diagnose::kSettings;
using diagnose::kTestable;

using diagnose::answer::channelInWords;
using diagnose::answer::ConfusablePair;
using diagnose::answer::Diagnosis;
using diagnose::answer::Estimate;
using diagnose::answer::ForceLaw;
using diagnose::answer::GapLevels;
using diagnose::answer::HowFar;
using diagnose::answer::lawInWords;
using diagnose::answer::NextDrive;
using diagnose::answer::NuisanceEstimate;
using diagnose::answer::RankedEffect;
using diagnose::catalogue::Effect;
using diagnose::catalogue::effectCatalogue;
using recording::subjectNumber;

constexpr std::size_t kShown = 8;   // effects in the table; the others are only counted
constexpr std::size_t kPairs = 10;  // pairs shown that are hard to tell apart
constexpr double kNoteworthy = 1;   // least change of a number that is shown, in standard deviations of its tolerance

std::string percent(double share) {
    return fmt::format("{:.0f} %", 100 * share);
}
std::string probability(double p) {
    return p > 0.9995 ? "> 0.999" : p < 0.0005 ? "< 0.001" : fmt::format("{:.3f}", p);
}

std::string questionOf(const std::string& effect) {
    for (const Effect& known : effectCatalogue()) {
        if (known.name == quantityOf(effect)) return known.question;
    }
    return {};
}

// "front.tyre.lambda.Ky 0.88 ± 0.02 (0.85 to 0.91), nominal 1".
std::string parameterText(const std::string& path, const Estimate& e) {
    const ReferenceRow* row = subjectNumber(path);
    const DisplayUnit shown = displayUnit(row ? row->unit : "");
    const auto number = [&](double value) { return formatNumber(value * shown.scale); };
    const std::string unit = prettyUnit(shown.unit);
    return fmt::format("{} = {} ± {}{}{} (90 %: {} to {}; nominal {}){}", path, number(e.value),
                       formatNumber(e.sd * shown.scale, 2), unit.empty() ? "" : " ", unit, number(e.low),
                       number(e.high), number(e.neutral), e.at_bound ? ", at its limit" : "");
}

template <class Value>
Value valueOf(const std::map<std::string, Value>& map, const std::string& key, Value otherwise) {
    const auto found = map.find(key);
    return found == map.end() ? otherwise : found->second;
}

// All fitted parameters of an effect, separated by semicolons.
std::string parametersText(const RankedEffect& effect) {
    std::vector<std::string> lines;
    for (const auto& [path, estimate] : effect.parameters) lines.push_back(parameterText(path, estimate));
    return fmt::format("{}", fmt::join(lines, "; "));
}

}  // namespace

std::string shownName(std::string_view name) {
    std::string out = channelInWords(std::string(name));
    std::replace(out.begin(), out.end(), '_', ' ');
    return out;
}

std::vector<std::string> shownNames(const std::vector<std::string>& names) {
    std::vector<std::string> out;
    for (const std::string& name : names) out.push_back(shownName(name));
    return out;
}

void addEffects(HtmlPage& page, const Diagnosis& diagnosis) {
    std::vector<std::vector<Cell>> rows;
    const auto add = [&](const std::string& name, double p, std::string evidence, std::string text) {
        Cell chance{probability(p), true};
        chance.bar = p;
        const auto& causes = diagnosis.causes;
        const bool blamed = std::find(causes.begin(), causes.end(), name) != causes.end();
        rows.push_back({{(blamed ? "▶ " : "") + shownName(name)},
                        chance,
                        {std::move(evidence), true},
                        {std::move(text)}});
    };
    for (std::size_t i = 0; i < std::min(diagnosis.effects.size(), kShown); ++i) {
        const RankedEffect& effect = diagnosis.effects[i];
        const std::string question = questionOf(effect.name), parameters = parametersText(effect);
        add(effect.name, effect.probability, formatNumber(effect.log_evidence, 3),
            question + (question.empty() || parameters.empty() ? "" : " ") + parameters);
    }
    add("no effect visible in these drives", diagnosis.probability_of_nothing, "0",
        "The car explains the drives with its numbers within their tolerances.");
    const ForceLaw& law = diagnosis.unexplained.law;
    const bool alone = !law.generalised_force.empty();
    add("an unknown cause", diagnosis.probability_of_unknown, "",
        "A force acts that no effect of the catalogue explains" + (alone ? ": " + lawInWords(law) : "") + ".");
    page.table({"Effect", "Probability", "Evidence, nats", "Question and result"}, rows, true);
    if (diagnosis.effects.size() > kShown)
        page.text(
            fmt::format("{} other effects were considered and are less likely.", diagnosis.effects.size() - kShown));
}

void addLevels(HtmlPage& page, const HowFar& how_far, const char* extended) {
    std::vector<std::vector<Cell>> rows;
    const auto add = [&](const char* drives, const GapLevels& levels) {
        const double most = std::max({levels.nominal, levels.calibrated, levels.extended, levels.floor, 1e-9});
        const std::pair<const char*, double> stages[] = {{"nominal", levels.nominal},
                                                         {"calibrated", levels.calibrated},
                                                         {extended, levels.extended},
                                                         {"noise floor", levels.floor}};
        for (const auto& [stage, value] : stages) {
            Cell bar{stage};
            bar.bar = value / most;
            rows.push_back({{stage == stages[0].first ? drives : ""}, bar, {formatNumber(value, 3), true}});
        }
    };
    add("Drives used for fitting", how_far.training);
    if (!how_far.in_sample) add("Held-out drives", how_far.held_out);
    page.table({"Drives", "Model", "Gap"}, rows);
    page.text(fmt::format("{} of the closable gap is closed {} (90 %: {} to {}){}.", percent(how_far.closure), extended,
                          percent(how_far.closure_low), percent(how_far.closure_high),
                          how_far.in_sample ? "; judged in the fitted drives because none was held out, which is too "
                                              "optimistic"
                                            : ", in drives that were not used for fitting"));
}

void addLimits(HtmlPage& page, const Diagnosis& diagnosis) {
    std::vector<std::vector<Cell>> next;
    for (const NextDrive& drive : diagnosis.next)
        next.push_back({{drive.scenario}, {formatNumber(drive.nats, 3), true}, {separatesInWords(drive)}});
    if (!next.empty()) page.table({"Drive next", "Expected nats", "Would separate"}, next, true);

    std::vector<std::vector<Cell>> pairs;
    for (const ConfusablePair& pair : diagnosis.confusable) {
        if (pairs.size() == kPairs) break;
        pairs.push_back({{shownName(pair.a)},
                         {shownName(pair.b)},
                         {formatNumber(pair.cosine, 2), true},
                         {formatNumber(pair.separation, 2), true},
                         {pair.manoeuvre}});
    }
    if (!pairs.empty()) {
        const std::size_t all = diagnosis.confusable.size();
        page.text(
            fmt::format("Pairs that these drives cannot separate: less than {:.0f} nats between them at typical "
                        "size{}.",
                        kSettings.clear, all > kPairs ? fmt::format("; the {} nearest of {}", kPairs, all) : ""));
        page.table({"Effect", "Similar effect", "Similarity", "Separation, nats", "Mostly in"}, pairs);
    }
    std::vector<std::string> hidden;
    for (const auto& [effect, nats] : diagnosis.expected_evidence) {
        if (nats < kTestable) hidden.push_back(shownName(effect));
    }
    page.text(hidden.empty()
                  ? std::string("Every effect considered would be visible in these drives at its typical size.")
                  : fmt::format("These drives would not show {} of {} effects at their typical size: {}.",
                                hidden.size(), diagnosis.expected_evidence.size(), fmt::join(hidden, ", ")));
}

void addNuisances(HtmlPage& page, const Diagnosis& diagnosis) {
    std::vector<std::pair<std::string, NuisanceEstimate>> order;
    for (const auto& [path, estimate] : diagnosis.nuisance) {
        if (std::abs(estimate.z) > kNoteworthy) order.push_back({path, estimate});
    }
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return std::abs(a.second.z) > std::abs(b.second.z); });
    if (order.empty()) {
        page.text(
            fmt::format("None of the {} uncertain numbers changed by more than {:.0f} standard deviation of its "
                        "tolerance.",
                        diagnosis.nuisance.size(), kNoteworthy));
        return;
    }
    std::vector<std::vector<Cell>> rows;
    for (const auto& [path, estimate] : order) {
        const ReferenceRow* row = subjectNumber(path.substr(0, path.find(' ')));  // without "in" and a recording's name
        const DisplayUnit shown = displayUnit(row ? row->unit : "");
        rows.push_back({{path},
                        {formatNumber(estimate.value * shown.scale), true},
                        {formatNumber(estimate.sd * shown.scale, 2), true},
                        {prettyUnit(shown.unit)},
                        {formatNumber(estimate.z, 2), true, std::abs(estimate.z) > 2}});
    }
    page.text(fmt::format(
        "{} of {} uncertain numbers changed by more than {:.0f} standard deviation of their tolerance; beyond 2, "
        "the tolerance is doubtful.",
        order.size(), diagnosis.nuisance.size(), kNoteworthy));
    page.table({"Number", "Value", "±", "Unit", "Change in standard deviations"}, rows);
}

void addSettings(HtmlPage& page) {
    std::vector<std::vector<Cell>> rows;
    diagnose::Settings::describe(diagnose::kSettings, [&](std::string_view name, double value, const About& about) {
        rows.push_back({{std::string(name)},
                        {formatNumber(value), true},
                        {prettyUnit(std::string(about.unit))},
                        {std::string(about.meaning)}});
    });
    page.table({"Setting", "Value", "Unit", "Meaning and basis"}, rows);
}

}  // namespace tread
