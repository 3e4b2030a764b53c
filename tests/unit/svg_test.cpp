#include "report/svg.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>

#include "base/text/markup.h"
#include "report/decimate.h"
#include "report/text.h"
#include "report/ticks.h"
#include "shared/markup.h"

namespace tread::svg_test {
namespace {

using Curves = std::vector<std::span<const double>>;

// The points of the path of the first curve of that colour, in pixels.
std::vector<std::pair<double, double>> points(const std::string& svg, Colour colour) {
    std::vector<std::pair<double, double>> out;
    const std::vector<Tag> tags = readTags(svg).value_or(std::vector<Tag>{});
    for (const Tag& tag : tags) {
        if (tag.name != "path" || !tag.attributes.contains("fill") || tag.attributes.at("stroke") != hex(colour))
            continue;
        std::string data = tag.attributes.at("d");
        for (char& c : data) {
            if (std::isalpha(static_cast<unsigned char>(c))) c = ' ';
        }
        std::istringstream numbers(data);
        double x = 0, y = 0;
        while (numbers >> x >> y) out.emplace_back(x, y);
        break;
    }
    return out;
}

// Every element that opens also closes, in order, and attributes are quoted: what an XML reader insists on.
bool isWellFormed(const std::string& xml) {
    const auto tags = readTags(xml);
    if (!tags) return false;
    std::vector<std::string> open;
    for (const Tag& tag : *tags) {
        if (tag.closes) {
            if (open.empty() || open.back() != tag.name) return false;
            open.pop_back();
        } else if (!tag.closes_itself) {
            open.push_back(tag.name);
        }
    }
    return open.empty();
}

Chart line(std::vector<double> x, std::vector<double> y) {
    Chart chart{.title = "", .x = {"time", "s"}, .y = {"load", "N"}, .series = {}};
    chart.series.push_back({.name = "a", .x = std::move(x), .y = std::move(y), .colour = Colour::blue});
    return chart;
}

TEST(Ticks, StepsAreOneTwoOrFiveTimesAPowerOfTen) {
    EXPECT_DOUBLE_EQ(niceStep(10, 10), 1);
    EXPECT_DOUBLE_EQ(niceStep(10, 6), 2);
    EXPECT_DOUBLE_EQ(niceStep(0.9, 2), 0.5);
    EXPECT_DOUBLE_EQ(niceStep(7.1e4, 7), 2e4);
    EXPECT_DOUBLE_EQ(niceStep(0.003, 3), 0.001) << "rounding must not push an exact fit to the next step";
}

TEST(Ticks, EndsOfTheRangeCarryTicksDespiteRounding) {
    const auto all = ticks({0.1, 0.7}, 0.1);
    ASSERT_EQ(all.size(), 7u);
    EXPECT_NEAR(all.front(), 0.1, 1e-12);
    EXPECT_NEAR(all.back(), 0.7, 1e-12);
}

TEST(Ticks, LabelsOfOneAxisHaveTheSameDecimals) {
    EXPECT_EQ(tickLabel(0, 0.25), "0.0");
    EXPECT_EQ(tickLabel(0.5, 0.5), "0.5");
    EXPECT_EQ(tickLabel(1, 0.5), "1.0");
    EXPECT_EQ(tickLabel(-2000, 1000), "-2000");
    EXPECT_EQ(tickLabel(-1e-17, 0.1), "0.0") << "no minus zero";
}

TEST(Text, MarkupIsHarmlessAndControlCharactersVanish) {
    EXPECT_EQ(escapeMarkup("<a b=\"c\">&'"), "&lt;a b=&quot;c&quot;&gt;&amp;&#39;");
    EXPECT_EQ(escapeMarkup(std::string("a\0b\x1b[31m", 8)), "ab[31m");
    EXPECT_EQ(escapeMarkup("µ = 1 °"), "µ = 1 °");
}

TEST(Text, AnglesAreShownInDegreesWhateverTheyAreDividedBy) {
    EXPECT_EQ(displayUnit("rad").unit, "deg");
    EXPECT_NEAR(displayUnit("rad").scale, 57.29577951308232, 1e-12);
    EXPECT_EQ(displayUnit("rad/s", "chassis.yaw_rate").unit, "deg/s");
    EXPECT_EQ(displayUnit("rad/(m/s2)").unit, "deg/(m/s2)");
    EXPECT_EQ(displayUnit("N").scale, 1);
    for (const char* unit : {"1/rad", "N m/rad", "rad2", "radish"}) {
        EXPECT_EQ(displayUnit(unit).unit, unit);
        EXPECT_EQ(displayUnit(unit).scale, 1) << unit;
    }
}

TEST(Text, ThingsThatSpinAreShownInRevolutionsPerMinute) {
    for (const char* channel : {"wheel.front_left.spin", "driveline.engine_speed"}) {
        const DisplayUnit shown = displayUnit("rad/s", channel);
        EXPECT_EQ(shown.unit, "rev/min") << channel;
        EXPECT_NEAR(100 * shown.scale, 954.9296585513720, 1e-9);
    }
}

TEST(Text, ConversionsOnRequestLeaveForeignUnitsAlone) {
    EXPECT_DOUBLE_EQ(displayUnitAs("m/s", "km/h").scale, 3.6);
    EXPECT_EQ(displayUnitAs("m/s", "deg").unit, "m/s");
    EXPECT_EQ(displayUnitAs("m/s", "deg").scale, 1);
}

TEST(Text, NumbersAndUnitsReadAsPeopleWriteThem) {
    EXPECT_EQ(formatNumber(12345.6), "12346");
    EXPECT_EQ(formatNumber(0.00123456), "0.001235");
    EXPECT_EQ(formatNumber(2.5e9), "2.5e+09");
    EXPECT_EQ(formatNumber(-0.0), "0");
    EXPECT_EQ(formatNumber(std::nan("")), "–");
    EXPECT_EQ(prettyUnit("m/s2"), "m/s²");
    EXPECT_EQ(prettyUnit("kg m2"), "kg·m²");
    EXPECT_EQ(withUnit("load", "N"), "load [N]");
    EXPECT_EQ(withUnit("slip", "-"), "slip");
}

TEST(Decimate, ShortCurvesStayWhole) {
    const std::vector<double> curve = {3, 1, 2};
    EXPECT_EQ(keepExtremes(Curves{curve}, 3), (std::vector<std::size_t>{0, 1, 2}));
}

TEST(Decimate, EveryPeakOfEveryCurveStays) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> noise(-1, 1);
    std::vector<double> a(100000), b(100000);
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = noise(random), b[i] = noise(random);
    a[54321] = 9;
    b[12345] = -9;
    const auto kept = keepExtremes(Curves{a, b}, 4000);
    EXPECT_LE(kept.size(), 4002u);
    EXPECT_GT(kept.size(), 3000u);
    EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
    EXPECT_EQ(kept.front(), 0u);
    EXPECT_EQ(kept.back(), 99999u);
    EXPECT_TRUE(std::binary_search(kept.begin(), kept.end(), 54321u));
    EXPECT_TRUE(std::binary_search(kept.begin(), kept.end(), 12345u));

