// libFuzzer over the reader of pieces of a campaign.
#include <cstddef>
#include <cstdint>

#include "fuzz/campaign_entry.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    tread::fuzz::readHostilePiece({reinterpret_cast<const char*>(bytes), size});
    return 0;
}
