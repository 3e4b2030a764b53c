#include "report/html.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/text/changed.h"
#include "base/text/markup.h"
#include "report/chart_data.h"
#include "report/embedded.h"
#include "report/pack.h"
#include "report/text.h"

namespace tread {
namespace {

// What a browser grants the page: the scripts whose hashes it names, and nothing from anywhere. A script that got into
// the page with a hostile string is not run, also in an attribute. Styles cannot be named so, as lengths and colours of
// bars stand in attributes; without an address to load from they can only disfigure.
std::string policyOf(const std::vector<std::string_view>& scripts) {
    std::string allowed;
    for (const std::string_view script : scripts)
        allowed += fmt::format(" 'sha256-{}'", sha256Base64(fmt::format("\n{}", script)));
    return fmt::format(
        "default-src 'none'; script-src{}; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'",
        scripts.empty() ? " 'none'" : allowed);
}

constexpr std::string_view kHints =
    "<p class=\"hint mouse\">Point at a chart to read values at one moment in all of them. Drag sideways to zoom in "
    "time, "
    "up or down to zoom one chart; <b>double-click resets the zoom</b>.</p>\n"
    "<p class=\"hint touch\">Tap a chart to read values at one moment in all of them.</p>\n";

// A library file without the link to its source map, which is not shipped.
std::string_view withoutSourceMap(std::string_view script) {
    return script.substr(0, script.find("//# sourceMappingURL="));
}

// Signs that do not depend on seeing colours.
std::string_view signOf(Tone tone) {
    return tone == Tone::good ? "✓ " : tone == Tone::bad ? "✗ " : "";
}

std::string_view classOf(Tone tone) {
    return tone == Tone::good ? " class=\"good\"" : tone == Tone::bad ? " class=\"bad\"" : "";
}

// For screen readers: what is drawn, in which unit, and the names of the curves.
std::string spoken(const TimeChart& chart) {
    std::string names;
    for (const auto& curve : chart.curves) names += (names.empty() ? "" : ", ") + curve.name;
    return fmt::format("Chart of {} over time: {}", withUnit(chart.title, chart.unit), names);
}

std::string_view withoutStyleMap(std::string_view style) {
    return style.substr(0, style.find("/*# sourceMappingURL="));
}

// The colours are those of the style sheet.
std::string shading(const Cell& cell) {
    if (cell.bar > 0)
        return fmt::format(
            " style=\"min-width:{1}em;background:linear-gradient(to right,var(--bar) {0:.1f}%,transparent {0:.1f}%)\"",
            100 * std::min(cell.bar, 1.0), cell.number ? 7 : 15);
    if (cell.heat > 0)
        return fmt::format(" style=\"background:color-mix(in srgb,var(--heat) {:.0f}%,transparent)\"",
                           100 * std::min(cell.heat, 1.0));
    return {};
}

// The classes of the style sheet.
std::string_view classOf(Fill fill) {
    switch (fill) {
        case Fill::none:
            return "";
        case Fill::pale:
            return "pale";
        case Fill::blue:
            return "blue";
        case Fill::sky:
            return "sky";
        case Fill::purple:
            return "purple";
        case Fill::striped:
            return "striped";
        case Fill::warm:
            return "warm";
        case Fill::dotted:
            return "dotted";
    }
    return "";
}

bool drawable(const TimeChart& chart) {
    if (chart.time.empty() || chart.curves.empty()) return false;
    for (const auto& curve : chart.curves) {
        if (curve.values.empty()) return false;
    }
    return true;
}

}  // namespace

HtmlPage::HtmlPage(std::string title, std::string_view headline)
    : title_(std::move(title)), window_title_(title_ + (headline.empty() ? "" : ": " + std::string(headline))) {}

void HtmlPage::answer(std::string_view sentence, std::string_view verdict, bool good) {
    std::string badge;
    if (!verdict.empty()) {
        badge = fmt::format(R"(<strong class="verdict {}">{} {}</strong> )", good ? "good" : "bad", good ? "✓" : "✗",
                            escapeMarkup(verdict));
    }
    place() += fmt::format("<p class=\"answer\">{}{}</p>\n", badge, escapeMarkup(sentence));
}

void HtmlPage::cards(const std::vector<Card>& cards) {
    if (cards.empty()) return;
    place() += "<div class=\"cards\">\n";
    for (const Card& card : cards) {
        const std::string note = card.note.empty() ? "" : fmt::format("<em>{}</em>", escapeMarkup(card.note));
        place() += fmt::format("<div class=\"card\"><span>{}</span><b{}>{}{}<small> {}</small></b>{}</div>\n",
                               escapeMarkup(card.label), classOf(card.tone), signOf(card.tone),
                               escapeMarkup(card.value), escapeMarkup(card.unit), note);
    }
    place() += "</div>\n";
}

void HtmlPage::keyValues(const std::vector<std::pair<std::string, std::string>>& pairs) {
    place() += "<dl>\n";
    for (const auto& [key, value] : pairs) {
        if (value.empty()) continue;
        place() += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escapeMarkup(key), escapeMarkup(value));
    }
    place() += "</dl>\n";
}

