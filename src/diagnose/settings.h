// The numbers that decide a verdict: what each stands on, and what follows from it. The equations are those of
// README.md beside this file.
#pragma once

#include <algorithm>
#include <cstddef>

#include "recording/recorded_drive.h"
#include "recording/sliding.h"
#include "tread/describe.h"

namespace tread::diagnose {

struct Settings {
    // ---- Rows, noise and disturbances

    // Shorter shows faster motion, but costs as many more rows and meets what the model lacks above 5 Hz.
    double block = recording::kBlock;
    // Raising it compares more of a slide, where small causes have large consequences.
    double slide_angle = recording::kSlideAngle;
    // Longer lets disturbances explain slow differences, and so hides offsets. The hats, half of it apart, must resolve
    // the roll resonance of a car, 1.5 to 2 Hz. With 0.5 s, the evidence of models without an effect is lower by 480
    // nats (a car of another simulator), 720 and 30 (two measured cars).
    double correlation_time = 0.25;
    // Too large hides effects, too small blames them for wind: the sizes are therefore estimated from the drives, and
    // these are the medians of their priors. Those of longitudinal, lateral and steering are medians of 21 development
    // cars without an unknown cause, 11 of the own world and 10 of another simulator with references (0.033, 0.050 and
    // 0.0005; the logarithms have standard deviations of 0.2 to 0.4).
    // That of yaw follows from the lateral force of a good road, 0.04 m/s2. Both axles meet the same road, one 0.1 s
    // after the other, so that their forces differ by 0.6 of one of them; times half a wheelbase, over the inertia
    // m L^2/4. Gusts do the rest of the lateral force, and push both axles at once. These cars have 0.005 to
    // 0.03.
    // That of roll is what a good road does (ISO 8608, class A): below 2 Hz its left and right tracks differ by 3 mm at
    // 25 m/s, a tilt of 2 mrad, which moves a car of 60 kN m/rad by 120 N m.
    double longitudinal = 0.03, lateral = 0.05, yaw = 0.025, roll = 0.6, steering = 0.0006;
    // In development cases without an unknown cause, fits left errors of 0.6 to 1 % of the forces (four of the own
    // world, three of another simulator with references). They last as long as a manoeuvre. Too large hides effects
    // that act in proportion to the acceleration.
    double force_error = 0.005, error_correlation = 5;
    // Drift of good instruments within seconds: bias instability of micromechanical sensors (10 deg/h, 0.3 mg),
    // satellite speed. That of the roll angle is the slow part of a good road's tilt, half of the 2 mrad below. Too
    // large hides effects that last, too small blames the car for drifts.
    double rate_drift = 5e-5, acceleration_drift = 0.003, angle_drift = 1e-3, speed_drift = 0.005,
           drift_correlation = 2;
    // Guess: a good instrument keeps its scale from drive to drive within a thousandth, and a logger its clocks within
    // a millisecond. Too large hides an effect that scales or delays a reading.
    double scale_error = 0.001, timing_error = 0.001;
    // Two thirds of all drives have sizes within a factor of 2.7, one in twenty beyond 7. Narrower lets the model's
    // errors count as evidence for effects.
    double size_spread = 1;
    // Guess: instruments are better known than roads, wind and forces; data sheets tell their drift within a factor
    // of 1.6.
    double reading_spread = 0.5;
    // Choice: the same, for a remainder that is not called unknown; the same 21 cars have
    // 0.3 to 0.7. Wider tells of fewer unknown causes.
    double ordinary_spread = 0.5;

    // ---- Errors of the model's structure

    // Median and standard deviation of the logarithm in 15 development cars without an unknown cause, five of the own
    // world and ten of another simulator with references, fitted with a wide prior. A change of half its typical size
    // is then told from an imperfection by 8 nats even where its part has no other effect and no other part tells how
    // imperfect the model is.
    double imperfection = 0.02, imperfection_spread = 0.6;
    // Guess: parts of one car are about as imperfect. Wider takes a fault for an imperfection, narrower a model's error
    // in one part for a fault.
    double part_spread = 0.25;
    // Choice: what differs by more than a fifth of a typical change is a cause. Larger lets a car that differs much
    // from its model be explained by many small errors in place of few causes.
    double largest_imperfection = 0.2;

    // Guess: larger because the disturbances of two drives differ. Raising it weakens all evidence.
    double reference_inflation = 1;
    // Guess: a car hardly changes from day to day; weather and load have sizes of their own (D15a). Raising it lets
    // tolerances explain a change.
    double between_days = 0.2;
    // Guess: the power of its vibrations differs by a factor of two, with road, speed and tyres. The recordings tell it
    // as well; the guess has the weight of one of their channels. Smaller takes the vibrations of another road for a
    // fault.
    double vibration_between_days = 0.7;
    // Guess. With it, 15 of 15 values of effects found on cars of the second generator lay within two standard
    // deviations of the truth (D42).
    double structure = 0.25;

    // ---- Priors

    // Choices: a diagnosis is asked for because something seems wrong.
    double none = 0.25, unknown_cause = 0.1;
    // Choice: independent faults, each as improbable.
    double rarer = 1.0 / 3;
    // ---- Thresholds

