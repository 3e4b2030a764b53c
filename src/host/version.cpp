#include "host/version.h"

namespace tread::host {

std::string_view version() {
    return TREAD_VERSION;
}

}  // namespace tread::host
