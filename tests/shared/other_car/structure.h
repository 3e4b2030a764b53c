// Optional differences in structure of the other car: properties of real cars that tread's model lacks or models in
// another way. They do not change during a case. Without any, the car is the plain double-track model.
#pragma once

#include <array>
#include <numbers>
#include <string_view>

namespace other_car {

struct Structure {
    bool brush_tyre = false;
    bool hyperbolic_tyre = false;
    bool friction_ellipse = false;
    bool relaxation_by_load = false;
    bool rolling_resistance_by_speed = false;
    bool curved_roll_steer = false;
    bool stiffening_bushes = false;
    bool progressive_anti_roll_bar = false;
    bool moving_roll_axis = false;
    bool body_twist = false;
    bool steering_column = false;
    bool slow_rear_brakes = false;
    bool turbo_lag = false;
    bool viscous_differential = false;

    bool operator==(const Structure&) const = default;
};

struct StructuralChoice {
    std::string_view name, what;
    bool Structure::*on;
};

inline constexpr std::array kStructuralChoices{
    StructuralChoice{"brush_tyre",
                     "tyre forces by the brush model with parabolic pressure (Pacejka 2006, section 3.2; Fiala 1954)",
                     &Structure::brush_tyre},
    StructuralChoice{"hyperbolic_tyre", "tyre forces that saturate as a hyperbolic tangent, without a peak",
                     &Structure::hyperbolic_tyre},
    StructuralChoice{"friction_ellipse",
                     "the longitudinal force has its way and leaves the side force what the friction ellipse leaves "
                     "(Milliken and Milliken 1995, section 2.8)",
                     &Structure::friction_ellipse},
    StructuralChoice{"relaxation_by_load",
                     "relaxation lengths in proportion to the load, in place of stiffness over carcass stiffness",
                     &Structure::relaxation_by_load},
    StructuralChoice{"rolling_resistance_by_speed", "rolling resistance that grows with the square of the speed",
                     &Structure::rolling_resistance_by_speed},
    StructuralChoice{"curved_roll_steer", "toe over travel as a curve of third order: tie rods swing in arcs",
                     &Structure::curved_roll_steer},
    StructuralChoice{"stiffening_bushes", "bushes that get stiffer the more the side force turns the wheel",
                     &Structure::stiffening_bushes},
    StructuralChoice{"progressive_anti_roll_bar", "anti-roll bars whose moment grows with the cube of the roll angle",
                     &Structure::progressive_anti_roll_bar},
    StructuralChoice{"moving_roll_axis", "a roll axis that sinks as the body rolls", &Structure::moving_roll_axis},
    StructuralChoice{"body_twist", "a body that twists: its rear rolls by itself, on the torsional stiffness",
                     &Structure::body_twist},
    StructuralChoice{"steering_column", "a column that swings: the road wheels follow as an oscillator",
                     &Structure::steering_column},
    StructuralChoice{"slow_rear_brakes", "a rear brake circuit that fills late", &Structure::slow_rear_brakes},
    StructuralChoice{"turbo_lag", "a part of the engine's torque that waits for the turbocharger",
                     &Structure::turbo_lag},
    StructuralChoice{"viscous_differential", "a differential with a viscous coupling between its wheels",
                     &Structure::viscous_differential},
};

// Magnitude of each: guesses of typical values of cars.
inline constexpr double kRollingSpeed = 45;       // m/s, at which the rolling resistance is 1.5 times that at rest
inline constexpr double kToeCurve = 0.05;         // m of travel, at which the curve doubles the line
inline constexpr double kBushForce = 8000;        // N of side force, at which a bush gives half of what it would
inline constexpr double kBarAngle = 0.08;         // rad of roll, at which a bar's moment has doubled
inline constexpr double kRollAxisAngle = 0.15;    // rad of roll, at which the roll axis would reach the road
inline constexpr double kTwistStiffness = 1.7e5;  // N m/rad, 3 kN m/deg: an open car
inline constexpr double kTwistDamping = 0.05;     // of critical, of the rear part against the front part
inline constexpr double kColumnFrequency = 2 * std::numbers::pi * 8;  // rad/s
inline constexpr double kColumnDamping = 0.3;                         // of critical
inline constexpr double kRearBrakeLag = 0.12;                         // s
inline constexpr double kTurboTime = 0.4;                             // s
inline constexpr double kTurboShare = 0.35;                           // of the torque
inline constexpr double kViscousTorque = 30;                          // N m per rad/s between the wheels

}  // namespace other_car
