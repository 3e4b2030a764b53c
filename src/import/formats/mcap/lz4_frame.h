// LZ4 frames ("LZ4 Frame Format Description" and "LZ4 Block Format Description", lz4.org), as chunks of MCAP files have
// them. Checksums are not looked at: MCAP has its own.
#pragma once

#include <cstddef>
#include <string_view>

#include "log/mcap_format.h"

namespace tread {

// What a frame holds, at most `most` bytes; one that is cut off or damaged gives what is in front of that place.
mcap::Unpacked unpackedLz4(std::string_view frame, std::size_t most);

}  // namespace tread
