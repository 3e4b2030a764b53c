// Asks the processor for the memory of the car that comes next, while this one is computed: in a world of many cars a
// step would else wait for it half of the time.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace tread {

// Bytes that are read soon. Nothing happens if they are not there any more.
inline void fetchAhead(const void* begin, std::size_t bytes) {
    constexpr std::size_t kLine = 64;
    const char* at = static_cast<const char*>(begin);
    for (std::size_t i = 0; i < bytes; i += kLine) __builtin_prefetch(at + i);
}

struct Block {
    const void* begin = nullptr;
    std::size_t bytes = 0;

    void fetch() const { fetchAhead(begin, bytes); }
};

// Where a car lies. Addresses only: it may be gone.
struct Footprint {
    static constexpr std::size_t kWheels = 4;  // of most cars; the others' faces come when they are asked for

    const void* car = nullptr;
    const void* chassis = nullptr;
    const void* wheels = nullptr;
    std::size_t wheel_count = 0;
    std::array<Block, kWheels> faces{};  // of the ground near the wheels
};

// The cars in the order in which a world steps them, which is the same every time.
class Trail {
public:
    // Notes a car that steps now; which one came after it in the last round.
    const Footprint& after(const Footprint& car) {
        const bool begins = !cars_.empty() && cars_.front().car == car.car;
        if (begins || at_ == kMost) at_ = 0;
        if (at_ == cars_.size()) cars_.push_back(car);
        else cars_[at_] = car;
        ++at_;
        return cars_[at_ < cars_.size() ? at_ : 0];
    }

private:
    static constexpr std::size_t kMost = 1 << 14;  // cars; of more the first ones are noted anew
    std::vector<Footprint> cars_;
    std::size_t at_ = 0;
};

}  // namespace tread
