// libFuzzer over the states that a car takes from outside.
#include <cstddef>
#include <cstdint>

#include "fuzz/car_state_entry.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    tread::fuzz::takeHostileState({reinterpret_cast<const char*>(bytes), size});
    return 0;
}
