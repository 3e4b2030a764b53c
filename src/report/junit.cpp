#include "report/junit.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text/markup.h"

namespace tread {
namespace {

std::string element(const JUnitCase& one) {
    const std::string start =
        fmt::format("  <testcase classname=\"{}\" name=\"{}\"", escapeMarkup(one.group), escapeMarkup(one.name));
    if (!one.error.empty())
        return fmt::format("{}><error message=\"{}\"/></testcase>\n", start, escapeMarkup(one.error));
    if (!one.failure.empty())
        return fmt::format("{}><failure message=\"{}\"/></testcase>\n", start, escapeMarkup(one.failure));
    return start + "/>\n";
}

}  // namespace

std::string junit(const std::string& suite, const std::vector<JUnitCase>& cases) {
    const auto errors = std::count_if(cases.begin(), cases.end(), [](const auto& one) { return !one.error.empty(); });
    const auto failures = std::count_if(cases.begin(), cases.end(),
                                        [](const auto& one) { return one.error.empty() && !one.failure.empty(); });
    std::string out = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" "
        "errors=\"{}\">\n",
        escapeMarkup(suite), cases.size(), failures, errors);
    for (const JUnitCase& one : cases) out += element(one);
    return out + "</testsuite>\n";
}

}  // namespace tread
