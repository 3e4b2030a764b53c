// The equilibrium is found by letting the car settle: all sub-models, present and future, are in it as they are. What
// the settling adds vanishes at rest: the body heaves, rolls and pitches as if it were light, and is damped; a rolling
// car is held at its speed while the torque at the wheels is sought that leaves no longitudinal acceleration, and,
// where it pulls to a side, the steering-wheel angle and the sideslip that leave no lateral and yaw acceleration. Dry
// friction in the suspension could hold the body anywhere nearby; it is left out, so that the car stands where it does
// not act.

#include "tread/equilibrium.h"

#include <algorithm>
#include <cmath>

#include "base/math/turn.h"
#include "vehicle/settling.h"
#include "vehicle/tyre_load.h"
#include "vehicle/vectors.h"

namespace tread {
namespace {

constexpr double kLongest = 6;       // s
constexpr double kQuietTime = 0.05;  // s, for which the body must be quiet
constexpr double kQuiet = 1e-6;      // m/s2 and rad/s2
constexpr double kRideFrequency =
    24;                          // rad/s, at which the light body heaves: its suspension damps that nearly critically
constexpr double kLightest = 9;  // mass of the body over that with which it settles
constexpr double kRideDamping = 6;          // 1/s, of heave, roll and pitch
constexpr double kDriftDamping = 25;        // 1/s, of a standing car along the road
constexpr double kBushDamping = 100;        // 1/s, of the recession of wheels
constexpr double kTorqueGain = 20;          // 1/s: how fast the torque at the wheels follows the need
constexpr double kPullShows = 0.1;          // s, after which a car that runs straight shows nothing to either side
constexpr double kSideRate = 25;            // 1/s: about how fast the sideslip follows the need
constexpr double kTrimRate = 15;            // 1/s: the same of the steering wheel
constexpr double kTypicalSlope = 20;        // 1/rad, cornering stiffness of a tyre over its load
constexpr double kTypicalRelaxation = 0.5;  // m, after which its side force has followed

Vector3 vectorOf(const std::array<double, 3>& a) {
    return {a[0], a[1], a[2]};
}

// The car on its wheels at static height, its axes along the road.
ChassisMotion placed(const Vehicle& vehicle, const Surroundings& surroundings, const Start& start) {
    const Vector3 up = -surroundings.gravity_W.normalized();
    const RoadContact ground = surroundings.road.contact({start.x, start.y, 0}, 0);
    const Vector3& n = ground.normal_W;
    Vector3 point(start.x, start.y, 0);
    point.z() =
        ground.point_W.z() - (n.x() * (start.x - ground.point_W.x()) + n.y() * (start.y - ground.point_W.y())) / n.z();

    const Vector3 heading = turnAbout(up, start.heading) * Vector3::UnitX();
    Eigen::Matrix3d axes;
    axes.col(0) = (heading - heading.dot(n) * n).normalized();
    axes.col(1) = n.cross(axes.col(0));
    axes.col(2) = n;
    ChassisMotion motion;
    motion.orientation = Quaternion(axes).normalized();
    const Vector3& reference = vehicle.reference_B;
    const Vector3 centre_B(-reference.x(), -reference.y(), vehicle.params.centre_of_gravity_height);
    motion.position_W = point + times(axes, centre_B);
    motion.velocity_W = start.speed * axes.col(0);
    return motion;
}

VehicleState resting(const Vehicle& vehicle, const Start& start) {
    VehicleState state;
    const VehicleParams& params = vehicle.params;
    state.steering =
        steadySteering(params.steering, start.input.steering_wheel_angle, params.front.track, params.wheelbase);
    for (std::size_t i = 0; i < kWheels; ++i) {
        WheelState& wheel = state.wheels[i];
        wheel.spin = start.speed / rollingRadius(vehicle.corners[i].tyre, vehicle.corners[i].static_force);
        wheel.motion.Vx = start.speed;
        wheel.motion.Fz = vehicle.corners[i].static_force;
        wheel.suspension_force = wheel.load = wheel.vertical_force = vehicle.corners[i].static_force;
    }
    return state;
}

double largest(const std::array<double, 3>& a) {
    return std::max({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])});
}

// Undamped heave of the body on its springs.
double heaveFrequency(const Vehicle& vehicle) {
    double stiffness = 0;
    for (std::size_t i = 0; i < kWheels; ++i) {
        const AxleParams& axle = axleOf(i) == 0 ? vehicle.params.front : vehicle.params.rear;
        stiffness += forces(axle.suspension, {0, 0, 0, vehicle.corners[i].static_force}).by_travel;
    }
    return std::sqrt(stiffness / vehicle.params.mass);
}

