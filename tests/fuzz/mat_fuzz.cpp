// libFuzzer over the check that guards matio: any bytes end in an answer. What matio itself makes of a file that is
// whole but damaged is not ours to fuzz.
#include <cstddef>
#include <cstdint>

#include "import/formats/mat_whole.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    tread::matFault({reinterpret_cast<const char*>(bytes), size});
    return 0;
}
