// Many cars that do not meet, advanced together and without a physics engine: for campaigns, for gradients over
// perturbed copies of one car, and for those who train controllers.
//
//     tread::CarFleet fleet(64, tread::loadVehicle("compact.yaml"), {.threads = 4});
//     fleet.reset({.speed = 20});
//     for (tread::VehicleInput& input : fleet.inputs()) input.steering_wheel_angle = 0.5;
//     fleet.advance(10);  // steps
//     const double yaw_rate = fleet.output(0).chassis.yaw_rate;
//
// Each car does, bit for bit, what `advance` of vehicle.h does with it alone, whatever the other cars are and however
// many threads there are. Several cars are computed at once, each in a lane of the processor's vectors, whatever their
// gearboxes, brakes, inputs and roads are. Left alone are cars with curves in place of spring or damper rates or with
// longitudinal compliance.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "tread/api.h"
#include "tread/equilibrium.h"
#include "tread/road.h"
#include "tread/vehicle.h"

namespace tread {

struct CarFleetSettings {
    double step = 0.001;  // s, above 0 and at most 0.002
    int threads = 1;      // that compute, the caller's included; 0: one per core
    int lanes = 8;        // cars that a thread computes at once, at most; the processor has 8, 4 or 1
    Vector3 gravity_W{0, 0, -kStandardGravity};
    Vector3 wind_W{0, 0, 0};  // m/s, velocity of the air, until setWind() says another
};

// How the inputs of a call come about.
enum class InputCourse {
    held,   // as they are now, from the beginning of the call to its end
    ramped  // changing evenly from those with which the last call ended (or the car was reset) to those of now
};

// All that a car's future depends on, besides its parameters, its road and the inputs to come.
struct CarSnapshot {
    ChassisMotion motion;
    VehicleState state;
    VehicleInput input;  // with which the last call ended
};

// Cars are numbered from 0 in the order in which they were given; another number is answered by std::out_of_range. One
// thread at a time may use a fleet.
class TREAD_API CarFleet {
public:
    // The cars stand at the origin of a flat road until they are reset. std::invalid_argument says what is wrong with
    // the settings.
    explicit CarFleet(const std::vector<VehicleParams>& cars, const CarFleetSettings& settings = {});
    CarFleet(std::size_t count, const VehicleParams& car, const CarFleetSettings& settings = {});
    CarFleet(CarFleet&&) noexcept;
    CarFleet& operator=(CarFleet&&) noexcept;
    ~CarFleet();

    std::size_t size() const;
    double step() const;  // s
    const Vehicle& vehicle(std::size_t car) const;

    // The road of all cars, or of one. It is asked from several threads at once; makeRoad() of road_surface.h makes
    // roads that can be. It does not move the cars: reset them.
    void setRoad(const std::shared_ptr<const Road>& road);
    void setRoad(std::size_t car, const std::shared_ptr<const Road>& road);

    // Velocity of the air in the world, m/s: for all cars, or for one.
    void setWind(const Vector3& wind_W);
    void setWind(std::size_t car, const Vector3& wind_W);

    // Puts cars in equilibrium (equilibrium.h) where they are to start, and their inputs to those that keep them there:
    // one car, all, or all of which `which` is true, with one start for all or one per car. To find an equilibrium
    // takes as long as some hundred steps; a car that starts where it started last, on the same
    // road and in the same wind, starts at once.
    void reset(std::size_t car, const Start& start);
    void reset(const Start& start);
    void reset(std::span<const Start> starts);
    void reset(std::span<const Start> starts, const std::vector<bool>& which);

    // The driver's input of each car, to be set before `advance`.
    std::span<VehicleInput> inputs();
    VehicleInput& input(std::size_t car);

    // All cars by some steps.
    void advance(int steps = 1, InputCourse course = InputCourse::held);

    ChassisMotion motion(std::size_t car) const;
    VehicleOutput output(std::size_t car) const;
    void output(std::span<VehicleOutput> outputs) const;  // of all cars; on all threads

    CarSnapshot snapshot(std::size_t car) const;
    void restore(std::size_t car, const CarSnapshot& snapshot);  // of a car with the same parameters

private:
    struct TREAD_INTERNAL Implementation;
    TREAD_INTERNAL void begin();
    std::unique_ptr<Implementation> self_;
};

}  // namespace tread
