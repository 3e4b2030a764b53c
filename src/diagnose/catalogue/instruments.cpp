// Effects of the instruments that recorded the car. They change the readings, or the recorded inputs, but not the car.

#include "diagnose/catalogue/catalogue.h"

namespace tread::diagnose::catalogue {

std::vector<Effect> instrumentEffects() {
    return {
        {.name = "gyro_bias",
         .question = "Does the yaw-rate gyro read something at rest?",
         .source = "guess: 0.3 deg/s, automotive gyros without a zero at standstill",
         .knobs = {{.paths = {"instruments.yaw_rate.bias"}, .typical = 0.005}}},
        {.name = "gyro_scale",
         .question = "Does the yaw-rate gyro read too much or too little?",
         .source = "guess: 2 to 3 %, automotive gyros without calibration",
         .knobs = {{.paths = {"instruments.yaw_rate.gain"}, .typical = 0.03}}},
        {.name = "accelerometer_bias",
         .question = "Do the accelerometers read something at rest, or lean?",
         .source = "guess: 10 to 20 mg",
         .knobs = {{.paths = {"instruments.ax.bias"}, .typical = 0.15},
                   {.paths = {"instruments.ay.bias"}, .typical = 0.15}}},
        {.name = "accelerometer_scale",
         .question = "Do the accelerometers read too much or too little?",
         .source = "guess: 2 to 3 %",
         .knobs = {{.paths = {"instruments.ax.gain"}, .typical = 0.03},
                   {.paths = {"instruments.ay.gain"}, .typical = 0.03}}},
        {.name = "accelerometer_position",
         .question = "Do the accelerometers sit elsewhere than said?",
         .source = "guess: boot or dashboard against the middle of the car",
         .knobs = {{.paths = {"instruments.inertial_unit.x"}, .typical = 0.5},
                   {.paths = {"instruments.inertial_unit.z"}, .typical = 0.25}}},
        {.name = "sensor_delay",
         .question = "Do the inertial sensors read late against the steering (filters, bus)?",
         .source = "guess: 10 to 50 ms",
         .knobs = {{.paths = {"instruments.ax.delay", "instruments.ay.delay", "instruments.yaw_rate.delay",
                              "instruments.roll_rate.delay"},
                    .typical = 0.03,
                    .direction = Direction::up}}},
        {.name = "speed_scale",
         .question = "Does the speed over ground read too much or too little?",
         .source = "guess: 2 to 3 %, from wheel pulses; GPS is better",
         .knobs = {{.paths = {"instruments.speed.gain"}, .typical = 0.03}}},
        {.name = "speed_delay",
         .question = "Does the speed over ground read late?",
         .source = "guess: 0.1 to 0.2 s, GPS",
         .knobs = {{.paths = {"instruments.speed.delay"}, .typical = 0.1, .direction = Direction::up}}},
        {.name = "wheel_speed_scale",
         .question = "Do the wheel speeds read too much or too little?",
         .source = "guess: 2 %, a wrong radius in the unit's conversion",
         .knobs = {{.paths = {"instruments.wheel_speed.gain"}, .typical = 0.02}}},
        {.name = "sideslip_zero",
         .question = "Is the sideslip sensor mounted askew?",
         .source = "guess: 0.5 deg",
         .knobs = {{.paths = {"instruments.sideslip.bias"}, .typical = 0.01}}},
    };
}

}  // namespace tread::diagnose::catalogue
