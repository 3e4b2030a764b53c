#include "report/blind_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "blind/score/score_tables.h"
#include "report/html.h"
#include "report/text.h"

namespace tread {
namespace {

using blind::score::BlindScore;
using blind::score::Figure;
using blind::score::ReliabilityBin;
using blind::score::scoreInWords;
using blind::score::ScoreTable;
using blind::score::scoreTables;

std::string wholePercent(double share) {
    return fmt::format("{:.0f} %", 100 * share);
}

std::string withDash(const std::string& words) {
    return words.starts_with("  ") ? "– " + words.substr(2) : words;
}

std::vector<std::vector<Cell>> rowsOf(const ScoreTable& table) {
    std::vector<std::vector<Cell>> rows;
    for (const ScoreTable::Row& row : table.rows) {
        std::vector<Cell>& cells = rows.emplace_back();
        for (std::size_t i = 0; i < row.cells.size(); ++i) {
            Cell cell{.text = i < table.words ? withDash(row.cells[i]) : row.cells[i], .number = i >= table.words};
            const std::string& column = table.header[i];
            if (column == "share") cell.bar = row.share;
            cell.alarm = (row.missed && column == "asked for") ||
                         ((column == "wrong" || column == "no answer") && !cell.text.empty());
            cells.push_back(std::move(cell));
        }
    }
    return rows;
}

// Names the targets that no case concerns.
std::string untried(const BlindScore& score) {
    std::vector<std::string> names;
    for (const Figure& figure : score.figures)
        if (figure.of == 0 && figure.target > 0) names.push_back(figure.words);
    return names.empty() ? "" : fmt::format("No case for: {}.", fmt::join(names, "; "));
}

Chart reliabilityChart(const BlindScore& score) {
    Series stated{.name = "claims", .x = {}, .y = {}, .markers = true};
    int claims = 0;
    for (const ReliabilityBin& bin : score.reliability) {
        if (bin.claims == 0) continue;
        claims += bin.claims;
        stated.x.push_back(100 * bin.stated);
        stated.y.push_back(100.0 * bin.right / bin.claims);
    }
    Series ideal{.name = "as stated", .x = {0, 100}, .y = {0, 100}, .colour = Colour::grey, .dashed = true};
    return {
        .title = "Are the stated probabilities true?",
        .x = {.label = "stated probability", .unit = "%", .lowest = 0, .highest = 100},
        .y = {.label = "claims that were right", .unit = "%", .lowest = 0, .highest = 100},
        .series = {ideal, stated},
        .note = fmt::format("{} claims; expected calibration error {:.3f}. As many claims that are right as often as "
                            "they state show {:.3f} on average.",
                            claims, score.calibration_error, score.calibration_error_by_chance)};
}

std::vector<Card> cardsOf(const BlindScore& score) {
    const auto card = [&](const char* label, const char* name) {
        const Figure& figure = score.figure(name);
        return figure.of > 0 ? Card{label, wholePercent(figure.share()), fmt::format("of {}", figure.of)}
                             : Card{label, "–", "no such case"};
    };
    return {card("Single effects named first", "named_first"),
            card("False alarms", "false_alarm"),
            card("Outsiders called unknown", "unknown"),
            card("Wrong and confident, of all claims", "wrong_confident"),
            card("Numbers within 2 sd", "numbers_2sd"),
            {"Calibration error", formatNumber(score.calibration_error, 2), "",
             fmt::format("{:.2f} by chance", score.calibration_error_by_chance)},
            {"Time of a diagnosis", formatNumber(score.median_seconds, 3), "s"}};
}

}  // namespace

std::string blindReport(const BlindReport& report) {
    const BlindScore& score = report.score;
    HtmlPage page("Blind check of the diagnosis");
    page.answer(scoreInWords(score), score.frozen.frozen ? "frozen" : "not frozen", score.frozen.frozen);
    page.cards(cardsOf(score));
    page.keyValues(
        {{"Cases", report.made_of},
         {"Programs", score.frozen.words},
         {"References", score.references ? "every drive compared with its reference" : "none"},
         {"Gap closed, single effects",
          score.median_closure ? wholePercent(*score.median_closure) + " (median), on held-out drives" : ""},
         {"Error of numbers", score.median_relative_error
                                  ? fmt::format("{} in the median, of the distance from the nominal car's number",
                                                wholePercent(*score.median_relative_error))
                                  : ""},
         {"90 % set, single effects",
          score.mean_credible_set
              ? fmt::format("mean {:.1f} causes, median {:.0f}", *score.mean_credible_set, *score.median_credible_set)
              : ""},
         {"SHA-256 of the key", report.key_sha256},
         {"Made by", "tread " + report.version}});
    if (score.failed > 0)
        page.warnings({fmt::format("{} of {} cases have no answer: counted as answered with nothing.", score.failed,
                                   score.cases)});
    for (const ScoreTable& table : scoreTables(score)) {
        page.section(table.title);
        if (!table.note.empty()) page.text(table.note);
        page.table(table.header, rowsOf(table));
        if (table.header.back() == "asked for" && !untried(score).empty()) page.text(untried(score));
        if (table.header.front() == "from") page.figures({reliabilityChart(score)});
    }
    return page.finish();
}

}  // namespace tread
