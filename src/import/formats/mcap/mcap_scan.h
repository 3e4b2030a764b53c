// The messages of an MCAP file, in the order of the file. It is read from the front, without its index, so that a
// recording that was cut off by a crash gives all that it has.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tread {

struct McapSchema {
    std::uint16_t id = 0;
    std::string name, encoding, text;
};

struct McapChannel {
    std::uint16_t id = 0, schema = 0;  // schema 0: none
    std::string topic, encoding;
};

struct McapMessage {
    std::uint16_t channel = 0;
    std::uint64_t time = 0;  // ns, as logged
    std::string_view bytes;
};

struct McapTaker {
    std::function<void(McapSchema)> schema;
    std::function<void(McapChannel)> channel;
    std::function<void(const McapMessage&)> message;
};

struct McapScan {
    std::string program;             // that has written the file
    std::vector<std::string> notes;  // what could not be read, one clause each
};

// Throws LoadError that names `file` when the bytes are no MCAP file, or hold more than any drive.
McapScan scanMcap(std::string_view bytes, const std::string& file, const McapTaker& taker);

}  // namespace tread
