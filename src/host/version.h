// The version of this tread.
#pragma once

#include <string_view>

namespace tread::host {

std::string_view version();  // "0.1.0"; ends with a zero

}  // namespace tread::host
