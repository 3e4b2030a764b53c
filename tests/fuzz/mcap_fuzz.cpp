// libFuzzer over the reader of MCAP files, with ROS messages, JSON and what packs them, and all that follows.
#include <cstddef>
#include <cstdint>

#include "fuzz/import_entry.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    tread::fuzz::importHostile([&] {
        return tread::parseMcap({reinterpret_cast<const char*>(bytes), size}, "fuzz.mcap");
    });
    return 0;
}
