// A self-contained HTML page: sections, tables, time charts that share one cursor and one zoom, static figures. Works
// without a network: style, script, chart library and values are all inside the file. Every string is escaped.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "report/svg.h"

namespace tread {

// Curves over one time base. The page copies what it draws: at most about 4000 samples of a curve, no peak lost.
struct TimeChart {
    struct Curve {
        std::string name;
        std::span<const double> values;
        double scale = 1;  // from the unit of the values to the unit that is shown
        Colour colour = Colour::automatic;
        bool dashed = false;
        double width = 1.5;  // pixels
    };
    struct Envelope {  // shaded from low to high, behind the curves
        std::string name;
        std::span<const double> low, high;
        double scale = 1;
        Colour colour = Colour::grey;
    };
    std::string title;
    std::string unit;  // as shown
    std::span<const double> time;
    std::vector<Curve> curves;
    std::optional<Envelope> envelope = {};
    double band = 0;                 // half width of a shaded band around zero, 0 for none
    std::vector<double> marks = {};  // vertical lines at these moments
};

// Good and bad news have a sign and a colour of their own.
enum class Tone { plain, good, bad };

struct Card {  // one number to see first
    std::string label;
    std::string value;
    std::string unit;
    std::string note = {};  // a small line below the number
    Tone tone = Tone::plain;
};

struct Link {
    std::string text;
    std::string address;  // relative to the page
};

// Filling of a part of a bar: a colour and a pattern, which differ in grey too.
enum class Fill { none, pale, blue, sky, purple, striped, warm, dotted };

// One horizontal bar of several parts.
struct PartedBar {
    struct Piece {
        std::string name;
        std::string value;  // as written: "43 %"
        double length = 0;  // 0 to 1
        Fill fill = Fill::none;
    };
    std::string title;
    std::vector<Piece> pieces;
};

struct Cell {
    std::string text;
    bool number = false;     // aligned to the right
    bool alarm = false;      // drawn as bad news
    std::string link = {};   // address, relative to the page
    double heat = 0;         // 0 to 1: strength of the cell's colour, in a heat map
    double bar = 0;          // 0 to 1: length of a bar behind the text
    Fill fill = Fill::none;  // of a small square before the text
    bool good_news = false;  // drawn as good news
    std::string note = {};   // a small line below the text
};

class HtmlPage {
public:
    // `headline`: follows the title in the title of the window. What settings have changed of what the title says
    // (base/text/changed.h) stands below it in a line of its own.
    explicit HtmlPage(std::string title, std::string_view headline = {});

    // The top of the page: the answer in one sentence; `verdict` (may be empty) is a word that is green when good, else
    // red.
    void answer(std::string_view sentence, std::string_view verdict = {}, bool good = true);
    void cards(const std::vector<Card>& cards);
    void keyValues(const std::vector<std::pair<std::string, std::string>>& pairs);
    void links(std::string_view title, const std::vector<Link>& links);
    void warnings(const std::vector<std::string>& sentences);

    void section(std::string_view title);  // appears in the table of contents
    void text(std::string_view paragraph);
    // With `prose_last`, the last column holds sentences: on a narrow screen it stands below the others.
    void table(const std::vector<std::string>& header, const std::vector<std::vector<Cell>>& rows,
               bool prose_last = false);
    // Charts without curves or time are left out. Charts of one stack stand beneath each other.
    void timeCharts(const std::vector<TimeChart>& charts);
    void stackedTimeCharts(const std::vector<std::vector<TimeChart>>& stacks);
    void figures(const std::vector<Chart>& charts);
    // Cars on their road, from replayData(); at most one on a page.
    void replay(std::string data);
    void bar(const PartedBar& bar);
    // What follows is folded away under a title, until unfold().
    void fold(std::string_view title);
    void unfold();
    void bullets(const std::vector<std::string>& sentences);
    void collapsible(std::string_view title, std::string_view verbatim);

    std::string finish() const;

private:
    std::string title_;
    std::string window_title_;
    std::string head_;      // answer, cards, key values, warnings
    std::string contents_;  // links to the sections
    std::string body_;      // the sections
    std::string charts_;    // JSON objects of the time charts, separated by commas
    std::string replay_;    // JSON
    std::size_t sections_ = 0;
    std::size_t time_charts_ = 0;

    void addTimeChart(const TimeChart& chart);
    std::vector<std::string_view> programs() const;
    std::string scripts() const;
    std::string& place() { return sections_ == 0 ? head_ : body_; }
};

}  // namespace tread