    // Between any two kept samples, what was dropped lies within the extremes of the kept ones nearby: compare window
    // by window (a window of two buckets holds at least one whole bucket).
    const std::size_t window = 200;
    for (std::size_t begin = 0; begin + 2 * window <= a.size(); begin += window) {
        const double truth = *std::max_element(a.begin() + begin, a.begin() + begin + window);
        double drawn = -9;
        for (const std::size_t i : kept) {
            if (i + window >= begin && i < begin + 2 * window) drawn = std::max(drawn, a[i]);
        }
        ASSERT_GE(drawn, truth);
    }
}

TEST(Decimate, GapsStayGaps) {
    std::vector<double> curve(50000, 1.0);
    curve[30000] = std::numeric_limits<double>::quiet_NaN();
    const auto kept = keepExtremes(Curves{curve}, 1000);
    EXPECT_TRUE(std::binary_search(kept.begin(), kept.end(), 30000u));
}

TEST(Svg, ASpikeOfOneSampleIsDrawnToItsFullHeight) {
    std::vector<double> x(200000), y(200000);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = 1e-3 * static_cast<double>(i), y[i] = 0.1 * std::sin(x[i]);
    y[123456] = 1;
    Chart chart = line(x, y);
    chart.y.lowest = 0;
    chart.y.highest = 1;
    const std::string svg = svgInline(chart);
    const auto drawn = points(svg, Colour::blue);
    ASSERT_FALSE(drawn.empty());
    EXPECT_LT(drawn.size(), 2100u);
    EXPECT_LT(svg.size(), 40000u);
    EXPECT_EQ(std::min_element(drawn.begin(), drawn.end(), [](auto a, auto b) { return a.second < b.second; })->second,
              0)
        << "the value 1 is the top edge of the plot";
}

TEST(Svg, EqualAspectDrawsACircleAsACircle) {
    std::vector<double> x, y;
    for (int i = 0; i <= 360; ++i) x.push_back(3 + 20 * std::cos(i / 57.3)), y.push_back(20 * std::sin(i / 57.3) - 100);
    Chart chart = line(x, y);
    chart.equal_aspect = true;
    const auto drawn = points(svgInline(chart), Colour::blue);
    ASSERT_GT(drawn.size(), 100u);
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
    for (const auto& [px, py] : drawn) {
        left = std::min(left, px), right = std::max(right, px), top = std::min(top, py), bottom = std::max(bottom, py);
    }
    EXPECT_NEAR(right - left, bottom - top, 0.3);  // pixels; coordinates are rounded to 0.1
    EXPECT_GT(right - left, 200);
}

TEST(Svg, UpIsUp) {
    const auto drawn = points(svgInline(line({0, 1}, {0, 5})), Colour::blue);
    ASSERT_EQ(drawn.size(), 2u);
    EXPECT_LT(drawn[0].first, drawn[1].first);
    EXPECT_GT(drawn[0].second, drawn[1].second) << "pixels count downwards";
}

TEST(Svg, AValueThatIsNotFiniteInterruptsTheLine) {
    const double gap = std::numeric_limits<double>::quiet_NaN();
    const std::string svg = svgInline(line({0, 1, 2, 3, 4}, {1, 2, gap, 1, 2}));
    EXPECT_EQ(points(svg, Colour::blue).size(), 4u);
    const std::string data = svg.substr(svg.find("d=\"M"));
    EXPECT_EQ(count(data.substr(0, data.find('"', 3)), "M"), 2u);
}

TEST(Svg, ChartsWithoutRangeStayReadable) {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const Chart& chart : {Chart{}, line({}, {}), line({1, 1}, {0, 0}), line({0, 1}, {1e9, 1e9}),
                               line({0, 1}, {infinity, -infinity}), line({0}, {5})}) {
        for (Chart each : {chart, chart}) {
            each.equal_aspect = !each.equal_aspect;
            const std::string svg = svgInline(each);
            EXPECT_TRUE(isWellFormed(svg)) << svg;
            EXPECT_EQ(svg.find("nan"), std::string::npos) << svg;
            EXPECT_EQ(svg.find("inf"), std::string::npos) << svg;
        }
    }
}

