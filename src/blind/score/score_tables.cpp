#include "blind/score/score_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "blind/score/bands.h"
#include "blind/score/groups.h"

namespace tread::blind::score {
namespace {

using key::CaseKind;

using Row = ScoreTable::Row;

std::string ratio(const Count& count) {
    return count.of > 0 ? fmt::format("{}/{}", count.hits, count.of) : "";
}

std::string percent(double share) {
    return fmt::format("{:.0f} %", 100 * share);
}

std::string targetOf(const Figure& figure) {
    if (figure.target == 0) return "";
    return fmt::format("{} {}{}", figure.at_least ? ">=" : "<=", percent(figure.target),
                       figure.missed() ? " missed" : "");
}

Row rowOf(const Figure& figure, const std::string& words) {
    const Interval interval = figure.interval();
    return {.cells = {words, ratio(figure), percent(figure.share()),
                      fmt::format("{:.0f} to {:.0f}", 100 * interval.low, 100 * interval.high),
                      ratio(figure.largest_reduction), ratio(figure.bic), targetOf(figure)},
            .share = figure.share(),
            .missed = figure.missed()};
}

std::string wordsOfGroup(std::string_view name) {
    const auto found = std::find_if(caseGroups().begin(), caseGroups().end(),
                                    [&](const CaseGroup& group) { return group.name == name; });
    return found->words;
}

// Count of a figure: of the diagnosis or of a simpler method.
using Part = const Count& (*)(const Figure&);

const Count& answersOf(const Figure& figure) {
    return figure;
}

const Count& largestReductionOf(const Figure& figure) {
    return figure.largest_reduction;
}

const Count& bicOf(const Figure& figure) {
    return figure.bic;
}

// Adds a row with the figure of all cases and of each group, unless all groups are empty.
void addParts(ScoreTable& table, const BlindScore& score, const Figure& figure, const std::string& words,
              const std::vector<std::string>& in_groups, Part part = answersOf) {
    Row row{.cells = {words, ratio(part(figure))}};
    bool any = false;
    for (const std::string& group : in_groups) {
        row.cells.push_back(ratio(part(score.figure(figure.name, group))));
        any = any || !row.cells.back().empty();
    }
    row.cells.resize(table.header.size());
    if (any) table.rows.push_back(std::move(row));
}

int casesIn(const BlindScore& score, const Figure& figure, const std::vector<std::string>& in_groups) {
    int cases = 0;
    for (const std::string& group : in_groups) cases += score.figure(figure.name, group).of;
    return cases;
}

ScoreTable bandTable(const BlindScore& score) {
    ScoreTable table{.title = "By detectability",
                     .header = {"figure", "all", "< 6", "6-22", "22-100", ">= 100", "apart", "alike"},
                     .rows = {}};
    std::vector<std::string> weaker = weakerBandGroups();
    weaker.insert(weaker.end(), {kTestableAndApart, kTestableAlike});
    for (const Figure& figure : score.figures) {
        if (!figure.group.empty()) break;
        addParts(table, score, figure, figure.words, weaker);
        addParts(table, score, figure, "  largest reduction", weaker, largestReductionOf);
        addParts(table, score, figure, "  BIC", weaker, bicOf);
        const bool of_two = casesIn(score, figure, strongerBandGroups()) == figure.of;
        if (of_two) addParts(table, score, figure, "  by the stronger of two", strongerBandGroups());
    }
    table.note = fmt::format(
        "Expected evidence in nats, from the sealed key; of two faults the weaker counts. A fault of {:.0f} nats gains "
        "5 nats in {:.2f} % of cases. apart: 22 nats and more, and at least 6 nats better than the best imitation by "
        "another effect; alike: less than 6.",
        kTestable, 100 * chanceToGain(5, kTestable));
    return table;
}

// Figures that concern more than one kind.
ScoreTable kindTable(const BlindScore& score) {
    ScoreTable table{.title = "By kind", .header = {"figure", "all"}, .rows = {}};
    for (const std::string_view kind : enumNames(CaseKind{})) table.header.emplace_back(kind);
    const std::vector<std::string> names = kindGroups();
    for (const Figure& figure : score.figures) {
        if (!figure.group.empty()) break;
        const auto of_kind = [&](const std::string& name) { return score.figure(figure.name, name).of > 0; };
        if (std::count_if(names.begin(), names.end(), of_kind) > 1) addParts(table, score, figure, figure.words, names);
    }
    return table;
}

ScoreTable outcomeTable(const BlindScore& score) {
    ScoreTable table{
        .title = "Outcomes",
        .header = {"kind", "nats", "cases", "right", "partly", "nothing", "unknown", "wrong", "no answer"},
        .rows = {},
        .words = 2,
        .note =
            "right: the fault is named first; both of two faults and nothing else; nothing if there is no fault; "
            "unknown for an outsider; both for mixed. partly: some of the faults are named, or all of "
            "them and something else. nats: of the weaker of two effects, and of the effect of mixed."};
    for (const OutcomeRow& row : score.outcomes) {
        Row cells{.cells = {std::string(enumNames(row.kind)[static_cast<std::size_t>(row.kind)]), row.bands,
                            std::to_string(row.cases())}};
        for (const int count : row.counts) cells.cells.push_back(count > 0 ? std::to_string(count) : "");
        table.rows.push_back(std::move(cells));
    }
    return table;
}

ScoreTable calibrationTable(const BlindScore& score) {
    ScoreTable table{.title = "Stated probabilities",
                     .header = {"from", "to", "claims", "stated, mean", "right", "right"},
                     .rows = {},
                     .words = 0,
                     .note = fmt::format(
                         "Expected calibration error {:.3f} (required: at most 0.05). As many claims that are right as "
                         "often as they state show {:.3f} on average.",
                         score.calibration_error, score.calibration_error_by_chance)};
    for (const ReliabilityBin& bin : score.reliability) {
        if (bin.claims == 0) continue;
        table.rows.push_back({.cells = {fmt::format("{:.1f}", bin.from), fmt::format("{:.1f}", bin.to),
                                        std::to_string(bin.claims), percent(bin.stated), std::to_string(bin.right),
                                        percent(static_cast<double>(bin.right) / bin.claims)}});
    }
    return table;
}

ScoreTable confusionTable(const BlindScore& score) {
    ScoreTable table{.title = "Answers", .header = {"truth", "answer", "cases"}, .rows = {}, .words = 2};
    for (const auto& [truth, answers] : score.confusion) {
        for (const auto& [answer, count] : answers)
            table.rows.push_back({.cells = {truth, answer, std::to_string(count)}});
    }
    return table;
}

}  // namespace

ScoreTable overallTable(const BlindScore& score) {
    ScoreTable table{
        .title = "Figures of all cases",
        .header = {"figure", "cases", "share", "Wilson 95 %", "reduction", "BIC", "asked for"},
        .rows = {},
        .note =
            "reduction, BIC: the same figure for two simpler methods, the one effect that reduces the gap most "
            "and the least Bayesian information criterion."};
    for (const Figure& figure : score.figures) {
        if (!figure.group.empty()) break;
        if (figure.of == 0) continue;
        table.rows.push_back(rowOf(figure, figure.words));
        const int of_families = casesIn(score, figure, familyGroups());
        for (const Figure& part : score.figures) {
            const bool family = part.group.ends_with("_family") && of_families == figure.of;
            if (part.name == figure.name && !part.group.empty() && part.of > 0 && (family || part.target > 0))
                table.rows.push_back(rowOf(part, "  " + wordsOfGroup(part.group)));
        }
    }
    return table;
}

std::vector<ScoreTable> scoreTables(const BlindScore& score) {
    std::vector<ScoreTable> tables{overallTable(score), bandTable(score),        kindTable(score),
                                   outcomeTable(score), calibrationTable(score), confusionTable(score)};
    std::erase_if(tables, [](const ScoreTable& table) { return table.rows.empty(); });
    return tables;
}

}  // namespace tread::blind::score
