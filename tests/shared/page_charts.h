// The time charts of a page, as its script reads them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "shared/base64.h"

namespace tread {

inline nlohmann::json chartsOf(const std::string& page) {
    const std::string begin = "<script id=\"chart-data\" type=\"application/json\">";
    const auto from = page.find(begin);
    if (from == std::string::npos) return nlohmann::json::array();
    const auto to = page.find("</script>", from);
    return nlohmann::json::parse(page.substr(from + begin.size(), to - from - begin.size()));
}

}  // namespace tread
