#include "vehicle/sound_state.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

namespace tread {
namespace {

// The first byte of an object: a bool that was made of other bytes than 0 and 1 must not be read as one.
unsigned char byteOf(const bool& object) {
    unsigned char byte = 0;
    std::memcpy(&byte, &object, 1);
    return byte;
}

using Phase = AntiLockState::Phase;

int numberOf(const Phase& object) {
    std::underlying_type_t<Phase> number{};
    std::memcpy(&number, &object, sizeof number);
    return number;
}

// A delay of which a point is due at most some seconds ago: with a larger age the line never ends to be filled.
constexpr double kOldest = 10;

bool isSound(const DelayLine& line) {
    return line.newest < line.past.size() && line.age >= 0 && line.age < kOldest;
}

}  // namespace

bool isSound(const VehicleState& state, const VehicleParams& params) {
    const int gears = std::max(1, static_cast<int>(params.driveline.gearbox.ratios.size()));
    bool sound = state.driveline.gear >= 1 && state.driveline.gear <= gears && byteOf(state.steering.hands_off) <= 1 &&
                 isSound(state.steering.delay) && isSound(state.brakes.pedal);
    for (std::size_t i = 0; i < kWheels; ++i) {
        const int phase = numberOf(state.brakes.anti_lock.wheels[i].phase);
        sound = sound && phase >= 0 && phase <= static_cast<int>(Phase::build);
    }
    return sound;
}

}  // namespace tread
