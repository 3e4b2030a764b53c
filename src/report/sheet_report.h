// The data sheet of a car as a page.
#pragma once

#include <string>
#include <vector>

#include "sheet/sheet.h"

namespace tread {

// "Compact: 1350 kg, 60.7 % on the front axle, ...".
std::string sheetAnswer(const sheet::Sheet& sheet);

struct SheetReport {
    std::string file;
    std::vector<std::string> settings;  // as given
    std::string version;
    sheet::Sheet sheet;
    std::string resolved_yaml;
};
std::string sheetReport(const SheetReport& content);

}  // namespace tread
