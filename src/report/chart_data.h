// The values of a time chart as the page's script reads them.
#pragma once

#include <string>

#include "report/html.h"

namespace tread {

// A JSON object: time as Float64 and curves as Float32, little-endian, base64. No "<" in it, so that it can stand
// inside a script element.
std::string chartData(const TimeChart& chart);

}  // namespace tread
