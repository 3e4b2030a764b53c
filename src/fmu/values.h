// All that an FMU shows of a car: inputs, parameters, outputs, as described structs. The variables of the model
// description and those of the shared object are visits of these.
#pragma once

#include "tread/describe.h"
#include "tread/vehicle.h"
#include "tread/vehicle_output.h"

namespace tread::fmu {

// What the master knows of the ground under one wheel: the plane through a point below the wheel's centre.
struct WheelGround {
    double height = 0;
    double nx = 0;
    double ny = 0;
    double friction = 1;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(height), About{"m", "height of the ground at x, y of the wheel centre"});
        field(TREAD_FIELD(nx), About{"-", "normal of the ground along x; its length is 1 with nz > 0", {-0.99, 0.99}});
        field(TREAD_FIELD(ny), About{"-", "normal of the ground along y", {-0.99, 0.99}});
        field(TREAD_FIELD(friction), About{"-", "factor on the friction of the tyre", kNonNegative});
    }
};
static_assert(describesEveryMember<WheelGround>());

struct Wind {
    double x = 0, y = 0, z = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(x), About{"m/s", "velocity of the air along x of the world"});
        field(TREAD_FIELD(y), About{"m/s", "velocity of the air along y"});
        field(TREAD_FIELD(z), About{"m/s", "velocity of the air along z"});
    }
};
static_assert(describesEveryMember<Wind>());

struct Inputs {
    VehicleInput driver;
    PerWheel<WheelGround> ground;
    Wind wind;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(driver), About{"", "driver"});
        field(TREAD_FIELD(ground), About{"", "ground under the wheels"});
        field(TREAD_FIELD(wind), About{"", "wind"});
    }
};
static_assert(describesEveryMember<Inputs>());

struct StartSettings {
    double x = 0, y = 0;
    double heading = 0;
    double speed = 0;
    double brake = 0;
    double parking_brake = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(x), About{"m", "place of the start"});
        field(TREAD_FIELD(y), About{"m", "place of the start"});
        field(TREAD_FIELD(heading), About{"rad", "heading at the start, 0 along x, positive to the left"});
        field(TREAD_FIELD(speed), About{"m/s", "forward speed at the start", kNonNegative});
        field(TREAD_FIELD(brake), About{"-", "brake pedal while the car settles on its wheels", kFraction});
        field(TREAD_FIELD(parking_brake), About{"-", "parking brake while the car settles on its wheels", kFraction});
    }
};
static_assert(describesEveryMember<StartSettings>());

struct Settings {
    double step = 0.001;
    double friction = 1;
    bool external_ground = false;
    bool ramp_inputs = false;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(step), About{"s", "inner step of the car", {0.0001, 0.01}});
        field(TREAD_FIELD(friction),
              About{"-", "factor on the friction of the tyres on the built-in flat road", kNonNegative});
        field(TREAD_FIELD(external_ground),
              About{"", "true: the ground is that of the inputs; false: the built-in flat road z = 0"});
        field(TREAD_FIELD(ramp_inputs),
              About{"",
                    "true: driver inputs are those at the end of a communication step and move linearly to it; false: "
                    "they hold during the step"});
    }
};
static_assert(describesEveryMember<Settings>());

struct Parameters {
    StartSettings start;
    Settings settings;
    VehicleParams car;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(start), About{"", "start"});
        field(TREAD_FIELD(settings), About{"", "settings"});
        field(TREAD_FIELD(car), About{"", "car"});
    }
};
static_assert(describesEveryMember<Parameters>());

// Found at the start.
struct Found {
    double throttle = 0;
    double steering_wheel_angle = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(throttle), About{"-", "throttle that holds the speed of the start"});
        field(TREAD_FIELD(steering_wheel_angle),
              About{"rad", "steering-wheel angle that holds the heading of the start"});
    }
};
static_assert(describesEveryMember<Found>());

struct WheelCentre {
    double x = 0, y = 0, z = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(x), About{"m", "wheel centre, along x of the world"});
        field(TREAD_FIELD(y), About{"m", "wheel centre, along y"});
        field(TREAD_FIELD(z), About{"m", "wheel centre, along z"});
    }
};
static_assert(describesEveryMember<WheelCentre>());

struct Values {
    double time = 0;
    Inputs inputs;
    Parameters parameters;
    Found found;
    VehicleOutput outputs;
    PerWheel<WheelCentre> wheel_centre;
};

}  // namespace tread::fmu
