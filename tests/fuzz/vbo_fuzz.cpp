// libFuzzer over the reader of .vbo files, and all that follows.
#include <cstddef>
#include <cstdint>

#include "fuzz/import_entry.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    tread::fuzz::importHostileVbo({reinterpret_cast<const char*>(bytes), size});
    return 0;
}
