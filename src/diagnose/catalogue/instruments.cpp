// Effects of the instruments that recorded the car. They change the readings, or the recorded inputs, but not the car.

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "base/fields/numbers.h"
#include "diagnose/catalogue/catalogue.h"
#include "recording/further_instruments.h"
#include "recording/position.h"

namespace tread::diagnose::catalogue {
namespace {

// Numbers of the further instruments of one source by the paths of the same numbers of the first instruments.
using NumbersOfSource = std::multimap<std::string, std::string>;

// True for numbers that cannot be wrong by as much as those of other instruments: a heading grows by a whole turn in a
// whole turn and does not drift, and GPS and motion capture measure lengths to a thousandth.
bool isCertain(std::string_view path) {
    constexpr std::array<std::string_view, 4> kCertain{"chassis.yaw_rate@position.gain",
                                                       "chassis.yaw_rate@position.bias", "chassis.vx@position.gain",
                                                       "chassis.vy@position.gain"};
    static_assert(recording::kPositionSource == "position");
    return std::any_of(kCertain.begin(), kCertain.end(), [&](std::string_view one) {
        return path.starts_with("instruments.further.") && path.ends_with(one);
    });
}

std::map<std::string, NumbersOfSource> bySource(recording::Instruments instruments) {
    std::map<std::string, NumbersOfSource> sources;
    for (const Number& number : numbers(instruments, "instruments")) {
        const std::string source(recording::sourceOfPath(number.path));
        if (!source.empty() && !isCertain(number.path))
            sources[source].emplace(recording::pathInFirst(number.path), number.path);
    }
    return sources;
}

Effect ofSource(const Effect& effect, const std::string& source, const NumbersOfSource& numbers) {
    Effect further = effect;
    further.name += "@" + source;
    further.question += " (instruments of " + source + ")";
    for (Knob& knob : further.knobs) {
        knob.paths.clear();
        for (const std::string& path : effect.knobs[static_cast<std::size_t>(&knob - further.knobs.data())].paths) {
            const auto [first, last] = numbers.equal_range(path);
            std::transform(first, last, std::back_inserter(knob.paths), [](const auto& one) { return one.second; });
        }
    }
    std::erase_if(further.knobs, [](const Knob& knob) { return knob.paths.empty(); });
    return further;
}

}  // namespace

std::vector<Effect> instrumentEffects() {
    return {
        {.name = "gyro_bias",
         .question = "Does the yaw-rate gyro have a zero offset?",
         .source = "guess: 0.3 deg/s for automotive gyros not zeroed at standstill",
         .knobs = {{.paths = {"instruments.yaw_rate.bias"}, .typical = 0.005}}},
        {.name = "gyro_scale",
         .question = "Does the yaw-rate gyro have a scale error?",
         .source = "guess: 2 to 3 % for uncalibrated automotive gyros",
         .knobs = {{.paths = {"instruments.yaw_rate.gain"}, .typical = 0.03}}},
        {.name = "accelerometer_bias",
         .question = "Do the accelerometers have a zero offset or a tilt?",
         .source = "guess: 0.01 to 0.02 g",
         .knobs = {{.paths = {"instruments.ax.bias"}, .typical = 0.15},
                   {.paths = {"instruments.ay.bias"}, .typical = 0.15}}},
        {.name = "accelerometer_scale",
         .question = "Do the accelerometers have a scale error?",
         .source = "guess: 2 to 3 %",
         .knobs = {{.paths = {"instruments.ax.gain"}, .typical = 0.03},
                   {.paths = {"instruments.ay.gain"}, .typical = 0.03}}},
        {.name = "accelerometer_gravity",
         .question = "Do the accelerometers read gravity when the body rolls and pitches?",
         .source = "definition: 1 is a unit fixed to the body, without correction",
         .knobs = {{.paths = {"instruments.inertial_unit.fixed_to_body"}, .typical = 1, .direction = Direction::up}}},
        {.name = "accelerometer_position",
         .question = "Are the accelerometers mounted away from their stated position?",
         .source = "guess: boot or dashboard instead of the middle of the car",
         .knobs = {{.paths = {"instruments.inertial_unit.x"}, .typical = 0.5},
                   {.paths = {"instruments.inertial_unit.z"}, .typical = 0.25}}},
        {.name = "sensor_delay",
         .question = "Do the inertial sensors lag behind the steering signal (filters, bus)?",
         .source = "guess: 10 to 50 ms",
         .knobs = {{.paths = {"instruments.ax.delay", "instruments.ay.delay", "instruments.yaw_rate.delay",
                              "instruments.roll_rate.delay"},
                    .typical = 0.03,
                    .direction = Direction::up}}},
        {.name = "yaw_rate_delay",
         .question = "Does the yaw rate lag behind the other signals?",
         .source = "guess: 10 to 50 ms",
         .knobs = {{.paths = {"instruments.yaw_rate.delay"}, .typical = 0.03, .direction = Direction::up}}},
        {.name = "acceleration_delay",
         .question = "Do the accelerations lag behind the other signals?",
         .source = "guess: 10 to 50 ms",
         .knobs = {{.paths = {"instruments.ax.delay", "instruments.ay.delay"},
                    .typical = 0.03,
                    .direction = Direction::up}}},
        {.name = "roll_delay",
         .question = "Do roll angle and roll rate lag behind the other signals?",
         .source = "guess: 10 to 50 ms",
         .knobs = {{.paths = {"instruments.roll.delay", "instruments.roll_rate.delay"},
                    .typical = 0.03,
                    .direction = Direction::up}}},
        {.name = "sideslip_delay",
         .question = "Does the sideslip angle or lateral velocity lag behind the other signals?",
         .source = "guess: 10 to 50 ms",
         .knobs = {{.paths = {"instruments.sideslip.delay"}, .typical = 0.03, .direction = Direction::up}}},
        {.name = "wheel_speed_delay",
         .question = "Do the wheel speeds lag behind the other signals?",
         .source = "guess: 10 to 50 ms",
         .knobs = {{.paths = {"instruments.wheel_speed.delay"}, .typical = 0.03, .direction = Direction::up}}},
        {.name = "speed_scale",
         .question = "Does the speed over ground have a scale error?",
         .source = "guess: 2 to 3 % for wheel pulses; GPS is better",
         .knobs = {{.paths = {"instruments.speed.gain"}, .typical = 0.03}}},
        {.name = "speed_delay",
         .question = "Is the speed over ground delayed?",
         .source = "guess: 0.1 to 0.2 s for GPS",
         .knobs = {{.paths = {"instruments.speed.delay"}, .typical = 0.1, .direction = Direction::up}}},
        {.name = "wheel_speed_scale",
         .question = "Do the wheel speeds have a scale error?",
         .source = "guess: 2 %, from a wrong radius in the control unit's conversion",
         .knobs = {{.paths = {"instruments.wheel_speed.gain"}, .typical = 0.02}}},
        {.name = "sideslip_zero",
         .question = "Does the sideslip sensor have a zero offset (misalignment)?",
         .source = "guess: 0.5 deg",
         .knobs = {{.paths = {"instruments.sideslip.bias"}, .typical = 0.01}}},
    };
}

std::vector<Effect> furtherInstrumentEffects(const recording::Instruments& instruments) {
    std::vector<Effect> effects;
    for (const auto& [source, numbers] : bySource(instruments)) {
        for (const Effect& effect : instrumentEffects()) {
            Effect further = ofSource(effect, source, numbers);
            if (!further.knobs.empty()) effects.push_back(std::move(further));
        }
    }
    return effects;
}

}  // namespace tread::diagnose::catalogue
