// libFuzzer over the reader of MATLAB files, and all that follows: any bytes, and files with plain and with compressed
// variables.
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
    importHostileMatFile(MatWriter(told).file());
    importHostileMatFile(MatWriter(told).file(deflated));
    return 0;
}