// Changes the velocities of the body; the wheels keep theirs.
void push(ChassisMotion& motion, VehicleState& state, const Vehicle& vehicle, const Vector3& velocity_W,
          const Vector3& angular_velocity_W) {
    const Quaternion to_body = motion.orientation.conjugate();
    const Vector3 change = to_body * (velocity_W - motion.velocity_W);
    const Vector3 turn = to_body * (angular_velocity_W - motion.angular_velocity_W);
    for (std::size_t i = 0; i < kWheels; ++i)
        state.wheels[i].rate -= (change + turn.cross(vehicle.corners[i].hub_B)).z();
    motion.velocity_W = velocity_W;
    motion.angular_velocity_W = angular_velocity_W;
}

// The part of a vector across a direction.
Vector3 across(const Vector3& a, const Vector3& n) {
    return a - a.dot(n) * n;
}

double meanDrivenSpin(const VehicleState& state, double front_share) {
    const auto& w = state.wheels;
    return 0.5 * (front_share * (w[0].spin + w[1].spin) + (1 - front_share) * (w[2].spin + w[3].spin));
}

// What the steering wheel must stand at so that this angle is left behind its play.
double beyondPlay(const SteeringParams& params, double angle) {
    return angle + (angle > 0 ? 0.5 : angle < 0 ? -0.5 : 0) * params.play;
}

// The steering at rest again, where the steering wheel stands and with what yields.
void rest(SteeringState& state, const VehicleParams& params) {
    const SteeringState moved = state;
    state = steadySteering(params.steering, moved.angle, params.front.track, params.wheelbase);
    state.wheels = moved.wheels;
    state.yielding = moved.yielding;
    state.moment = moved.moment;
}

// Yaw acceleration over the steering-wheel angle, roughly, 1/(s2 rad).
double yawBySteeringWheel(const VehicleParams& params) {
    const double b = params.wheelbase - params.front_axle_distance;
    const double front_load = params.mass * kStandardGravity * b / params.wheelbase;
    return params.front_axle_distance * kTypicalSlope * front_load / (params.inertia.yaw * params.steering.ratio);
}

class SettlingAlone final : public Settling {
public:
    SettlingAlone(const Vehicle& vehicle, const Surroundings& surroundings)
        : vehicle_(vehicle), surroundings_(surroundings) {}

    void advance(ChassisMotion& motion, VehicleState& state, const VehicleInput& input, double dt) override {
        tread::advance(motion, state, vehicle_, input, input, surroundings_, dt);
    }
    void complete(VehicleState&) override {}

private:
    const Vehicle& vehicle_;
    const Surroundings& surroundings_;
};

// Where the settling of a car begins: at static height, or as another one has settled.
Settled beginning(const Vehicle& vehicle, const Surroundings& surroundings, const Start& start, const Settled* from) {
    const ChassisMotion place = placed(vehicle, surroundings, start);
    Settled now{.place = place, .motion = place, .state = {}, .input = start.input};
    if (!from) {
        now.state = resting(vehicle, start);
        return now;
    }
    now = *from;
    now.place = place;
    now.motion.position_W = place.position_W + (from->motion.position_W - from->place.position_W);
    return now;
}

}  // namespace

Equilibrium equilibrium(const Vehicle& vehicle, const Surroundings& surroundings, const Start& start) {
    return atRest(settle(vehicle, surroundings, start), vehicle);
}

