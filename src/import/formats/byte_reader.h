// Numbers and texts from the front of some bytes that may end too early: then they are 0 and empty, and ok() says so.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

namespace tread {

class ByteReader {
public:
    explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

    bool ok() const { return ok_; }
    std::size_t size() const { return bytes_.size(); }
    std::size_t place() const { return place_; }
    std::size_t left() const { return bytes_.size() - place_; }
    std::string_view rest() const { return bytes_.substr(place_); }
    void fail() { ok_ = false; }

    std::string_view take(std::uint64_t size) {
        if (!ok_ || size > left()) {
            ok_ = false;
            return {};
        }
        const std::string_view taken = bytes_.substr(place_, static_cast<std::size_t>(size));
        place_ += taken.size();
        return taken;
    }

    template <class T>
    T number(bool big_endian = false) {
        static_assert(std::is_integral_v<T>);
        const std::string_view raw = take(sizeof(T));
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < raw.size(); ++i) {
            const std::size_t at = big_endian ? i : raw.size() - 1 - i;
            bits = bits << 8 | static_cast<unsigned char>(raw[at]);
        }
        return static_cast<T>(bits);
    }

    // Behind its length in bytes (u32).
    std::string_view text(bool big_endian = false) { return take(number<std::uint32_t>(big_endian)); }

private:
    std::string_view bytes_;
    std::size_t place_ = 0;
    bool ok_ = true;
};

}  // namespace tread
