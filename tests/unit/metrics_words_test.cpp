// What the line that sums a run up takes from the metrics.

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "metrics/metrics.h"

namespace tread {
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

}  // namespace
}  // namespace tread