Settled settle(const Vehicle& car, const Surroundings& surroundings, const Start& start, const Settled* from,
               const SettlingOf& settling) {
    Vehicle vehicle = car;
    for (AxleParams* axle : {&vehicle.params.front, &vehicle.params.rear}) axle->suspension.damper.friction = 0;
    vehicle.params.steering.delay = vehicle.params.steering.lag = 0;
    Settled result = beginning(vehicle, surroundings, start, from);
    const ChassisMotion& place = result.place;
    const bool rolls = start.speed != 0;
    const double front_share = vehicle.params.driveline.front_share;
    const double inertia_torque = vehicle.params.mass * vehicle.corners[0].tyre.parameters.Re;
    const Vector3 forward = place.orientation * Vector3::UnitX();
    const Vector3 left = place.orientation * Vector3::UnitY();
    const Vector3 n = place.orientation * Vector3::UnitZ();
    const double fastest = std::abs(start.speed) / kTypicalRelaxation;  // 1/s
    const double trim_gain = std::min(kTrimRate, fastest) / yawBySteeringWheel(vehicle.params);
    const double side_gain =
        std::min(kSideRate, 2 * fastest) * std::abs(start.speed) / (kTypicalSlope * kStandardGravity);
    const double hastening = kRideFrequency / heaveFrequency(vehicle);
    const double lightness = std::clamp(hastening * hastening, 1.0, kLightest);
    const double step = hastening > 1 ? 0.002 : 0.001;  // s

    VehicleState& state = result.state;
    double &torque = result.torque, &trim = result.trim, &sideways = result.sideways;
    const std::unique_ptr<Settling> settles =
        settling ? settling(vehicle) : std::make_unique<SettlingAlone>(vehicle, surroundings);
    double quiet = 0;
    for (double t = 0; t < kLongest && quiet < kQuietTime; t += step) {
        // Driveline in steady running at the torque sought.
        const SteadyDriveline steady =
            steadyDriveline(vehicle.params.driveline, meanDrivenSpin(state, front_share), rolls ? torque : 0);
        state.driveline = steady.state;
        result.throttle = steady.throttle;
        if (rolls) result.input.throttle = std::clamp(steady.throttle, 0.0, 1.0);
        settles->advance(result.motion, state, result.input, step);

        // Hasten the ride, damp what is left.
        for (std::size_t i = 0; i < kWheels; ++i) state.wheels[i].recession.rate *= 1 - kBushDamping * step;
        ChassisMotion& motion = result.motion;
        const Vector3 acceleration = vectorOf(state.acceleration_W);
        const Vector3 angular = vectorOf(state.angular_acceleration_W);
        const Vector3 left_over = motion.velocity_W - place.velocity_W;
        const Vector3 turning = motion.angular_velocity_W;
        const double more = (lightness - 1) * step;
        const Vector3 ride = (1 - kRideDamping * step) * (left_over.dot(n) + more * acceleration.dot(n)) * n;
        const Vector3 tilt = (1 - kRideDamping * step) * (across(turning, n) + more * across(angular, n));
        const Vector3 drift = (1 - kDriftDamping * step) * across(left_over, n);
        const Vector3 yaw = (1 - kDriftDamping * step) * turning.dot(n) * n;
        if (rolls) {
            // Hold place, speed and heading; a car that pulls to a side is steered against it.
            const double aside = acceleration.dot(left), turns = angular.dot(n);
            result.pulls |= t > kPullShows && std::max(std::abs(aside), std::abs(turns)) > kQuiet;
            if (result.pulls) {
                sideways += side_gain * step * aside;
                trim -= trim_gain * step * turns;
                result.input.steering_wheel_angle = beyondPlay(vehicle.params.steering, trim);
                const double turned = (motion.orientation * Vector3::UnitX()).dot(left);
                motion.orientation = (turnAbout(n, -turned) * motion.orientation).normalized();
            }
            push(motion, state, vehicle, place.velocity_W + ride + sideways * left, tilt);
            motion.position_W = place.position_W + (motion.position_W - place.position_W).dot(n) * n;
            torque -= kTorqueGain * step * inertia_torque * acceleration.dot(forward);
        } else {
            push(motion, state, vehicle, ride + drift, tilt + yaw);
        }
        result.acceleration = std::max(largest(state.acceleration_W), largest(state.angular_acceleration_W));
        quiet = result.acceleration < kQuiet ? quiet + step : 0;
    }

    settles->complete(state);
    return result;
}

// Rest at last: what the settling left is below what matters.
Equilibrium atRest(const Settled& settled, const Vehicle& vehicle) {
    Equilibrium result{.motion = settled.motion,
                       .state = settled.state,
                       .input = settled.input,
                       .throttle = settled.throttle,
                       .acceleration = settled.acceleration};
    const Vector3 left = settled.place.orientation * Vector3::UnitY();
    result.motion.velocity_W = settled.place.velocity_W + settled.sideways * left;
    result.motion.angular_velocity_W.setZero();
    if (settled.pulls) rest(result.state.steering, vehicle.params);
    for (std::size_t i = 0; i < kWheels; ++i) {
        WheelState& wheel = result.state.wheels[i];
        wheel.rate = wheel.recession.rate = wheel.recession.acceleration = 0;
        wheel.warming = 0;
    }
    return result;
}

}  // namespace tread
