#include "host/car.h"

#include <cmath>

#include "base/math/elementary.h"
#include "base/math/interpolate.h"
#include "base/math/turn.h"
#include "base/text/concat.h"
#include "base/text/number_text.h"
#include "host/channels.h"
#include "host/failure.h"
#include "host/settled.h"
#include "tread/load.h"
#include "vehicle/sound_state.h"

namespace tread::host {
namespace {

const Vector3 kGravity_W(0, 0, -kStandardGravity);

// Of the body's x axis over the horizontal plane, as VehicleOutput has it.
double yawOf(const Quaternion& q) {
    return arctan2(2 * (q.w() * q.z() + q.x() * q.y()), 1 - 2 * (q.y() * q.y() + q.z() * q.z()));
}

[[noreturn]] void breakDown(const std::string& text) {
    throw Failure(Failure::Kind::broken, text);
}

void demandFinite(const ChassisMotion& body) {
    if (body.position_W.allFinite() && body.velocity_W.allFinite() && body.angular_velocity_W.allFinite() &&
        body.orientation.coeffs().allFinite() && std::abs(body.orientation.norm() - 1) < 1e-3)
        return;
    refuse("found a motion of the body with numbers that are not finite, or an orientation that is no unit quaternion");
}

}  // namespace

Car::Car(const VehicleParams& params, double step) : vehicle_(prepare(params)), pace_(step) {
    if (!(step >= kShortestStep && step <= kLongestStep))
        refuse(concat({"found an inner step of ", numberText(step), " s, expected ", numberText(kShortestStep), " to ",
                       numberText(kLongestStep), " s"}));
}

void Car::setWind(const Vector3& velocity_W) {
    if (!velocity_W.allFinite()) refuse("found a wind that is not finite, expected finite numbers");
    now_.wind_W = velocity_W;
}

void Car::takeSurroundings(const Car& other) {
    ground_ = other.ground_;
    now_.wind_W = other.now_.wind_W;
}

void Car::start(const Start& start) {
    Start at = start;
    at.input = withinLimits(start.input);
    if (!std::isfinite(at.x + at.y + at.heading + at.speed))
        refuse("found a start that is not finite, expected finite numbers for place, heading and speed");
    if (at.speed < 0) refuse(concat({"found a starting speed of ", numberText(at.speed), " m/s, expected at least 0"}));
    ground_.beginStep();
    const Equilibrium rest = equilibrium(vehicle_, {ground_, kGravity_W, now_.wind_W}, at);
    ground_.throwIfFaulty();
    switch (startFault(rest, at.speed)) {
        case StartFault::none:
            break;
        case StartFault::broke_down:
            breakDown(
                "the simulation broke down before the start, while the car settled on its wheels (a parameter far from "
                "that of a real car can do this)");
        case StartFault::no_equilibrium:
            refuse(
                concat({"the car finds no equilibrium to start from: ", numberText(rest.acceleration),
                        " m/s2 are left after settling (does it stand on a slope with its brakes off, or on ice?)"}));
        case StartFault::too_fast:
            refuse(concat({"the car cannot hold the ", numberText(at.speed),
                           " m/s at which it starts: that would take a throttle of ", numberText(rest.throttle),
                           ", and only 0 to 1 is possible; let it start slower"}));
    }
    now_.motion = rest.motion;
    now_.state = rest.state;
    now_.input = now_.next = withinLimits(rest.input);
    now_.ramps = false;
    now_.time = now_.time_rest = 0;
    pace_.carry(0);
    now_.yaw = yawOf(now_.motion.orientation);
    now_.link = {now_.motion.velocity_W, now_.motion.angular_velocity_W};
    started_ = true;
    broken_ = observed_ = false;
}

void Car::setInput(const VehicleInput& input, Course course) {
    now_.next = withinLimits(input);
    now_.ramps = course == Course::ramp;
}

void Car::advance(double duration) {
    move(now_.motion, duration);
    now_.link = {now_.motion.velocity_W, now_.motion.angular_velocity_W};
}

BodyForce Car::push(const ChassisMotion& body, double duration, Integration integration) {
    demandFinite(body);
    if (!(duration >= Pace::kShortest))
        refuse(concat({"found a step of ", numberText(duration), " s for the body, expected at least ",
                       numberText(Pace::kShortest), " s"}));
    const ChassisMotion from = taken(body, now_.motion, now_.link);
    ChassisMotion to = from;
    move(to, duration);
    now_.motion = to;
    return forceBetween(from, to, body, this->body(), integration, kGravity_W, duration, now_.link);
}

void Car::move(ChassisMotion& motion, double duration) {
    if (!started_) refuse("the car has not been started: start it before its first step");
    if (broken_) breakDown("the car has broken down before: start it again, or go back to a state of before");
    if (!(duration > 0 && std::isfinite(duration)))
        refuse(concat({"found a step of ", numberText(duration), " s, expected more than 0"}));
    ground_.beginStep();
    const Surroundings surroundings{ground_, kGravity_W, now_.wind_W};
    const Steps steps = pace_.within(duration);

    // Switches change at the beginning of a step; a force that begins to count does not come from what counted before.
    VehicleInput from = now_.ramps ? now_.input : now_.next;
    if (from.force_command != now_.next.force_command) from.longitudinal_force = now_.next.longitudinal_force;
    from.hands_off = now_.next.hands_off;
    from.force_command = now_.next.force_command;
    const auto inputAt = [&](long k) {
        return now_.ramps ? interpolated(from, now_.next, static_cast<double>(k) / static_cast<double>(steps.count))
                          : now_.next;
    };
    observed_ = false;
    for (long k = 0; k < steps.count; ++k) {
        tread::advance(motion, now_.state, vehicle_, inputAt(k), inputAt(k + 1), surroundings, steps.length);
        followYaw(motion);
    }
    if (steps.count > 0) now_.input = now_.next;
    count(duration);
    ground_.throwIfFaulty();
    checkHealth();
}

// Compensated summation (W. Kahan, Further remarks on reducing truncation errors, Communications of the ACM 8, 1965):
// after k equal steps of the host the time is k times the step, with no more than the rounding of this product.
void Car::count(double duration) {
    const double more = duration + now_.time_rest, sum = now_.time + more;
    now_.time_rest = more - (sum - now_.time);
    now_.time = sum;
}

void Car::followYaw(const ChassisMotion& motion) {
    now_.yaw = unwrapped(yawOf(motion.orientation), now_.yaw);
}

void Car::checkHealth() {
    // A number that is not finite in the state spreads into the accelerations of the body within a step.
    const auto& a = now_.state.acceleration_W;
    const auto& turn = now_.state.angular_acceleration_W;
    double sum = a[0] + a[1] + a[2] + turn[0] + turn[1] + turn[2] + now_.state.driveline.engine_speed;
    for (std::size_t i = 0; i < kWheels; ++i) sum += now_.state.wheels[i].spin;
    if (std::isfinite(sum)) return;
    broken_ = true;
    const auto bad = firstNotFinite(output());
    breakDown(concat({"the simulation broke down at t = ", numberText(now_.time),
                      " s: ", bad ? outputChannels()[*bad].name : "the state",
                      " is not finite (a parameter far from that of a real car, or a step that is too long, can do "
                      "this)"}));
}

const VehicleOutput& Car::output() const {
    if (!observed_) {
        output_ = observe(now_.motion, now_.state, vehicle_, kGravity_W);
        if (std::isfinite(output_.chassis.yaw)) output_.chassis.yaw = unwrapped(output_.chassis.yaw, now_.yaw);
        observed_ = true;
    }
    return output_;
}

Snapshot Car::snapshot() const {
    Snapshot copy = now_;
    copy.carried = pace_.carried();
    copy.planes = ground_.planes();
    return copy;
}

void Car::restore(const Snapshot& snapshot) {
    now_ = snapshot;
    pace_.carry(now_.carried);
    ground_.setPlanes(now_.planes);
    started_ = true;
    broken_ = observed_ = false;
}

std::uint64_t Car::identity() const {
    if (identity_ == 0) {
        const std::string text = concat({vehicleYaml(vehicle_.params), numberText(pace_.step())});
        identity_ = hashOf(std::as_bytes(std::span(text)));
    }
    return identity_;
}

std::vector<std::byte> Car::bytes() const {
    return bytesOf(snapshot(), identity());
}

void Car::restore(std::span<const std::byte> bytes) {
    Snapshot snapshot = snapshotOf(bytes, identity());
    if (!isSound(snapshot.state, vehicle_.params) || !(std::abs(snapshot.carried) <= kLongestStep))
        refuse("found a state that no car can have: a gear, a phase, a delay or a time that does not exist");
    snapshot.input = withinLimits(snapshot.input), snapshot.next = withinLimits(snapshot.next);
    restore(snapshot);
}

}  // namespace tread::host
