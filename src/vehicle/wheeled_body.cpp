// A step of the body on its wheels: velocity Verlet for the body with an implicit step of every wheel inside it, as in
// step.h.
//
// One source for both cars are a wheel's contact, its motion there and the moments that it hands on (contact.h,
// body.h), the load (83) with the rim and the part of it that grips (tyre_load.h), the tyre with its patch and spin
// (four_tyres.h), prediction and correction of the motion (body.h). What is different here, and why:
//   no ground             a plane square to the strut stands in, as a game's car may lie in the air in any attitude
//   wheels without mass   the load follows from strut and tyre in series (strut.h), not from the wheel's own motion;
//                         the rim's loss then goes with the body's speed, since the wheel stops at once
//   damping of the tyre   beyond pz2, in proportion to the strut's, for tyres that are made from stock numbers
//   grip                  what the carcass stores beyond it is let go of (tyre_grip.h says why not in the whole car)
//   side force            at the height that a game wants against tipping, and the side slip of that place with it
//   drive torque          the game's, which knows no engine and no driveline: it ends as the wheel spins
//   reaction of the spin  only if it is asked for (wheel_reaction)
//   steering rate         that of the game's angle over the step; nothing yields
#include "vehicle/wheeled_body.h"

#include <algorithm>
#include <cmath>

#include "base/math/turn.h"
#include "vehicle/body.h"
#include "vehicle/contact.h"
#include "vehicle/strut.h"
#include "vehicle/tyre_grip.h"
#include "vehicle/tyre_load.h"

