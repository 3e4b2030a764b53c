// libFuzzer over the reader of expressions.
#include <cstddef>
#include <cstdint>

#include "fuzz/expression_entry.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    tread::fuzz::readHostileExpression({reinterpret_cast<const char*>(bytes), size});
    return 0;
}
