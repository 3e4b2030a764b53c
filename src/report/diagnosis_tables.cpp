#include "report/diagnosis_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "diagnose/answer/words.h"
#include "diagnose/settings.h"
#include "report/text.h"

namespace tread {
namespace {

using diagnose::kSettings;

using diagnose::answer::ConfusablePair;
using diagnose::answer::Diagnosis;
using diagnose::answer::eachTogether;
using diagnose::answer::effectInWords;
using diagnose::answer::NextDrive;
using diagnose::answer::RankedEffect;
using diagnose::answer::together;
using diagnose::answer::unseenEffects;

constexpr std::size_t kShown = 8;   // effects in the table; the others are only counted
constexpr std::size_t kPairs = 10;  // pairs shown that are hard to tell apart

std::string probability(double p) {
    return p > 0.9995 ? "> 0.999" : p < 0.0005 ? "< 0.001" : fmt::format("{:.3f}", p);
}

void addEffects(HtmlPage& page, const Diagnosis& diagnosis) {
    std::vector<std::vector<Cell>> rows;
    const auto add = [&](const std::string& name, double p, std::string evidence) {
        Cell chance{probability(p), true};
        chance.bar = p;
        rows.push_back({{name}, chance, {std::move(evidence), true}});
    };
    for (std::size_t i = 0; i < std::min(diagnosis.effects.size(), kShown); ++i) {
        const RankedEffect& effect = diagnosis.effects[i];
        add((isCause(diagnosis, effect.name) ? "▶ " : "") + effectInWords(effect.name), effect.probability,
            formatNumber(effect.log_evidence, 3));
    }
    // Whether there is an unknown cause is a question of its own, asked of each of these alike.
    const double unknown = diagnosis.probability_of_unknown;
    add("no effect visible in these drives", unknown < 1 ? diagnosis.probability_of_nothing / (1 - unknown) : 0, "0");
    page.table({"Effect", "Probability", "Evidence, nats"}, rows);
    page.text(
        fmt::format("In addition to any of these, there may be an unknown cause ({}). It is part of the answer from p = "
                    "{} on, and beside named causes from p = 0.5 on.",
                    diagnose::answer::probabilityInWords(unknown), formatNumber(kSettings.sure, 2)));
    if (diagnosis.effects.size() > kShown)
        page.text(
            fmt::format("{} other effects were considered and are less likely.", diagnosis.effects.size() - kShown));
}

void addRuledOut(HtmlPage& page, const Diagnosis& diagnosis) {
    std::vector<std::vector<Cell>> rows;
    for (const diagnose::answer::RuledOut& one : diagnosis.ruled_out)
        rows.push_back({{together(one.effects)}, {formatNumber(one.log_evidence, 3), true}, {one.reason}});
    if (rows.empty()) return;
    page.text("These have evidence but cannot be the answer:");
    page.table({"Effects", "Evidence, nats", "Why not"}, rows);
}

void addPairs(HtmlPage& page, const std::vector<ConfusablePair>& all, const char* sentence) {
    std::vector<std::vector<Cell>> rows;
    for (const ConfusablePair& pair : all) {
        if (rows.size() == kPairs) break;
        rows.push_back({{effectInWords(pair.a)},
                        {effectInWords(pair.b)},
                        {formatNumber(pair.cosine, 2), true},
                        {formatNumber(pair.separation, 2), true},
                        {pair.manoeuvre}});
    }
    if (rows.empty()) return;
    page.text(fmt::format("{}: less than {:.0f} nats between them at typical size{}.", sentence, kSettings.clear,
                          all.size() > kPairs ? fmt::format("; the {} most similar of {}", kPairs, all.size()) : ""));
    page.table({"Effect", "Similar effect", "Similarity", "Separation, nats", "Best distinguished by"}, rows);
}

}  // namespace

std::string shownName(std::string_view name) {
    std::string out = diagnose::answer::channelInWords(std::string(name));
    std::replace(out.begin(), out.end(), '_', ' ');
    return out;
}

void addRivals(HtmlPage& page, const Diagnosis& diagnosis) {
    if (!diagnosis.alternatives.empty()) {
        const std::string drive = tellingDrive(diagnosis);
        page.text(fmt::format("Could also be {}.{}", fmt::join(eachTogether(diagnosis.alternatives), ", or "),
                              drive.empty() ? "" : " To tell them apart, drive " + drive + "."));
    }
    addEffects(page, diagnosis);
    addRuledOut(page, diagnosis);
    addPairs(page, pairsOfCauses(diagnosis), "Effects that these drives can hardly distinguish from a named cause");
}

void addNextDrives(HtmlPage& page, const Diagnosis& diagnosis) {
    std::vector<std::vector<Cell>> next;
    for (const NextDrive& drive : diagnosis.next)
        next.push_back({{drive.scenario}, {evidenceInWords(drive), true}, {separatesInWords(drive)}});
    if (!next.empty()) page.table({"Drive next", "Expected evidence", "Would separate"}, next, true);
    std::vector<std::string> hidden;
    for (const std::string& effect : unseenEffects(diagnosis)) hidden.push_back(effectInWords(effect));
    page.text(hidden.empty()
                  ? std::string("Every effect considered would be visible in these drives at its typical size.")
                  : fmt::format("These drives would not show {} of {} effects at their typical size: {}.",
                                hidden.size(), diagnosis.expected_evidence.size(), fmt::join(hidden, ", ")));
    std::vector<ConfusablePair> others;
    for (const ConfusablePair& pair : diagnosis.confusable)
        if (!isCause(diagnosis, pair.a) && !isCause(diagnosis, pair.b)) others.push_back(pair);
    addPairs(page, others, "Other effects that these drives can hardly distinguish");
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
