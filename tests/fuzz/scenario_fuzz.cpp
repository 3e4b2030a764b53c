// libFuzzer over the reader of scenarios.
#include <cstddef>
#include <cstdint>

#include "fuzz/scenario_entry.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    tread::fuzz::readHostileScenario({reinterpret_cast<const char*>(bytes), size});
    return 0;
}