void HtmlPage::links(std::string_view title, const std::vector<Link>& links) {
    if (links.empty()) return;
    std::string list;
    for (const Link& link : links)
        list += fmt::format("{}<a href=\"{}\">{}</a>", list.empty() ? "" : " · ", escapeMarkup(link.address),
                            escapeMarkup(link.text));
    place() += fmt::format("<p class=\"files\">{}: {}</p>\n", escapeMarkup(title), list);
}

void HtmlPage::warnings(const std::vector<std::string>& sentences) {
    if (sentences.empty()) return;
    place() += fmt::format("<div class=\"warnings\"><b>⚠ {} {}</b><ul>\n", sentences.size(),
                           sentences.size() == 1 ? "warning" : "warnings");
    for (const std::string& sentence : sentences) place() += fmt::format("<li>{}</li>\n", escapeMarkup(sentence));
    place() += "</ul></div>\n";
}

void HtmlPage::section(std::string_view title) {
    const std::string_view close = sections_ == 0 ? "" : "</section>\n";
    ++sections_;
    body_ += fmt::format("{}<section id=\"s{}\">\n<h2>{}</h2>\n", close, sections_, escapeMarkup(title));
    contents_ += fmt::format("<a href=\"#s{}\">{}</a>\n", sections_, escapeMarkup(title));
}

void HtmlPage::text(std::string_view paragraph) {
    place() += fmt::format("<p>{}</p>\n", escapeMarkup(paragraph));
}

void HtmlPage::table(const std::vector<std::string>& header, const std::vector<std::vector<Cell>>& rows,
                     bool prose_last) {
    place() += fmt::format("<div class=\"wide\"><table{}>\n<thead><tr>", prose_last ? " class=\"prose\"" : "");
    for (std::size_t column = 0; column < header.size(); ++column) {
        const bool number = !rows.empty() && column < rows.front().size() && rows.front()[column].number;
        place() +=
            fmt::format("<th scope=\"col\"{}>{}</th>", number ? " class=\"number\"" : "", escapeMarkup(header[column]));
    }
    place() += "</tr></thead>\n<tbody>\n";
    for (const auto& row : rows) {
        place() += "<tr>";
        for (const Cell& cell : row) {
            const std::string swatch =
                cell.fill == Fill::none ? "" : fmt::format("<i class=\"swatch {}\"></i>", classOf(cell.fill));
            const std::string note = cell.note.empty() ? "" : fmt::format("<small>{}</small>", escapeMarkup(cell.note));
            const std::string text = swatch + escapeMarkup(cell.text);
            place() += fmt::format(
                "<td class=\"{}{}\"{}>{}{}</td>", cell.number ? "number " : "",
                cell.alarm       ? "alarm"
                : cell.good_news ? "good-news"
                                 : "",
                shading(cell),
                cell.link.empty() ? text : fmt::format("<a href=\"{}\">{}</a>", escapeMarkup(cell.link), text), note);
        }
        place() += "</tr>\n";
    }
    place() += "</tbody></table></div>\n";
}

void HtmlPage::timeCharts(const std::vector<TimeChart>& charts) {
    place() += "<div class=\"charts\">\n";
    for (const TimeChart& chart : charts) addTimeChart(chart);
    place() += "</div>\n";
}

void HtmlPage::stackedTimeCharts(const std::vector<std::vector<TimeChart>>& stacks) {
    place() += "<div class=\"charts\">\n";
    for (const auto& stack : stacks) {
        place() += "<div class=\"stack\">\n";
        for (const TimeChart& chart : stack) addTimeChart(chart);
        place() += "</div>\n";
    }
    place() += "</div>\n";
}

// The place of a chart; the script draws it and its legend from the values.
void HtmlPage::addTimeChart(const TimeChart& chart) {
    if (!drawable(chart)) return;
    place() += fmt::format(
        "<figure class=\"time-chart\" id=\"c{}\"><figcaption><b>{}</b><span class=\"now\"></span></figcaption>"
        "<div class=\"legend\"></div><div class=\"canvas\" role=\"img\" aria-label=\"{}\"></div></figure>\n",
        time_charts_, escapeMarkup(withUnit(chart.title, chart.unit)), escapeMarkup(spoken(chart)));
    charts_ += (time_charts_ == 0 ? "" : ",\n") + chartData(chart);
    ++time_charts_;
}

void HtmlPage::figures(const std::vector<Chart>& charts) {
    place() += "<div class=\"figures\">\n";
    for (const Chart& chart : charts) {
        place() += fmt::format("<figure{}>{}", chart.width < kWideChart ? "" : " class=\"wide\"", svgInline(chart));
        if (!chart.note.empty()) place() += fmt::format("<figcaption>{}</figcaption>", escapeMarkup(chart.note));
        place() += "</figure>\n";
    }
    place() += "</div>\n";
}

