// Every number that decides a verdict, with what it stands on and what follows from it. The equations are those of
// README.md beside this file. They were set on development cases (seeds 2001 to 2004, 3001, 3101, 3201, 5001, 6007,
// 6203, 8111, 9111, 9112, 10111, 10113, 11111 and 11113 of blind checks) and on the rows of the catalogue planted one
// by one.
#pragma once

#include <algorithm>
#include <cstddef>

#include "tread/describe.h"

namespace tread::diagnose {

struct Settings {
    // Noise and disturbances: the more of them, the less any effect gains.
    double model_error = 3e-4;
    double start_speed = 0.1;
    double correlation_time = 0.5;
    double longitudinal = 0.02, lateral = 0.04, yaw = 0.04, roll = 0.08, steering = 0.0003;
    double size_spread = 0.5, largest_size = 3;

    // Drives with a reference.
    double reference_inflation = 1.6;
    double answers_otherwise = 0.1;
    double between_days = 0.2;
    double structure = 0.25, structure_share = 0.15;

    // Priors of the number of causes, and of parameters.
    double none = 0.25, one_cause = 0.45, two_causes = 0.15, three_causes = 0.05, unknown_cause = 0.1;
    double largest_tolerance = 4, largest_effect = 8;

    // Evidence.
    double effect = 5;
    double further_share = 0.002, further_most = 6;
    double clear = 6;
    double testable = 22;
    double sure = 0.9;

    // Causes of no catalogue.
    double one_look_alike = 0.05, two_look_alike = 0.05, three_look_alike = 0.3;
    double wider = 2, same = 0.1, varied = 0.5, jumps = 0.04;
    double law_force = 2;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(model_error), About{"-",
                                              "least noise of a channel, as a share of its size: two steps of the "
                                              "simulation differ by about that"});
        field(TREAD_FIELD(start_speed), About{"m/s", "standard deviation of the speed at the start, as measured"});
        field(TREAD_FIELD(correlation_time),
              About{"s", "in which a disturbance falls to 1/e; hats are half of it apart"});
        field(TREAD_FIELD(longitudinal), About{"m/s2",
                                               "usual disturbance along the car: wind and unevenness of a good "
                                               "road, guess"});
        field(TREAD_FIELD(lateral), About{"m/s2", "usual disturbance aside, guess"});
        field(TREAD_FIELD(yaw), About{"rad/s2", "usual disturbance in yaw, guess"});
        field(TREAD_FIELD(roll), About{"rad/s2", "usual disturbance in roll, guess"});
        field(TREAD_FIELD(steering), About{"rad", "usual tremble of the road wheels, guess"});
        field(TREAD_FIELD(size_spread), About{"-",
                                              "standard deviation of the logarithm of a disturbance's size: wider, "
                                              "and disturbances take what effects would explain"});
        field(TREAD_FIELD(largest_size), About{"-", "times the usual size, that a disturbance reaches at most"});
        field(TREAD_FIELD(reference_inflation), About{"-",
                                                      "factor on noise and disturbances for what a reference does not "
                                                      "take off"});
        field(TREAD_FIELD(answers_otherwise), About{"-",
                                                    "share of the gap that counts as noise where a reference shows "
                                                    "that the model's structure is another"});
        field(TREAD_FIELD(between_days), About{"-",
                                               "share of its tolerances, that a car differs by from itself on another "
                                               "day"});
        field(TREAD_FIELD(structure), About{"-", "share of a value, that a model of another structure errs by"});
        field(TREAD_FIELD(structure_share), About{"-",
                                                  "share of the nats explained, that one more effect then seems to "
                                                  "explain"});
        field(TREAD_FIELD(none), About{"-", "prior probability of no cause"});
        field(TREAD_FIELD(one_cause), About{"-", "prior probability of one cause of the catalogue"});
        field(TREAD_FIELD(two_causes), About{"-", "prior probability of two"});
        field(TREAD_FIELD(three_causes), About{"-", "prior probability of three"});
        field(TREAD_FIELD(unknown_cause), About{"-", "prior probability of a cause of no catalogue"});
        field(TREAD_FIELD(largest_tolerance),
              About{"-", "standard deviations, that a nuisance parameter moves at most"});
        field(TREAD_FIELD(largest_effect), About{"-", "typical sizes, that an effect reaches at most"});
        field(TREAD_FIELD(effect), About{"nat", "that each effect must gain: in empty cases the best never gained 3"});
        field(TREAD_FIELD(further_share), About{"-",
                                                "share of the nats explained, that one more effect must gain besides: "
                                                "no signature is known better"});
        field(TREAD_FIELD(further_most), About{"nat", "most that this share asks for"});
        field(TREAD_FIELD(clear), About{"nat",
                                        "that count as clear: of an unknown cause over the best model, between two "
                                        "effects, and of an effect that may show"});
        field(TREAD_FIELD(testable), About{"nat",
                                           "to expect of an effect at its typical size so that 19 in 20 gain "
                                           "enough (D44), sizes from 0.6 to 1.6"});
        field(TREAD_FIELD(sure), About{"-",
                                       "probability, below which alternatives are named, and that the credible set "
                                       "holds"});
        field(TREAD_FIELD(one_look_alike), About{"-", "share of the unknown causes that look like one effect"});
        field(TREAD_FIELD(two_look_alike), About{"-", "share that look like two"});
        field(TREAD_FIELD(three_look_alike), About{"-", "share that look like three"});
        field(TREAD_FIELD(wider), About{"-", "times the spread of an effect's size, that a look-alike has"});
        field(TREAD_FIELD(same), About{"-", "spread of a true effect's value from drive to drive, as a share of it"});
        field(TREAD_FIELD(varied), About{"-", "the same of a look-alike"});
        field(TREAD_FIELD(jumps), About{"-",
                                        "share of what is explained, that varies all the same: controllers set in or "
                                        "do not"});
        field(TREAD_FIELD(law_force),
              About{"-", "root mean square of a force that follows a law, in usual disturbances"});
    }

    // Nats of effects besides the first that are not to be trusted when so many are explained in all; more of them
    // where recordings are `compared` with references, for there the model may have another structure (D30).
    constexpr double structureAllowance(std::size_t effects, double evidence, bool compared) const {
        if (effects < 2) return 0;
        return static_cast<double>(effects - 1) *
               (compared ? structure_share * evidence : std::min(further_share * evidence, further_most));
    }
};
static_assert(describesEveryMember<Settings>());

inline constexpr Settings kSettings{};

}  // namespace tread::diagnose
