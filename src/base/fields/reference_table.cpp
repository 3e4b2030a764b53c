#include "base/fields/reference_table.h"

#include <algorithm>
#include <cmath>

#include "base/fields/implausible.h"
#include "base/text/number_text.h"

namespace tread::detail {

void ReferenceRows::add(const std::string& path, const About& about, std::string limits, std::string default_text) {
    rows.push_back({path, std::string(about.unit), std::string(about.meaning), std::move(limits),
                    std::move(default_text), about.tolerance, usualText(about.usual)});
}

bool ReferenceRows::opens(std::type_index type) {
    if (std::find(open_types.begin(), open_types.end(), type) != open_types.end()) return false;
    open_types.push_back(type);
    return true;
}

std::string defaultText(double value) {
    if (std::isnan(value)) return "required";
    if (std::isinf(value)) return value > 0 ? "unlimited" : "unlimited below";
    return numberText(value);
}

std::string defaultText(int value) {
    return std::to_string(value);
}

std::string defaultText(bool value) {
    return value ? "true" : "false";
}

std::string defaultText(const std::string& value) {
    return value.empty() ? "empty" : value;
}

std::string defaultText(const Curve& value) {
    return value.empty() ? "empty" : std::to_string(value.points.size()) + " points";
}

std::string limitsOf(const About& about) {
    return limitsText(about.limits);
}

}  // namespace tread::detail
