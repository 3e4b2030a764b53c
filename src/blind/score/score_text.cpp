#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "blind/score/score_tables.h"

namespace tread::blind::score {
namespace {

constexpr std::size_t kWidth = 110;       // columns
constexpr std::size_t kWidestWords = 48;  // characters of a cell; longer ones are cut

std::string cut(const std::string& text) {
    return text.size() <= kWidestWords ? text : text.substr(0, kWidestWords - 3) + "...";
}

std::vector<std::size_t> widthsOf(const ScoreTable& table) {
    std::vector<std::size_t> widths;
    for (const std::string& word : table.header) widths.push_back(word.size());
    for (const ScoreTable::Row& row : table.rows) {
        for (std::size_t i = 0; i < row.cells.size(); ++i) widths[i] = std::max(widths[i], cut(row.cells[i]).size());
    }
    return widths;
}

std::string lineOf(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths, std::size_t words) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i)
        line += i < words ? fmt::format("  {:<{}}", cut(cells[i]), widths[i])
                          : fmt::format("  {:>{}}", cut(cells[i]), widths[i]);
    return line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
}

// Wraps at kWidth and indents by two columns; with `first_out`, the first line is not indented.
std::string wrapped(const std::string& text, bool first_out = false) {
    std::string lines, line = " ";
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t to = std::min(text.find(' ', from), text.size());
        if (line.size() + 1 + to - from > kWidth) lines += line + "\n", line = " ";
        line += " " + text.substr(from, to - from);
        from = to + 1;
    }
    return (lines + line + "\n").substr(first_out ? 2 : 0);
}

std::string textOf(const ScoreTable& table) {
    const std::vector<std::size_t> widths = widthsOf(table);
    std::string text = "\n" + table.title + "\n" + lineOf(table.header, widths, table.words);
    for (const ScoreTable::Row& row : table.rows) text += lineOf(row.cells, widths, table.words);
    if (!table.note.empty()) text += wrapped(table.note);
    return text;
}

std::string numbersInWords(const BlindScore& score) {
    double sum = 0;
    int finite = 0;
    for (const EstimateError& error : score.number_errors) {
        if (!std::isfinite(error.in_sd)) continue;
        sum += error.in_sd * error.in_sd;
        ++finite;
    }
    if (score.number_errors.empty()) return "Numbers of rightly named causes: none.";
    return fmt::format(
        "Numbers of rightly named causes: {}, {} of them at a bound or without a standard deviation; rms error {:.2f} "
        "sd; "
        "median error {:.0f} % of the distance from the nominal car's number.",
        score.number_errors.size(), static_cast<int>(score.number_errors.size()) - finite,
        finite > 0 ? std::sqrt(sum / finite) : 0, 100 * *score.median_relative_error);
}

std::string restInWords(const BlindScore& score) {
    return wrapped(numbersInWords(score)) +
           wrapped("Closure obtained on held-out drives, single effects: " +
                   (score.median_closure ? fmt::format("median {:.0f} %.", 100 * *score.median_closure)
                                         : "no car could be driven again.")) +
           wrapped("Causes in the 90 % set, single effects: " +
                   (score.mean_credible_set ? fmt::format("mean {:.1f}, median {:.0f}.", *score.mean_credible_set,
                                                          *score.median_credible_set)
                                            : "no such case.")) +
           wrapped(fmt::format("Time of a diagnosis: median {:.0f} s, at most {:.0f} s.", score.median_seconds,
                               score.longest_seconds));
}

}  // namespace

std::string scoreInWords(const BlindScore& score) {
    std::vector<std::string> parts;
    const auto add = [&](const char* name, const char* words) {
        const Figure& figure = score.figure(name);
        if (figure.of > 0) parts.push_back(fmt::format("{} {} of {}", words, figure.hits, figure.of));
    };
    add("named_first", "one effect named first in");
    add("pair_both", "both of two in");
    add("false_alarm", "false alarms");
    add("unknown", "outsiders called unknown");
    add("wrong_confident", "wrong and confident");
    parts.push_back(fmt::format("calibration error {:.3f} ({:.3f} by chance)", score.calibration_error,
                                score.calibration_error_by_chance));
    return fmt::format("Blind check of {} cases, {}: {}", score.cases, score.frozen.frozen ? "frozen" : "NOT frozen",
                       fmt::join(parts, ", "));
}

std::string scoreText(const BlindScore& score) {
    std::string text = wrapped(scoreInWords(score), true) + wrapped(score.frozen.words) +
                       fmt::format("  diagnosed {} references\n", score.references ? "with" : "without");
    if (score.failed > 0)
        text += fmt::format("  {} of {} cases without an answer: counted as answered with nothing\n", score.failed,
                            score.cases);
    for (const ScoreTable& table : scoreTables(score)) text += textOf(table);
    return text + "\n" + restInWords(score);
}

}  // namespace tread::blind::score
