// A step of the body on its wheels: velocity Verlet for the body with an implicit step of every wheel inside it, as in
// vehicle.cpp.
#include "vehicle/wheeled_body.h"

#include <algorithm>
#include <cmath>

#include "vehicle/body.h"
#include "vehicle/strut.h"
#include "vehicle/touch.h"

namespace tread {
namespace {

// Struts that lean on the ground by more than about 84 degrees carry nothing.
constexpr double kLeastShare = 0.1;
// The carcass can hold what the road gives, and a little more while the patch swings; what it stores beyond that when
// the load drops would kick the wheel.
constexpr double kCarcassExcess = 1.02;
// The formulas of the tyre are polynomials in its load, fitted to at most about twice the nominal one: what a landing
// brings beyond this many times the nominal load carries, but does not grip.
constexpr double kMostGripLoad = 4;

double length(double x, double y) {
    return std::sqrt(x * x + y * y);
}

// Compression of the strut and load of the tyre at the end of the step; the touch there.
Touch stand(BodyWheelState& state, const BodyWheel& wheel, const Frame& frame, const RoadContact& ground, double steer,
            double partner, double dt) {
    Touch t = extended(wheel, frame, ground, steer);
    StrutPush push{.deflection = -1, .closing = 0, .lift = 1, .share = -wheel.down_B.dot(t.normal_B)};
    if (ground.exists && push.share > kLeastShare) {
        const Vector3 hub_B = t.hub_B - state.compression * wheel.down_B;
        push.deflection = wheel.tyre.parameters.Ro - t.radius;
        push.closing = -(velocityAt(frame, hub_B) - t.ground_velocity_B).dot(t.normal_B) / t.cosine;
        push.lift = push.share / t.cosine;
    }
    const StrutYield end = yield(wheel.strut, wheel.tyre, push, state.compression, partner, dt);
    state.compression = end.compression;
    state.strut_rate = end.rate;
    state.strut_force = end.force;
    state.deflection = end.deflection;
    state.load = end.load;
    state.touches = end.load > 0;
    state.steer = steer;
    compress(t, wheel, end.compression);
    return t;
}

TyreMotion motionOf(const Touch& t, const BodyWheel& wheel, const Frame& frame, double steer_rate, double load) {
    TyreMotion motion;
    motion.Vx = (velocityAt(frame, t.point_B) - t.ground_velocity_B).dot(t.forward_B);
    motion.Vsy = -(velocityAt(frame, t.side_B) - t.ground_velocity_B).dot(t.left_B);
    motion.psidot = -(frame.angular_velocity_B - steer_rate * wheel.down_B).dot(t.normal_B);
    motion.gamma = t.camber;
    motion.Fz = std::min(load, kMostGripLoad * wheel.tyre.parameters.Fzo);
    return motion;
}

// The most that a tyre can hold: peak friction at its load.
double gripOf(const TyreParams& tyre, double load, double friction) {
    const TyreCoefficients& p = tyre.parameters;
    const double dfz = load / (p.Fzo * tyre.lambda.Fzo) - 1;
    const double along = (p.pDx1 + p.pDx2 * dfz) * tyre.lambda.mux, across = (p.pDy1 + p.pDy2 * dfz) * tyre.lambda.muy;
    return std::max({along, across, 0.0}) * friction * load;
}

// Lets go of what the carcass stores beyond the grip, and of the forces that come of it.
void limit(TyreState& tyre, TyreForces& forces, const TyreCoefficients& p, double grip) {
    const double most = kCarcassExcess * grip;
    const double stored = length(p.cFx * tyre.u, p.cFy * tyre.v);
    if (stored > most) {
        tyre.u *= most / stored;
        tyre.v *= most / stored;
    }
    const double force = length(forces.Fx, forces.Fy);
    if (force > most) {
        const double share = most / force;
        forces.Fx *= share;
        forces.Fy *= share;
        forces.Mz *= share;
    }
}

// Tyres and spins of up to four wheels, from `first` on.
void stepTyres(std::array<BodyWheelState, kMostWheels>& wheels, const WheeledBody& body, std::size_t first,
               const std::array<Touch, kMostWheels>& touches, const std::array<TyreMotion, kMostWheels>& motions,
               std::span<const WheelDemand> begin, std::span<const WheelDemand> end,
               std::array<TyreForces, kMostWheels>& forces, double dt) {
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
        factors[k].friction = touches[i].friction * end[i].friction;
        torques[k] = {body.wheels[i].inertia, touches[i].radius, 0.5 * (begin[i].drive_torque + end[i].drive_torque),
                      0.5 * (begin[i].brake_torque + end[i].brake_torque)};
    }
    const PerWheel<TyreForces> paper =
        advance(states, spins, body.packs[first / kWheels], factors, from, to, torques, dt);
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = first + k;
        BodyWheelState& wheel = wheels[i];
        forces[i] = toIso(paper[k]);
        wheel.grip = gripOf(body.wheels[i].tyre, to[k].Fz, factors[k].friction);
        limit(states[k], forces[i], body.wheels[i].tyre.parameters, wheel.grip);
        wheel.tyre = states[k];
        wheel.spin_rate = (spins[k] - wheel.spin) / dt;
        wheel.rotation += 0.5 * dt * (wheel.spin + spins[k]);
        wheel.spin = spins[k];
        wheel.motion = to[k];
    }
}

