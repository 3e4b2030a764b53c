// The hash by which a sealed key is known before it is opened, and what is kept on disk is found again.
#pragma once

#include <string>
#include <string_view>

namespace tread {

// SHA-256 (FIPS 180-4) in hexadecimal digits, as `sha256sum` prints it.
std::string sha256(std::string_view bytes);

}  // namespace tread
