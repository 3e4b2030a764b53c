// The driver of a scenario: goes through its phases and says what hand and feet do.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "log/log_columns.h"
#include "scenario/course_plan.h"
#include "scenario/expression/moment.h"
#include "scenario/scenario.h"
#include "scenario/speed_control.h"
#include "scenario/speed_follower.h"
#include "scenario/steer_control.h"
#include "tread/vehicle_output.h"

namespace tread {

// Where a run stands in its scenario: columns of the log.
struct Place {
    ManoeuvreOutput manoeuvre;
    CourseOutput course;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(manoeuvre), About{"", "place in the scenario"});
        field(TREAD_FIELD(course), About{"", "place on the course"});
    }
};

class Driver {
public:
    // `initial` is how hand and feet are held in the equilibrium; `car` what a driver knows who watches the path,
    // `resistance` one who follows a speed.
    // Conditions of phases find the `channel`s of the log there; those of the place are the driver's own.
    // Reads the logs that the scenario replays; throws as withReplaysRead does.
    Driver(const Scenario& scenario, const VehicleInput& initial, const KnownSteering& car = {},
           const KnownResistance& resistance = {}, const ChannelValue& channel = {}, const KnownGrip& grip = {});

    // Looks at the car at a time: ends a phase whose condition came true.
    void look(double time, const ChassisOutput& chassis, double steering_wheel_angle = 0);

    // Input at the end of the coming step, for which `look` saw its start.
    VehicleInput inputAt(double time);

    // True when the last phase has ended by this time.
    bool finished(double time) const;

    // As of the last look.
    const Place& place() const { return *place_; }

    // What the present phase waits for, for the message when it waits in vain.
    std::string waitsFor() const;

private:
    const Phase& phase() const { return scenario_.phases[phase_]; }
    bool last() const { return phase_ + 1 == scenario_.phases.size(); }
    std::optional<double> endByClock() const;  // s, of the phase that begins
    void next(double time);
    void beginPhase();
    VehicleInput signals(double time) const;
    void findPlace();
    // m along the course, where the driver reads the speed.
    double aheadOf(const FollowCourse& driver) const { return *way_ + driver.preview_time * seen_.car.vx; }
    void driveOn(double elapsed, double dt);

    Scenario scenario_;
    std::unique_ptr<Place> place_ = std::make_unique<Place>();    // where conditions find it, also of a moved driver
    std::vector<std::optional<MomentaryExpression>> conditions_;  // of each phase
    std::size_t phase_ = 0;
    double phase_start_ = 0;                // s
    std::optional<double> phase_end_ = {};  // s, by the clock
    bool ended_ = false;                    // the last phase, by a condition
    VehicleInput held_;                     // at the start of the phase
    Observed seen_;
    double seen_steering_wheel_ = 0;  // rad
    double seen_time_ = 0;            // s
    bool looked_ = false;
    CoursePlan course_;
    std::optional<double> way_;  // m along the course; nothing: not yet looked for
    SpeedControl feet_;
    SpeedFollower follower_;
    SteerControl hands_;
};

}  // namespace tread