namespace tread {
namespace {

// Struts that lean on the ground by more than about 84 degrees carry nothing.
constexpr double kLeastShare = 0.1;

// The wheel with its strut compressed. Where no ground is known, one square to the strut stands in for it: the tyre has
// no load there, but it remembers its slip, which must be that of the car's way and not of its fall.
WheelContact hang(const BodyWheel& wheel, const BodyMotion& body, const RoadContact& ground, double steer,
                  double compression) {
    Vector3 axis_B = wheel.left_B;
    if (steer != 0) axis_B = turnAbout(-wheel.down_B, steer) * wheel.left_B;
    const Vector3 hub_B = wheel.top_B + (wheel.strut.length - compression) * wheel.down_B;
    if (ground.exists) return wheelContact(hub_B, axis_B, body, ground);
    RoadContact below = ground;
    const Vector3 lowest_B = hub_B + wheel.tyre.parameters.Ro * wheel.down_B;
    below.point_W = body.position_W + times(body.to_world, lowest_B);
    below.normal_W = -times(body.to_world, wheel.down_B);
    below.velocity_W.setZero();
    return wheelContact(hub_B, axis_B, body, below);
}

// Where the side force acts: at the contact centre, or raised towards the height of the body's centre of gravity.
Vector3 sidePoint(const WheelContact& contact, const BodyWheel& wheel) {
    const Vector3& at = contact.point_B;
    return at - (1 - wheel.roll_share) * at.dot(wheel.down_B) * wheel.down_B;
}

// Compression of the strut and load of the tyre at the end of the step; the contact there.
WheelContact stand(BodyWheelState& state, const BodyWheel& wheel, const BodyMotion& before, const BodyMotion& body,
                   const RoadContact& ground, double steer, double partner, const Yielding& yielding, double dt) {
    WheelContact contact = hang(wheel, body, ground, steer, 0);
    StrutPush push{.deflection = -1,
                   .closing = 0,
                   .lift = 1,
                   .share = -wheel.down_B.dot(contact.normal_B),
                   .before = -1,
                   .heaving = dt * yielding.heaving,
                   .turning = dt * yielding.turning};
    if (ground.exists && push.share > kLeastShare) {
        const Vector3 hub_B = contact.hub_B - state.compression * wheel.down_B;
        push.deflection = wheel.tyre.parameters.Ro - contact.radius;
        push.closing = deflectionRate(contact, velocityAt(body, hub_B));
        const Vector3 road_W = ground.point_W - dt * ground.velocity_W;
        const Vector3 hub_W = before.position_W + times(before.to_world, contact.hub_B);
        push.before = wheel.tyre.parameters.Ro - (hub_W - road_W).dot(ground.normal_W) / contact.cosine;
        push.lift = push.share / contact.cosine;
    }
    const StrutYield end = yield(wheel.strut, wheel.tyre, push, state.compression, partner, dt);
    state.compression = end.compression;
    state.strut_rate = end.rate;
    state.strut_force = end.force;
    state.deflection = end.deflection;
    state.load = end.load;
    state.touches = end.deflection > 0;
    state.steer = steer;
    shift(contact, -end.compression * wheel.down_B);
    return contact;
}

TyreMotion motionOf(const WheelContact& contact, const BodyWheel& wheel, const BodyMotion& body, double steer_rate,
                    double load) {
    const Vector3 turning_B = body.angular_velocity_B - steer_rate * wheel.down_B;
    TyreMotion motion =
        tyreMotion(contact, velocityAt(body, contact.point_B), turning_B, grippingLoad(wheel.tyre, load));
    // The side slip is that of the place where the side force acts, or the tyre could give energy.
    motion.Vsy = -(velocityAt(body, sidePoint(contact, wheel)) - contact.ground_velocity_B).dot(contact.left_B);
    return motion;
}

// The mean drive torque over the step, with the slip speed at its end: the rim does not run past the limit, however
// short of inertia the wheel is. The road holds against it as in the last step.
double limitedTorque(const DriveLimit& limit, const BodyWheel& wheel, const BodyWheelState& state, double torque,
                     double dt) {
    const TyreCoefficients& p = wheel.tyre.parameters;
    const double sense = torque < 0 ? -1 : 1, most = std::abs(torque);
    const double gain = dt * p.Re / wheel.inertia;  // m/s of rim speed per torque
    const double slip = sense * (p.Re * state.spin - state.motion.Vx) - gain * sense * p.Ro * state.fx;
    const double loss = p.Ro * limit.loss;
    double left = (most - loss * slip) / (1 + loss * gain);
    if (limit.ends < kInfinity)
        left = std::min(left, most * (limit.ends - slip) / (limit.ends - limit.fades + gain * most));
    return sense * std::clamp(left, 0.0, most);
}

// Tyres and spins of up to four wheels, from `first` on.
void stepTyres(std::array<BodyWheelState, kMostWheels>& wheels, const WheeledBody& body, std::size_t first,
               const std::array<WheelContact, kMostWheels>& contacts,
               const std::array<TyreMotion, kMostWheels>& motions, std::span<const WheelDemand> begin,
               std::span<const WheelDemand> end, std::array<TyreForces, kMostWheels>& forces, double dt) {
    PerWheel<TyreState> states;
    PerWheel<double> spins;
    PerWheel<TyreFactors> factors;
    PerWheel<TyreMotion> from, to;
    PerWheel<TyreSpin> torques;
    const std::size_t count = std::min(body.wheel_count - first, kWheels);
    for (std::size_t k = 0; k < kWheels; ++k) {
        torques[k] = {1, 1, 0, 0};  // an idle place: a wheel at rest in the air
        if (k >= count) continue;
        const std::size_t i = first + k;
        states[k] = wheels[i].tyre;
        spins[k] = wheels[i].spin;
        from[k] = wheels[i].motion;
        to[k] = motions[i];
        factors[k].friction = contacts[i].friction * end[i].friction;
        const double drive = 0.5 * (begin[i].drive_torque + end[i].drive_torque);
        torques[k] = {body.wheels[i].inertia, contacts[i].radius,
                      limitedTorque(end[i].limit, body.wheels[i], wheels[i], drive, dt),
                      0.5 * (begin[i].brake_torque + end[i].brake_torque)};
    }
    const PerWheel<TyreForces> paper =
        advance(states, spins, body.packs[first / kWheels], factors, from, to, torques, dt);
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = first + k;
        BodyWheelState& wheel = wheels[i];
        forces[i] = toIso(paper[k]);
        wheel.grip = gripOf(body.wheels[i].tyre, to[k], factors[k].friction);
        limitToGrip(states[k], forces[i], body.wheels[i].tyre.parameters, wheel.grip);
        wheel.tyre = states[k];
        wheel.spin_rate = (spins[k] - wheel.spin) / dt;
        wheel.rotation += 0.5 * dt * (wheel.spin + spins[k]);
        wheel.spin = spins[k];
        wheel.motion = to[k];
    }
}

// What one wheel hands to the body, and what it shows.
void handOver(Wrench& wrench, BodyWheelState& state, const BodyWheel& wheel, const WheelContact& contact,
              const TyreForces& tyre, const BodyMotion& body, double steer_rate, bool reaction) {
    const Vector3 side = tyre.Fy * contact.left_B;
    const Vector3 rest = tyre.Fx * contact.forward_B + state.load * contact.normal_B;
    wrench.add(rest, contact.point_B);
    wrench.add(side, sidePoint(contact, wheel));
    wrench.moment_B += wheelMoment<double>(contact, tyre,
                                           {.inertia = reaction ? wheel.inertia : 0,
                                            .spin = state.spin,
                                            .spin_rate = state.spin_rate,
                                            .carrier_B = body.angular_velocity_B - steer_rate * wheel.down_B});

    state.fx = tyre.Fx;
    state.fy = tyre.Fy;
    state.mz = tyre.Mz;
    state.camber = contact.camber;
    state.contact_B = toArray(contact.point_B);
    state.force_W = toArray(times<Vector3>(body.to_world, rest + side));
    state.steer_torque = -wheel.down_B.dot((contact.point_B - contact.hub_B).cross(rest + side) +
                                           tyre.Mz * contact.normal_B + tyre.Mx * contact.forward_B);
    const double rolling_speed = rollingRadius(wheel.tyre, state.motion.Fz) * state.spin;
    state.slip_power = slipPower(state.motion, state.tyre, rolling_speed, tyre.Fx, tyre.Fy);
}

// Accelerations that a wrench gives the body; what a game holds back does not happen.
Accelerations accelerationsOf(const WheeledBody& body, const BodyMotion& motion, const Wrench& wrench,
                              const Vector3& gravity_W) {
    const Vector3& w = motion.angular_velocity_B;
    Vector3 spin;
    for (int k = 0; k < 3; ++k) spin[k] = body.inverse_inertia[k] > 0 ? w[k] / body.inverse_inertia[k] : 0;
    const Vector3 moment = wrench.moment_B - w.cross(spin);
    const Vector3 a = times(motion.to_world, wrench.force_B) / body.mass + gravity_W;
    const Vector3 alpha = times<Vector3>(motion.to_world, body.inverse_inertia.cwiseProduct(moment));
    return {body.linear_factor_W.cwiseProduct(a), body.angular_factor_W.cwiseProduct(alpha)};
}

}  // namespace

