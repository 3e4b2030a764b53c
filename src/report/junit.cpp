#include "report/junit.h"

#include <fmt/format.h>

#include <algorithm>

namespace tread {
namespace {

// Control characters cannot stand in XML at all.
std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
        }
    }
    return out;
}

std::string element(const JUnitCase& one) {
    const std::string start =
        fmt::format("  <testcase classname=\"{}\" name=\"{}\"", escaped(one.group), escaped(one.name));
    if (!one.error.empty()) return fmt::format("{}><error message=\"{}\"/></testcase>\n", start, escaped(one.error));
    if (!one.failure.empty())
        return fmt::format("{}><failure message=\"{}\"/></testcase>\n", start, escaped(one.failure));
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
        escaped(suite), cases.size(), failures, errors);
    for (const JUnitCase& one : cases) out += element(one);
    return out + "</testsuite>\n";
}

}  // namespace tread
