// libFuzzer over the reader of answers to blind cases.
#include <cstddef>
#include <cstdint>

#include "fuzz/answer_entry.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    tread::fuzz::readHostileAnswer({reinterpret_cast<const char*>(bytes), size});
    return 0;
}
