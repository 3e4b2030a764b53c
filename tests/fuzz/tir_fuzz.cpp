// Any bytes: the reader of tyre property files either gives a tyre of finite numbers or says what is wrong.
#include <cstddef>
#include <cstdint>

#include "fuzz/tir_entry.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    tread::fuzz::readHostileTir({reinterpret_cast<const char*>(bytes), size});
    return 0;
}
