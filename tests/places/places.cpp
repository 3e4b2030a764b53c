#include "places/places.h"

namespace tread {

std::string sourceFile(const std::string& path) {
    return TREAD_SOURCE_DIR + (path.empty() ? path : "/" + path);
}

std::string programFile() {
    return TREAD_PROGRAM;
}

}  // namespace tread