Vector3 strutTop(const ChassisMotion& motion, const BodyWheel& wheel) {
    return motion.position_W + motion.orientation * wheel.top_B;
}

Vector3 wheelCentre(const ChassisMotion& motion, const BodyWheel& wheel, double compression) {
    return motion.position_W + motion.orientation * (wheel.top_B + (wheel.strut.length - compression) * wheel.down_B);
}

void setDown(WheeledBodyState& state, const ChassisMotion& motion, const WheeledBody& body, std::size_t wheel,
             const RoadContact& ground) {
    BodyWheelState& s = state.wheels[wheel];
    const BodyWheel& params = body.wheels[wheel];
    const BodyMotion now = bodyMotion(motion);
    const WheelContact contact = hang(params, now, ground, s.steer, s.compression);
    s.tyre = {};
    s.motion = motionOf(contact, params, now, 0, 0);
    s.spin = s.motion.Vx / params.tyre.parameters.Re;
    s.spin_rate = 0;
}

void advance(ChassisMotion& motion, WheeledBodyState& state, const WheeledBody& body,
             std::span<const WheelDemand> begin, std::span<const WheelDemand> end, std::span<const RoadContact> ground,
             const Vector3& gravity_W, double dt) {
    ChassisMotion next = predicted(motion, state.acceleration_W, state.angular_acceleration_W, dt);
    const BodyMotion before = bodyMotion(motion);
    const BodyMotion moved = bodyMotion(next);

    // Struts and loads; the other end of an anti-roll bar counts as it was.
    std::array<WheelContact, kMostWheels> contacts;
    std::array<TyreMotion, kMostWheels> motions;
    std::array<double, kMostWheels> compressed;
    for (std::size_t i = 0; i < body.wheel_count; ++i) compressed[i] = state.wheels[i].compression;
    for (std::size_t i = 0; i < body.wheel_count; ++i) {
        const BodyWheel& wheel = body.wheels[i];
        const double partner = wheel.partner < body.wheel_count ? compressed[wheel.partner] : compressed[i];
        contacts[i] = stand(state.wheels[i], wheel, before, moved, ground[i], end[i].steer, partner, body.yielding, dt);
        const double steer_rate = (end[i].steer - begin[i].steer) / dt;
        motions[i] = motionOf(contacts[i], wheel, moved, steer_rate, state.wheels[i].load);
    }

    // Tyres and spins, four at a time.
    std::array<TyreForces, kMostWheels> forces;
    for (std::size_t first = 0; first < body.wheel_count; first += kWheels)
        stepTyres(state.wheels, body, first, contacts, motions, begin, end, forces, dt);

    // One wrench moves the body.
    Wrench wrench;
    for (std::size_t i = 0; i < body.wheel_count; ++i) {
        const double steer_rate = (end[i].steer - begin[i].steer) / dt;
        handOver(wrench, state.wheels[i], body.wheels[i], contacts[i], forces[i], moved, steer_rate,
                 body.wheel_reaction);
    }
    correctMotion(next, state.acceleration_W, state.angular_acceleration_W,
                  accelerationsOf(body, moved, wrench, gravity_W), dt);
    motion = next;
}

}  // namespace tread
