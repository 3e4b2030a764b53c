// The driver of a scenario: goes through its phases and says what hand and feet do.
#pragma once

#include <cstddef>
#include <string>

#include "scenario/scenario.h"
#include "tread/vehicle_output.h"

namespace tread {

class Driver {
public:
    // `initial` is how hand and feet are held in the equilibrium. The scenario must outlive the driver.
    Driver(const Scenario& scenario, const VehicleInput& initial);

    // Looks at the car at a time: ends a phase whose condition came true.
    void look(double time, const ChassisOutput& chassis, double hand_wheel_angle = 0);

    // Input at the end of the coming step, for which `look` saw its start.
    VehicleInput inputAt(double time);

    // True when the last phase has ended by this time.
    bool finished(double time) const;

    // What the present phase waits for, for the message when it waits in vain.
    std::string waitsFor() const;

private:
    const Phase& phase() const { return scenario_.phases[phase_]; }
    bool last() const { return phase_ + 1 == scenario_.phases.size(); }
    bool conditionTrue() const;
    void next(double time);
    VehicleInput signals(double time) const;

    const Scenario& scenario_;
    std::size_t phase_ = 0;
    double phase_start_ = 0;  // s
    bool ended_ = false;      // the last phase, by a condition
    VehicleInput held_;       // at the start of the phase
    ChassisOutput seen_;
    double seen_hand_wheel_ = 0;  // rad
    double seen_time_ = 0;        // s
    double phase_distance_ = 0;   // m
    double phase_speed_ = 0;      // m/s, at the start of the phase
    double missing_way_ = 0;      // m, integral of the speed that was missing
    bool looked_ = false;
};

}  // namespace tread