TEST(Svg, TextIsEscapedAndAxesCarryUnits) {
    Chart chart = line({0, 1}, {0, 1});
    chart.title = "</svg><script>alert(1)</script>";
    chart.series[0].name = "a < b & c";
    chart.labels = {{0.5, 0.5, "<b>"}};
    const std::string svg = svgInline(chart);
    EXPECT_TRUE(isWellFormed(svg)) << svg;
    EXPECT_EQ(svg.find("<script"), std::string::npos);
    EXPECT_NE(svg.find(">a &lt; b &amp; c</text>"), std::string::npos);
    EXPECT_NE(svg.find(">time [s]</text>"), std::string::npos);
    EXPECT_NE(svg.find(">load [N]</text>"), std::string::npos);
}

TEST(Svg, CurvesWithoutAColourDifferFromEachOther) {
    Chart chart = line({0, 1}, {0, 1});
    chart.series.assign(12, {.name = "s", .x = {0, 1}, .y = {0, 1}});
    const std::string svg = svgInline(chart);
    EXPECT_EQ(count(svg, "stroke-dasharray"), 12u) << "six curves dashed, each in the plot and in the legend";
    for (const Colour colour :
         {Colour::blue, Colour::vermillion, Colour::green, Colour::purple, Colour::amber, Colour::sky}) {
        EXPECT_EQ(count(svg, hex(colour)), 4u);
    }
}

}  // namespace
}  // namespace tread::svg_test
