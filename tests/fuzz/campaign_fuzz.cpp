// libFuzzer over the reader of campaigns.
#include <cstddef>
#include <cstdint>

#include "fuzz/campaign_entry.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    tread::fuzz::readHostileCampaign({reinterpret_cast<const char*>(bytes), size});
    return 0;
}
