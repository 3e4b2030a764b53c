// Results as JUnit's XML, which CI servers show as tests.
#pragma once

#include <string>
#include <vector>

namespace tread {

struct JUnitCase {
    std::string group;         // scenario
    std::string name;          // what was asked
    std::string failure = {};  // why it was not so; empty: it was
    std::string error = {};    // why nobody knows; empty: it is known
};

std::string junit(const std::string& suite, const std::vector<JUnitCase>& cases);

}  // namespace tread
