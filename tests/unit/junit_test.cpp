#include "report/junit.h"

#include <gtest/gtest.h>

namespace tread::junit_test {
namespace {

TEST(JUnit, CountsAndEscapes) {
    EXPECT_EQ(junit("tread run", {{"a", "run"}, {"a", "d < 40 m", "d: 41 m & more"}, {"b", "run", "", "no \"road\""}}),
              "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
              "<testsuite name=\"tread run\" tests=\"3\" failures=\"1\" errors=\"1\">\n"
              "  <testcase classname=\"a\" name=\"run\"/>\n"
              "  <testcase classname=\"a\" name=\"d &lt; 40 m\"><failure message=\"d: 41 m &amp; more\"/></testcase>\n"
              "  <testcase classname=\"b\" name=\"run\"><error message=\"no &quot;road&quot;\"/></testcase>\n"
              "</testsuite>\n");
}

}  // namespace
}  // namespace tread::junit_test
