// Files that the build turns into constants: the chart library as Debian packages it, and the page's own style and
// script.
#pragma once

#include <string_view>

namespace tread::embedded {

extern const std::string_view kDygraphsScript;
extern const std::string_view kDygraphsStyle;
extern const std::string_view kDygraphsSynchronizer;
extern const std::string_view kDygraphsLicence;
extern const std::string_view kPageStyle;
extern const std::string_view kPageScript;

}  // namespace tread::embedded
