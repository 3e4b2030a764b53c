// libFuzzer over the reader of binary logs.
#include <cstddef>
#include <cstdint>

#include "fuzz/binary_log_entry.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    tread::fuzz::readHostileBinaryLog({reinterpret_cast<const char*>(bytes), size});
    return 0;
}
