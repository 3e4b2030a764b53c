// Files that the build turns into constants: libraries as Debian packages them, and the page's own styles and scripts.
#pragma once

#include <string_view>

namespace tread::embedded {

extern const std::string_view kDygraphsScript;
extern const std::string_view kDygraphsStyle;
extern const std::string_view kDygraphsSynchronizer;
extern const std::string_view kDygraphsLicence;
extern const std::string_view kThreeScript;
extern const std::string_view kThreeOrbit;
extern const std::string_view kThreeLicence;
extern const std::string_view kPageStyle;
extern const std::string_view kValuesScript;
extern const std::string_view kChartsScript;
extern const std::string_view kReplayStyle;
extern const std::string_view kReplayCarScript;
extern const std::string_view kReplayRoadScript;
extern const std::string_view kReplayScript;

}  // namespace tread::embedded
