// What the line that sums a run up takes from the metrics.

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "metrics/metrics.h"
#include "metrics/verdict.h"

namespace tread::metrics_words_test {
namespace {

std::size_t countOf(std::string_view text, std::string_view part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST(MetricsInWords, EveryManoeuvreHasThemInAnOrderOfTheirOwn) {
    for (const Manoeuvre& manoeuvre : manoeuvres()) {
        SCOPED_TRACE(manoeuvre.name);
        std::set<int> ranks;
        for (const MetricDefinition& metric : manoeuvre.definitions()) {
            const Say& say = metric.say;
            EXPECT_EQ(say.rank == 0, say.text.empty()) << metric.name;
            if (say.rank == 0) continue;
            EXPECT_TRUE(ranks.insert(say.rank).second) << metric.name << " has the rank of another";
            EXPECT_EQ(countOf(say.text, "{}"), 1u) << metric.name << " names its number once";
            EXPECT_NE(say.scale, 0) << metric.name;
        }
        EXPECT_FALSE(ranks.empty());
    }
}

// Pages, texts and JSON show them in place of names.
TEST(MetricsInWords, EveryMetricHasATitleOfItsOwnAndADefinition) {
    for (const Manoeuvre& manoeuvre : manoeuvres()) {
        SCOPED_TRACE(manoeuvre.name);
        std::set<std::string> titles;
        for (const MetricDefinition& metric : manoeuvre.definitions()) {
            ASSERT_FALSE(metric.title.empty()) << metric.name;
            EXPECT_TRUE(metric.title[0] >= 'A' && metric.title[0] <= 'Z') << metric.title;
            EXPECT_EQ(metric.title.find('_'), std::string::npos) << metric.title;
            EXPECT_TRUE(titles.insert(metric.title).second) << metric.title << " is the title of two metrics";
            EXPECT_FALSE(metric.unit.empty()) << metric.name;
            EXPECT_GT(metric.definition.size(), 3u) << metric.name;
        }
    }
}

TEST(MetricsInWords, ResultsComeBeforeTheConditionsOfTheTest) {
    const std::vector<Metric> sorted = resultsFirst({{"initial_speed", 20, "m/s", ""},
                                                     {"undefined", std::nan(""), "m", "", {3, "{} m"}},
                                                     {"mfdd", 8, "m/s2", "", {2, "{}"}},
                                                     {"distance", 40, "m", "", {1, "{} m"}, "Stopping distance"}});
    ASSERT_EQ(sorted.size(), 3u);
    EXPECT_EQ(titleOf(sorted[0]), "Stopping distance");
    EXPECT_EQ(sorted[1].name, "mfdd");
    EXPECT_EQ(titleOf(sorted[2]), "initial speed") << "a metric without title";
}

Verdict verdictOn(const Metric& metric, const std::string& condition) {
    return judge({{{metric.name, condition}}}, {metric}).at(0);
}

TEST(Verdicts, AreSaidInTheUnitOfTheirConditionWithTheirMargin) {
    const Metric ratio{"ratio", 0.123, "-", ""}, way{"way", 48.9, "m", ""}, speed{"speed", 25, "m/s", ""};
    EXPECT_EQ(text(verdictOn(ratio, "<= 35 %")), "ratio: 12.3 %, required <= 35 %: met, 22.7 % to spare");
    EXPECT_EQ(text(verdictOn(way, "< 40 m")), "way: 48.9 m, required < 40 m: missed, 8.9 m beyond");
    EXPECT_EQ(text(verdictOn(way, ">= 40 m")), "way: 48.9 m, required >= 40 m: met, 8.9 m to spare");
    EXPECT_EQ(text(verdictOn(way, "< 40")), "way: 48.9 m, required < 40: missed, 8.9 m beyond");
    EXPECT_EQ(text(verdictOn(speed, "80 .. 100 km/h")),
              "speed: 90 km/h, required 80 .. 100 km/h: met, 10 km/h to spare");
    EXPECT_EQ(text(verdictOn(speed, "88 km/h +- 5 %")),
              "speed: 90 km/h, required 88 km/h +- 5 %: met, 2.4 km/h to spare");
    EXPECT_NEAR(*verdictOn(speed, "< 108 km/h").margin, 5, 1e-12) << "in the unit of the metric";
}

TEST(Verdicts, HaveNoMarginWhereThereIsNone) {
    const Metric cones{"cones", 0, "-", ""}, undefined{"cones", std::nan(""), "-", ""};
    EXPECT_EQ(text(verdictOn(cones, "= 0")), "cones: 0, required = 0: met");
    EXPECT_FALSE(verdictOn(cones, "= 0").margin);
    EXPECT_EQ(text(verdictOn(undefined, "< 2")), "cones: could not be computed, required < 2: missed");
}

}  // namespace
}  // namespace tread::metrics_words_test
