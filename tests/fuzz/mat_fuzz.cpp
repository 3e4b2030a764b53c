// libFuzzer over the reader of MATLAB files, and all that follows. Compressed variables must give what plain ones give.
#include <zlib.h>

#include <cstddef>
#include <cstdint>

#include "fuzz/mat_entry.h"

namespace {

std::string deflated(const std::string& content) {
    uLongf size = compressBound(content.size());
    std::string text(size, '\0');
    tread::fuzz::demand(compress2(reinterpret_cast<Bytef*>(text.data()), &size,
                                  reinterpret_cast<const Bytef*>(content.data()), content.size(), 1) == Z_OK);
    text.resize(size);
    return text;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace tread::fuzz;
    const std::string_view told(reinterpret_cast<const char*>(bytes), size);
    importHostileMatFile(told);
    const bool plain = importHostileMatFile(MatWriter(told).file());
    demand(plain == importHostileMatFile(MatWriter(told).file(deflated)));
    return 0;
}