// What one wheel hands to the body, and what it shows.
void handOver(Wrench& wrench, BodyWheelState& state, const BodyWheel& wheel, const Touch& t, const TyreForces& tyre,
              const Frame& frame, double steer_rate) {
    const Vector3 side = tyre.Fy * t.left_B;
    const Vector3 rest = tyre.Fx * t.forward_B + state.load * t.normal_B;
    wrench.add(rest, t.point_B);
    wrench.add(side, t.side_B);
    wrench.moment_B += tyre.Mx * t.forward_B + tyre.My * t.left_B + tyre.Mz * t.normal_B;
    wrench.moment_B -= wheel.inertia * state.spin_rate * t.axis_B;
    const Vector3 turning = frame.angular_velocity_B - steer_rate * wheel.down_B;
    wrench.moment_B -= turning.cross(wheel.inertia * state.spin * t.axis_B);

    state.fx = tyre.Fx;
    state.fy = tyre.Fy;
    state.mz = tyre.Mz;
    state.camber = t.camber;
    state.contact_B = toArray(t.point_B);
    state.force_W = toArray(frame.to_world * (rest + side));
    state.steer_torque =
        -wheel.down_B.dot((t.point_B - t.hub_B).cross(rest + side) + tyre.Mz * t.normal_B + tyre.Mx * t.forward_B);
    const double Vsx = state.motion.Vx - wheel.tyre.parameters.Re * state.spin + state.tyre.du;
    const double Vsy = state.motion.Vsy + state.tyre.dv;
    state.slip_power = std::max(-tyre.Fx * Vsx + tyre.Fy * Vsy, 0.0);  // Fy counts to the left, Vsy to the right
}

// Velocities and accelerations that the wrench at the end of the step gives, in place of the predicted ones.
void correct(ChassisMotion& motion, WheeledBodyState& state, const WheeledBody& body, const Frame& frame,
             const Wrench& wrench, const Vector3& gravity_W, double dt) {
    const Vector3& w = frame.angular_velocity_B;
    Vector3 spin;
    for (int k = 0; k < 3; ++k) spin[k] = body.inverse_inertia[k] > 0 ? w[k] / body.inverse_inertia[k] : 0;
    const Vector3 moment = wrench.moment_B - w.cross(spin);
    const Vector3 a = body.linear_factor_W.cwiseProduct(frame.to_world * wrench.force_B / body.mass + gravity_W);
    const Vector3 alpha =
        body.angular_factor_W.cwiseProduct(frame.to_world * body.inverse_inertia.cwiseProduct(moment));
    for (int k = 0; k < 3; ++k) {
        motion.velocity_W[k] += 0.5 * dt * (a[k] - state.acceleration_W[static_cast<std::size_t>(k)]);
        motion.angular_velocity_W[k] +=
            0.5 * dt * (alpha[k] - state.angular_acceleration_W[static_cast<std::size_t>(k)]);
    }
    state.acceleration_W = toArray(a);
    state.angular_acceleration_W = toArray(alpha);
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
    const Frame frame = frameOf(motion);
    Touch t = extended(params, frame, ground, s.steer);
    compress(t, params, s.compression);
    s.tyre = {};
    s.motion = motionOf(t, params, frame, 0, 0);
    s.spin = s.motion.Vx / params.tyre.parameters.Re;
    s.spin_rate = 0;
}

void advance(ChassisMotion& motion, WheeledBodyState& state, const WheeledBody& body,
             std::span<const WheelDemand> begin, std::span<const WheelDemand> end, std::span<const RoadContact> ground,
             const Vector3& gravity_W, double dt) {
    ChassisMotion next = predicted(motion, state.acceleration_W, state.angular_acceleration_W, dt);
    const Frame frame = frameOf(next);

    // Struts and loads; the other end of an anti-roll bar counts as it was.
    std::array<Touch, kMostWheels> touches;
    std::array<TyreMotion, kMostWheels> motions;
    std::array<double, kMostWheels> before;
    for (std::size_t i = 0; i < body.wheel_count; ++i) before[i] = state.wheels[i].compression;
    for (std::size_t i = 0; i < body.wheel_count; ++i) {
        const BodyWheel& wheel = body.wheels[i];
        const double partner = wheel.partner < body.wheel_count ? before[wheel.partner] : before[i];
        touches[i] = stand(state.wheels[i], wheel, frame, ground[i], end[i].steer, partner, dt);
        const double steer_rate = (end[i].steer - begin[i].steer) / dt;
        motions[i] = motionOf(touches[i], wheel, frame, steer_rate, state.wheels[i].load);
    }

    // Tyres and spins, four at a time.
    std::array<TyreForces, kMostWheels> forces;
    for (std::size_t first = 0; first < body.wheel_count; first += kWheels)
        stepTyres(state.wheels, body, first, touches, motions, begin, end, forces, dt);

    // One wrench moves the body.
    Wrench wrench;
    for (std::size_t i = 0; i < body.wheel_count; ++i) {
        const double steer_rate = (end[i].steer - begin[i].steer) / dt;
        handOver(wrench, state.wheels[i], body.wheels[i], touches[i], forces[i], frame, steer_rate);
    }
    correct(next, state, body, frame, wrench, gravity_W, dt);
    motion = next;
}

}  // namespace tread
