// Asks the processor for the memory of the car that comes next, while this one is computed: in a world of many cars a
// step would else wait for it half of the time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tread {

// An address is a number here: what lies there may be gone, and is never read.
using Address = std::uintptr_t;
inline Address addressOf(const void* of) {
    return reinterpret_cast<Address>(of);
}

// Bytes that are read soon. Nothing happens if they are not there any more.
inline void fetchAhead(Address begin, std::size_t bytes) {
    constexpr std::size_t kLine = 64;
    for (std::size_t i = 0; i < bytes; i += kLine) __builtin_prefetch(reinterpret_cast<const void*>(begin + i));
}

struct Block {
    Address begin = 0;
    std::size_t bytes = 0;

    void fetch() const { fetchAhead(begin, bytes); }
};

// Where a car lies; nowhere: there is none.
struct Footprint {
    static constexpr std::size_t kWheels = 4;  // of most cars; the others' faces come when they are asked for

    Address car = 0;
    Address chassis = 0;
    Address wheels = 0;
    std::size_t wheel_count = 0;
    std::array<Block, kWheels> faces{};  // of the ground near the wheels
};

// The cars that a thread steps, in the order in which it does, which is the same every time.
class Trail {
public:
    // Notes that a car steps now, at its place of the last round, which it keeps; which one came after it then.
    const Footprint& after(const Footprint& car, std::size_t& place) {
        bool known = place < cars_.size() && cars_[place].car == car.car;
        if (known && place < at_) known = beginRound(place);
        if (!known || place > at_) place = at_;  // a new car, or one whose forerunner is gone
        if (place == cars_.size()) cars_.push_back(car);
        cars_[place] = car;
        at_ = place + 1;
        return cars_[at_ < cars_.size() ? at_ : first_];
    }

private:
    // False if all are noted anew, since most are gone.
    bool beginRound(std::size_t place) {
        constexpr std::size_t kFew = 64;
        cars_.resize(at_);  // what lies beyond the end of the last round is gone
        first_ = place;     // and what lies before this one
        if (first_ <= at_ - first_ + kFew) return true;
        cars_.clear();
        first_ = at_ = 0;
        return false;
    }

    std::vector<Footprint> cars_;
    std::size_t at_ = 0;     // after the car that stepped last
    std::size_t first_ = 0;  // where this round began
};

}  // namespace tread
