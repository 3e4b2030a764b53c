#include "report/html.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "report/chart_data.h"
#include "report/embedded.h"
#include "report/text.h"

namespace tread {
namespace {

// No page of ours ever needs the network; a browser that reads this refuses it even if a hostile string got through.
constexpr std::string_view kPolicy =
    "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:; base-uri 'none'; "
    "form-action 'none'";

constexpr std::string_view kHints =
    "<p class=\"hint mouse\">Point at a chart to read values at one moment in all of them. Drag sideways to zoom in "
    "time, "
    "up or down to zoom one chart; <b>double-click resets the zoom</b>.</p>\n"
    "<p class=\"hint touch\">Tap a chart to read values at one moment in all of them.</p>\n";

// A library file without the link to its source map, which is not shipped.
std::string_view withoutSourceMap(std::string_view script) {
    return script.substr(0, script.find("//# sourceMappingURL="));
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
        place() += fmt::format("<div class=\"card\"><span>{}</span><b>{}<small> {}</small></b></div>\n",
                               escapeMarkup(card.label), escapeMarkup(card.value), escapeMarkup(card.unit));
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
        place() += fmt::format("<th{}>{}</th>", number ? " class=\"number\"" : "", escapeMarkup(header[column]));
    }
    place() += "</tr></thead>\n<tbody>\n";
    for (const auto& row : rows) {
        place() += "<tr>";
        for (const Cell& cell : row) {
            const std::string swatch =
                cell.fill == Fill::none ? "" : fmt::format("<i class=\"swatch {}\"></i>", classOf(cell.fill));
            const std::string text = swatch + escapeMarkup(cell.text);
            place() += fmt::format(
                "<td class=\"{}{}\"{}>{}</td>", cell.number ? "number " : "",
                cell.alarm       ? "alarm"
                : cell.good_news ? "good-news"
                                 : "",
                shading(cell),
                cell.link.empty() ? text : fmt::format("<a href=\"{}\">{}</a>", escapeMarkup(cell.link), text));
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
        "<div class=\"legend\"></div><div class=\"canvas\"></div></figure>\n",
        time_charts_, escapeMarkup(withUnit(chart.title, chart.unit)));
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

// The values, then the libraries, then our own scripts. The licences of the libraries ask to travel with every copy.
std::string HtmlPage::scripts() const {
    const bool charts = time_charts_ > 0, replay = !replay_.empty();
    std::string out;
    const auto add = [&out](std::string_view attributes, std::string_view content) {
        fmt::format_to(std::back_inserter(out), "<script{}>\n{}</script>\n", attributes, content);
    };
    if (charts) out += "<button id=\"reset\" type=\"button\" hidden>Reset zoom</button>\n";
    if (charts) add(R"( id="chart-data" type="application/json")", "[" + charts_ + "]");
    if (replay) add(R"( id="replay-data" type="application/json")", replay_);
    if (charts || replay) add("", embedded::kValuesScript);
    if (charts) {
        add("", withoutSourceMap(embedded::kDygraphsScript));
        add("", withoutSourceMap(embedded::kDygraphsSynchronizer));
        add("", embedded::kChartsScript);
        add(R"( type="text/plain")", embedded::kDygraphsLicence);
    }
    if (replay) {
        for (const std::string_view script :
             {embedded::kThreeScript, embedded::kThreeOrbit, embedded::kReplayRoadScript, embedded::kReplayCarScript,
              embedded::kReplayScript})
            add("", script);
        add(R"( type="text/plain")", embedded::kThreeLicence);
    }
    return out;
}

std::string HtmlPage::finish() const {
    const bool charts = time_charts_ > 0;
    std::string out;
    fmt::format_to(
        std::back_inserter(out),
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n<title>{}</title>\n<style>\n{}{}</style>\n"
        "{}</head>\n<body>\n<header>\n<h1>{}</h1>\n{}</header>\n",
        kPolicy, escapeMarkup(window_title_), charts ? withoutStyleMap(embedded::kDygraphsStyle) : "",
        embedded::kPageStyle, replay_.empty() ? "" : fmt::format("<style>\n{}</style>\n", embedded::kReplayStyle),
        escapeMarkup(title_), head_);
    if (sections_ > 1) out += "<nav>" + contents_ + "</nav>\n";
    if (charts) out += kHints;
    out += "<main>\n" + body_ + (sections_ > 0 ? "</section>\n" : "") + "</main>\n";
    out += scripts();
    out += "</body>\n</html>\n";
    return out;
}

}  // namespace tread
