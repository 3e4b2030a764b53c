// libFuzzer over the log reader.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/csv_entry.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    tread::fuzz::readHostileCsv({reinterpret_cast<const char*>(bytes), size});
    return 0;
}
