#include "report/blind_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/html.h"
#include "report/text.h"

namespace tread {
namespace {

std::string tenthsOfPercent(double share) {
    return fmt::format("{:.1f} %", 100 * share);
}

bool missed(const Figure& figure) {
    return figure.target > 0 && figure.of > 0 &&
           (figure.at_least ? figure.share() < figure.target : figure.share() > figure.target);
}

std::vector<std::vector<Cell>> figureRows(const BlindScore& score) {
    std::vector<std::vector<Cell>> rows;
    for (const Figure& figure : score.figures) {
        if (figure.of == 0) continue;
        const Interval interval = figure.interval();
        rows.push_back({{.text = figure.what.starts_with(" ") ? "– " + figure.what : figure.what},
                        {.text = fmt::format("{} of {}", figure.hits, figure.of), .number = true},
                        {.text = tenthsOfPercent(figure.share()), .number = true, .alarm = missed(figure)},
                        {.text = fmt::format("{} to {}", tenthsOfPercent(interval.low), tenthsOfPercent(interval.high)),
                         .number = true},
                        {.text = figure.target > 0 ? fmt::format("{} {}", figure.at_least ? "at least" : "at most",
                                                                 tenthsOfPercent(figure.target))
                                                   : "",
                         .number = true}});
    }
    return rows;
}

// What was asked for and no case could answer.
std::string untried(const BlindScore& score) {
    std::vector<std::string> names;
    for (const Figure& figure : score.figures)
        if (figure.of == 0 && figure.target > 0) names.push_back(figure.what);
    return names.empty() ? "" : fmt::format("No case says anything of: {}.", fmt::join(names, "; "));
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
    return {.title = "Are the stated probabilities true?",
            .x = {.label = "stated probability", .unit = "%", .lowest = 0, .highest = 100},
            .y = {.label = "claims that were right", .unit = "%", .lowest = 0, .highest = 100},
            .series = {ideal, stated},
            .note = fmt::format("{} claims; expected calibration error {:.3f}.", claims, score.calibration_error)};
}

std::vector<std::vector<Cell>> confusionRows(const BlindScore& score) {
    std::vector<std::vector<Cell>> rows;
    for (const auto& [truth, answers] : score.confusion) {
        for (const auto& [answer, count] : answers) {
            rows.push_back({{.text = truth},
                            {.text = answer, .alarm = truth != answer && truth.find(':') == std::string::npos},
                            {.text = std::to_string(count), .number = true}});
        }
    }
    return rows;
}

}  // namespace

std::string blindReport(const BlindReport& report) {
    const BlindScore& score = report.score;
    HtmlPage page("Blind check of the diagnosis");
    const std::string text = scoreText(score);
    page.answer(text.substr(0, text.find('\n')));
    const auto card = [&](const char* label, const char* name) {
        const Figure& figure = score.figure(name);
        return figure.of > 0 ? Card{label, tenthsOfPercent(figure.share()), ""} : Card{label, "–", "no such case"};
    };
    page.cards(
        {card("Single cause named first", "named_first"),
         card("False alarms", "false_alarm"),
         card("Unknown causes recognised", "unknown"),
         {"Gap closed, single causes, median", score.median_closure ? tenthsOfPercent(*score.median_closure) : "–",
          score.median_closure ? "" : "none blamed"},
         {"Calibration error", formatNumber(score.calibration_error, 2), ""},
         {"Time of a diagnosis", formatNumber(score.median_seconds, 3), "s"}});
    page.keyValues({{"Cases", report.made_of},
                    {"90 % set, single causes", score.mean_credible_set
                                                    ? fmt::format("{:.1f} causes in the mean, median {:.0f}",
                                                                  *score.mean_credible_set, *score.median_credible_set)
                                                    : ""},
                    {"SHA-256 of the key", report.key_sha256},
                    {"Made by", "tread " + report.version}});
    if (score.failed > 0) page.warnings({fmt::format("{} of {} cases have no answer.", score.failed, score.cases)});
    page.section("Figures");
    page.table({"What", "Cases", "Share", "Wilson 95 %", "Asked for"}, figureRows(score));
    if (const std::string rest = untried(score); !rest.empty()) page.text(rest);
    page.section("Probabilities");
    page.figures({reliabilityChart(score)});
    page.section("Confusion");
    page.table({"What was so", "What was answered", "Cases"}, confusionRows(score));
    return page.finish();
}

}  // namespace tread
