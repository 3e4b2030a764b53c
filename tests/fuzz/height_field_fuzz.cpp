// Any bytes: the height field reader either gives a surface that is finite everywhere or says what is wrong.
#include <cstddef>
#include <cstdint>

#include "fuzz/height_field_entry.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    tread::fuzz::readHostileHeights({reinterpret_cast<const char*>(bytes), size});
    return 0;
}
