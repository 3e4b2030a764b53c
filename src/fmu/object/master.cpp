#include "fmu/object/master.h"

#include <cstring>

#include "base/text/concat.h"
#include "host/failure.h"

namespace tread::fmu {
namespace {

int hexDigit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

std::string decoded(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool coded =
            text[i] == '%' && i + 2 < text.size() && hexDigit(text[i + 1]) >= 0 && hexDigit(text[i + 2]) >= 0;
        if (!coded) {
            out += text[i];
            continue;
        }
        out += static_cast<char>(16 * hexDigit(text[i + 1]) + hexDigit(text[i + 2]));
        i += 2;
    }
    return out;
}

}  // namespace

std::filesystem::path pathOf(std::string_view uri) {
    constexpr std::string_view kScheme = "file:";
    if (!uri.starts_with(kScheme)) return uri;
    uri.remove_prefix(kScheme.size());
    if (uri.starts_with("//")) {
        // Behind the name of the host, which is this one.
        uri.remove_prefix(2);
        const std::size_t slash = uri.find('/');
        if (slash != std::string_view::npos) uri.remove_prefix(slash);
    }
    return decoded(uri);
}

void writeBytes(const Instance& instance, const void* handle, void* bytes, std::size_t size) {
    if (!handle) host::refuse("found no state, expected one of this FMU");
    const std::vector<std::byte> state = instance.serialise(*static_cast<const Instance::Saved*>(handle));
    if (size < state.size())
        host::refuse(
            concat({"found room for ", std::to_string(size), " bytes, expected ", std::to_string(state.size())}));
    std::memcpy(bytes, state.data(), state.size());
}

void readBytes(const Instance& instance, const void* bytes, std::size_t size, void*& handle) {
    handle = nullptr;
    keep(handle, instance.deserialise(std::span(static_cast<const std::byte*>(bytes), size)));
}

}  // namespace tread::fmu
