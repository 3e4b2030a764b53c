// libFuzzer over the YAML reader.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/yaml_entry.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    tread::fuzz::readHostileYaml({reinterpret_cast<const char*>(bytes), size});
    return 0;
}
