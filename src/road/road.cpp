#include "tread/road.h"

namespace tread {

// Here rather than in the header, so that the virtual table of all roads lies in the library.
Road::~Road() = default;

}  // namespace tread