    // By chance, one effect gains 5 nats with a probability of 2e-4, the best of 93 with at most 0.02.
    double effect = 5;
    // Choice of the user's risk: one false alarm in fifty.
    double false_alarm = 0.02;
    // Odds of 400 to 1.
    double clear = 6;
    // Choice of the user's risk.
    double sure = 0.9;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(block), About{"s",
                                        "length over which readings are averaged: 20 rows per second, because vehicle "
                                        "dynamics lie below 5 Hz"});
        field(TREAD_FIELD(slide_angle),
              About{"rad",
                    "difference between the sideslip angles of car and model, within 1.5 s, at which the comparison of "
                    "a drive ends: about the sideslip angle of a car that still grips"});
        field(TREAD_FIELD(correlation_time),
              About{"s", "time in which a disturbance falls to 1/e; the hat functions are half of it apart"});
        field(TREAD_FIELD(longitudinal),
              About{"m/s2", "usual longitudinal disturbance, wind and unevenness of a good road"});
        field(TREAD_FIELD(lateral), About{"m/s2", "usual lateral disturbance"});
        field(TREAD_FIELD(yaw),
              About{"m/s2", "usual disturbance in yaw, times the wheelbase: both axles meet the same road"});
        field(TREAD_FIELD(roll), About{"m/s2", "usual disturbance in roll, times the wheelbase: that of a good road"});
        field(TREAD_FIELD(steering), About{"rad", "usual tremor of the road wheels"});
        field(TREAD_FIELD(force_error), About{"-", "usual error of the model's forces, as a share of them: guess"});
        field(TREAD_FIELD(error_correlation), About{"s", "time in which such an error falls to 1/e: guess"});
        field(TREAD_FIELD(rate_drift), About{"rad/s", "usual drift of a rate sensor within seconds"});
        field(TREAD_FIELD(acceleration_drift), About{"m/s2", "the same for an accelerometer"});
        field(TREAD_FIELD(angle_drift), About{"rad", "the same for roll and sideslip angles"});
        field(TREAD_FIELD(speed_drift), About{"m/s", "the same for speeds; wheel speeds are taken at the tyre"});
        field(TREAD_FIELD(drift_correlation), About{"s", "time in which such a drift falls to 1/e: guess"});
        field(TREAD_FIELD(scale_error), About{"-", "usual error of the scale of an instrument in one drive: guess"});
        field(TREAD_FIELD(timing_error), About{"s", "usual error of the timing of a channel in one drive: guess"});
        field(TREAD_FIELD(size_spread),
              About{"-", "prior standard deviation of the logarithm of a size of the remainder"});
        field(TREAD_FIELD(reading_spread), About{"-", "share of this spread for the errors of instruments: guess"});
        field(TREAD_FIELD(ordinary_spread),
              About{"-", "the same for disturbances and model errors of an ordinary drive"});
        field(TREAD_FIELD(imperfection),
              About{"-", "usual error of the model along each effect that is not a cause, in typical sizes"});
        field(TREAD_FIELD(imperfection_spread),
              About{"-", "prior standard deviation of the logarithm of the size of such errors, from car to car"});
        field(TREAD_FIELD(part_spread), About{"-", "the same from part to part of a car: guess"});
        field(TREAD_FIELD(largest_imperfection), About{"-", "largest size of such errors, in typical sizes: choice"});
        field(TREAD_FIELD(reference_inflation),
              About{"-", "factor on noise and disturbances where drives have references: guess"});
        field(TREAD_FIELD(between_days),
              About{"-",
                    "share of its tolerance by which a number of the car may differ between two days, unless weather "
                    "and load change it by more: guess"});
        field(TREAD_FIELD(vibration_between_days),
              About{"-",
                    "expected standard deviation of the logarithm of the power of vibrations, from day to day: guess"});
        field(TREAD_FIELD(structure), About{"-",
                                            "relative standard deviation of an effect's value because the model's "
                                            "structure may differ from the car's"});
        field(TREAD_FIELD(none), About{"-", "prior probability of no cause"});
        field(TREAD_FIELD(unknown_cause), About{"-", "prior probability of a cause outside the catalogue"});
        field(TREAD_FIELD(rarer),
              About{"-", "prior probability with one additional cause, relative to that without it"});
        field(TREAD_FIELD(effect), About{"nat", "log evidence that each effect must gain"});
        field(
            TREAD_FIELD(false_alarm),
            About{"-",
                  "an effect is not needed if the set of causes without it is more probable than this; a remainder is "
                  "reported if chance leaves as large a gap with a smaller probability"});
        field(TREAD_FIELD(clear), About{"nat",
                                        "log evidence that distinguishes two effects, and above which an effect may be "
                                        "visible or a force law is reported"});
        field(TREAD_FIELD(sure), About{"-",
                                       "probability from which an unknown cause is reported, below which alternatives "
                                       "are named, and that the credible set holds"});
    }

    // Prior probability of this many causes of the catalogue, at most three. One, two and three share what no cause
    // leaves (D28).
    constexpr double prior(std::size_t causes) const {
        if (causes == 0) return none;
        double share = (1 - none) / (1 + rarer + rarer * rarer);
        for (std::size_t i = 1; i < causes; ++i) share *= rarer;
        return share;
    }
    // Probability that so many causes act, where they explain the recordings within the noise, and are not what an
    // unknown cause looks like. Guess: tolerances alone may imitate an unknown cause, or one, two or three effects, or
    // nothing can; each of these five is as probable (D32b).
    constexpr double genuine(std::size_t causes) const {
        constexpr double kImitated = 0.2;
        if (causes == 0) return 1;
        const double act = (1 - unknown_cause) * prior(causes);
        return act / (act + unknown_cause * kImitated);
    }
};
static_assert(describesEveryMember<Settings>());

inline constexpr Settings kSettings{};

// Time, s, over which an error of the model's structure lasts: of the rows within it, one counts.
inline constexpr double kErrorLasts = 1;

// Expected nats at typical size from which an effect counts as testable: at sizes from 0.6 to 1.6 of it, 19 in 20 then
// gain kSettings.effect (D44). It decides no verdict, but which effects are listed as not to be seen.
inline constexpr double kTestable = 22;

}  // namespace tread::diagnose