// For screen readers the bar is one picture whose description lists the parts.
void HtmlPage::bar(const PartedBar& bar) {
    constexpr double kReadable = 0.08;  // length from which a part has its number in it
    std::string spoken, drawn;
    for (const PartedBar::Piece& piece : bar.pieces) {
        spoken += fmt::format("{}{} {}", spoken.empty() ? "" : ", ", piece.name, piece.value);
        if (piece.length <= 0) continue;
        const std::string name = escapeMarkup(piece.name), value = escapeMarkup(piece.value);
        const std::string label = piece.length < kReadable ? "" : fmt::format("<b>{}<span> {}</span></b>", value, name);
        drawn += fmt::format("<span class=\"piece {}\" style=\"flex-grow:{:.4f}\" title=\"{} {}\">{}</span>",
                             classOf(piece.fill), piece.length, name, value, label);
    }
    const std::string title = escapeMarkup(bar.title);
    place() += fmt::format(
        "<figure class=\"parts\"><figcaption>{0}</figcaption><div class=\"track\" role=\"img\" "
        "aria-label=\"{0}: {1}\">{2}</div></figure>\n",
        title, escapeMarkup(spoken), drawn);
}

void HtmlPage::fold(std::string_view title) {
    place() += fmt::format("<details><summary>{}</summary>\n", escapeMarkup(title));
}

void HtmlPage::unfold() {
    place() += "</details>\n";
}

void HtmlPage::bullets(const std::vector<std::string>& sentences) {
    if (sentences.empty()) return;
    place() += "<ul>\n";
    for (const std::string& sentence : sentences) place() += fmt::format("<li>{}</li>\n", escapeMarkup(sentence));
    place() += "</ul>\n";
}

void HtmlPage::collapsible(std::string_view title, std::string_view verbatim) {
    place() += fmt::format("<details><summary>{}</summary><pre>{}</pre></details>\n", escapeMarkup(title),
                           escapeMarkup(verbatim));
}

void HtmlPage::replay(std::string data) {
    place() += "<div id=\"replay\"></div>\n";
    replay_ = std::move(data);
}

// The scripts that the page runs: libraries before those that use them.
std::vector<std::string_view> HtmlPage::programs() const {
    const bool charts = time_charts_ > 0, replay = !replay_.empty();
    std::vector<std::string_view> out;
    if (charts || replay) out.push_back(embedded::kValuesScript);
    if (charts)
        out.insert(out.end(), {withoutSourceMap(embedded::kDygraphsScript),
                               withoutSourceMap(embedded::kDygraphsSynchronizer), embedded::kChartsScript});
    if (replay)
        out.insert(out.end(), {embedded::kThreeScript, embedded::kThreeOrbit, embedded::kReplayRoadScript,
                               embedded::kReplayCarScript, embedded::kReplayScript});
    return out;
}

// The values, then the programs. The licences of the libraries ask to travel with every copy.
std::string HtmlPage::scripts() const {
    const bool charts = time_charts_ > 0, replay = !replay_.empty();
    std::string out;
    const auto add = [&out](std::string_view attributes, std::string_view content) {
        fmt::format_to(std::back_inserter(out), "<script{}>\n{}</script>\n", attributes, content);
    };
    if (charts) out += "<button id=\"reset\" type=\"button\" hidden>Reset zoom</button>\n";
    if (charts) add(R"( id="chart-data" type="application/json")", "[" + charts_ + "]");
    if (replay) add(R"( id="replay-data" type="application/json")", replay_);
    for (const std::string_view program : programs()) add("", program);
    if (charts) add(R"( type="text/plain")", embedded::kDygraphsLicence);
    if (replay) add(R"( type="text/plain")", embedded::kThreeLicence);
    return out;
}

std::string HtmlPage::finish() const {
    const bool charts = time_charts_ > 0;
    const ChangedName title = splitChanged(title_);
    const std::string changed =
        title.changes.empty() ? "" : fmt::format("<p class=\"changed\">changed: {}</p>\n", escapeMarkup(title.changes));
    std::string out;
    fmt::format_to(
        std::back_inserter(out),
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n<title>{}</title>\n<style>\n{}{}</style>\n"
        "{}</head>\n<body>\n<header>\n<h1>{}</h1>\n{}{}</header>\n",
        policyOf(programs()), escapeMarkup(window_title_), charts ? withoutStyleMap(embedded::kDygraphsStyle) : "",
        embedded::kPageStyle, replay_.empty() ? "" : fmt::format("<style>\n{}</style>\n", embedded::kReplayStyle),
        escapeMarkup(title.name), changed, head_);
    if (sections_ > 1) out += "<nav>" + contents_ + "</nav>\n";
    if (charts) out += kHints;
    out += "<main>\n" + body_ + (sections_ > 0 ? "</section>\n" : "") + "</main>\n";
    out += scripts();
    out += "</body>\n</html>\n";
    return out;
}

}  // namespace tread
