#include "bullet/drop_in/stock_tuning.h"

#include <algorithm>
#include <cmath>

#include "bullet/convert.h"
#include "vehicle/tyre_load.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

namespace {

constexpr double kSmallestRadius = 0.005;  // m
constexpr double kLargestRadius = 20;      // m
constexpr double kLongestStrut = 20;       // m
constexpr double kMostForce = 1e9;         // N
constexpr double kMostDemand = 1000;       // of engine or brake, over the tyre's nominal load
// A spring is never softer than this share of its tyre's stiffness, nor harder than this multiple.
constexpr double kSoftestSpring = 1e-3;
constexpr double kHardestSpring = 9;
// A tyre made for the stock numbers is at least so many times as stiff as the stock spring: most of the way is the
// suspension's, as in a car. Besides, it is so stiff that the rim carries only when the suspension is at its stop.
constexpr double kSoftestTyre = 3;
// The stop at the end of the travel lets the car swing by no more than this: one step of a slow game follows it.
constexpr double kStopFrequency = 30;  // rad/s
// Wheels are about a twentieth of the mass that they carry, at 0.77 of their radius (a car's: 19 kg, 1 kg m2).
constexpr double kWheelMassShare = 0.05;
constexpr double kGyrationSquared = 0.6;
// The engine gives nothing any more when the rim is so fast, over the root of gravity times radius: a car's at 200 m/s.
constexpr double kFastestRim = 117;
// Likewise, slip speeds at which the engine's force is gone, and over how much it fades. [guess] For a car 14 m/s, of
// which a burnout with its wheels at 10 m/s feels nothing; for a wheel that is driven against its partner what turns
// vehicles of different shape as fast as the stock vehicle's at 60 steps a second, within a factor of two or a little
// more, at one and a half to ten times their weight.
constexpr double kSlipEnds = 8;
constexpr double kSlipEndsAgainst = 5;
constexpr double kSlipFading = 2;
constexpr double kLossAgainst = 1.4;  // of the weight on the wheel, per root of gravity times radius
// Gravity outside of these is none, m/s2.
constexpr double kLeastGravity = 1e-3;
constexpr double kMostGravity = 1e6;
constexpr double kLeastLoad = 1e-3;   // N
constexpr double kStepsOfStock = 60;  // 1/s, at which a stock brake impulse is taken
constexpr double kSteepestFriction = 1.2;

double within(double value, double lowest, double highest, double otherwise) {
    return std::isnan(value) ? otherwise : std::clamp(value, lowest, highest);
}

Vector3 direction(const btVector3& v, const Vector3& otherwise) {
    const Vector3 d = fromBullet(v);
    const double length = d.norm();
    return std::isfinite(length) && length > 1e-6 ? Vector3(d / length) : otherwise;
}

// Up to 1 as it is; beyond, towards the friction of the best road tyres.
double frictionOf(double slip) {
    slip = within(slip, 0, 1e6, 1);
    return slip <= 1 ? slip : kSteepestFriction - (kSteepestFriction - 1) / slip;
}

BodyWheel geometryOf(const btWheelInfo& info) {
    BodyWheel wheel;
    wheel.top_B = fromBullet(info.m_chassisConnectionPointCS);
    if (!wheel.top_B.allFinite()) wheel.top_B.setZero();
    wheel.down_B = direction(info.m_wheelDirectionCS, -Vector3::UnitY());
    // Bullet's wheels roll towards up x axle: their axles point to the right.
    wheel.left_B = direction(-info.m_wheelAxleCS, wheel.down_B.unitOrthogonal());
    if (wheel.left_B.cross(wheel.down_B).norm() < 0.1) wheel.left_B = wheel.down_B.unitOrthogonal();
    wheel.strut.length = within(info.m_suspensionRestLength1, 0, kLongestStrut, 0.3);
    return wheel;
}

double radiusOf(const btWheelInfo& info) {
    return within(info.m_wheelsRadius, kSmallestRadius, kLargestRadius, 0.3);
}

// Spring and tyre in series are as soft as the stock spring alone.
//
// With a tyre of somebody's own, strut and damper then are what is left. A tyre made for the stock numbers takes its
// part of the damping as well: of spring k and damper c it gets k/s and c/s, the strut k/(1-s) and c/(1-s), where s is
// the share of the way that the tyre gives. Both then give way in the same proportion at every instant, and between
// body and road is spring k with damper c, as in stock, at any stiffness and any damping. A tyre without damping that
// is softer than the spring would carry the motion past the damper, and the car would bounce on it for ever.
void suspend(BodyWheel& wheel, const btWheelInfo& info, double mass, bool own_numbers) {
    const double radius = radiusOf(info);
    StrutParams& strut = wheel.strut;
    double& pz1 = wheel.tyre.parameters.pz1;
    const double stock = within(info.m_suspensionStiffness * mass, 0, kMostForce, 0.2 * radialStiffness(wheel.tyre));
    strut.bump = within(info.m_wheelsDampingCompression * mass, 0, kMostForce, 0);
    strut.rebound = within(info.m_wheelsDampingRelaxation * mass, 0, kMostForce, 0);
    if (own_numbers) pz1 = std::max(pz1, stock * std::max(kSoftestTyre, strut.travel / (kRimDeflection * radius)));

    const double radial = radialStiffness(wheel.tyre);
    const double share = stock / radial;
    const double alone = share < kHardestSpring / (1 + kHardestSpring) ? share / (1 - share) : kHardestSpring;
    strut.stiffness = radial * std::max(alone, kSoftestSpring);
    if (!own_numbers) return;
    const double of_tyre = std::max(share, kSoftestSpring);
    strut.tyre_bump = strut.bump / of_tyre;
    strut.tyre_rebound = strut.rebound / of_tyre;
    strut.bump /= 1 - of_tyre;
    strut.rebound /= 1 - of_tyre;
}

// On the way round a planet gravity changes in every step, and by its last digits if it only turns: to this share of
// it, the tyres need not be made anew.
double rounded(double gravity) {
    constexpr double kParts = 8192;
    int exponent = 0;
    const double mantissa = std::frexp(gravity, &exponent);
    return std::ldexp(std::round(mantissa * kParts) / kParts, exponent);
}

// Masses and damping of a tyre are those of its size, whatever it weighs.
TyreParams tyreFor(const RestingLoad& resting, double radius) {
    TyreParams tyre = similarTyre(resting.force, radius);
    const double earthly = kStandardGravity / resting.gravity;
    for (double* of_mass : {&tyre.parameters.mc, &tyre.parameters.kFx, &tyre.parameters.kFy, &tyre.parameters.pz2})
        *of_mass *= earthly;
    return tyre;
}

double mostDemand(const BodyWheel& wheel) {
    return kMostDemand * wheel.tyre.parameters.Fzo;
}

double engineForce(const btWheelInfo& info, const BodyWheel& wheel) {
    return within(info.m_engineForce, -mostDemand(wheel), mostDemand(wheel), 0);
}

TyreParams mounted(const TyreParams& tyre, bool left) {
    return (tyre.side == TyreSide::left) == left ? tyre : mirrored(tyre);
}

}  // namespace

WheelTuning tuningOf(const btWheelInfo& w) {
    const btVector3 &top = w.m_chassisConnectionPointCS, &down = w.m_wheelDirectionCS, &axle = w.m_wheelAxleCS;
    return {{top.x(), top.y(), top.z(), down.x(), down.y(), down.z(), axle.x(), axle.y(), axle.z(),
             w.m_suspensionRestLength1, w.m_maxSuspensionTravelCm, w.m_wheelsRadius, w.m_suspensionStiffness,
             w.m_wheelsDampingCompression, w.m_wheelsDampingRelaxation, w.m_maxSuspensionForce, w.m_rollInfluence,
             w.m_bIsFrontWheel ? btScalar(1) : btScalar(0)}};
}

RestingLoad restingLoad(double mass, std::size_t wheels, double gravity) {
    gravity = gravity > kLeastGravity && gravity < kMostGravity ? rounded(gravity) : kStandardGravity;
    const double carried = mass / static_cast<double>(std::max<std::size_t>(wheels, 1));
    return {std::max(carried * gravity, kLeastLoad), gravity};
}

BodyWheel wheelFromTuning(const btWheelInfo& info, double mass, const RestingLoad& resting,
                          const std::optional<TyreParams>& tyre) {
    BodyWheel wheel = geometryOf(info);
    const double radius = radiusOf(info);
    wheel.tyre = tyre ? *tyre : tyreFor(resting, radius);
    wheel.inertia = kGyrationSquared * kWheelMassShare * resting.mass() * radius * radius;
    wheel.roll_share = within(info.m_rollInfluence, 0, 1, 0.1);

    wheel.strut.most_force = within(info.m_maxSuspensionForce, 0, kMostForce, kMostForce);
    wheel.strut.travel =
        within(0.01 * info.m_maxSuspensionTravelCm, 0, wheel.strut.length + 0.5 * radius, wheel.strut.length);
    suspend(wheel, info, mass, !tyre);
    wheel.strut.stop = kStopFrequency * kStopFrequency * resting.mass();
    return wheel;
}

BodyWheel wheelFromFile(const btWheelInfo& info, const VehicleParams& params, bool left, const RestingLoad& resting,
                        const std::optional<TyreParams>& tyre) {
    const AxleParams& axle = info.m_bIsFrontWheel ? params.front : params.rear;
    const WheelParams& own = left ? axle.left : axle.right;
    BodyWheel wheel = geometryOf(info);
    wheel.tyre = tyre ? *tyre : mounted(own.tyre ? *own.tyre : axle.tyre, left);
    wheel.inertia = axle.wheel_inertia;
    wheel.strut.stiffness = std::max(axle.suspension.spring, kSoftestSpring * radialStiffness(wheel.tyre));
    wheel.strut.bump = axle.suspension.damper.bump;
    wheel.strut.rebound = axle.suspension.damper.rebound;
    wheel.strut.most_force = kMostForce;
    wheel.strut.travel = resting.force / wheel.strut.stiffness + axle.suspension.bump_stop.clearance;
    wheel.strut.anti_roll_bar = axle.suspension.anti_roll_bar;
    return wheel;
}

DriveLimit driveLimit(const btWheelInfo& info, const btWheelInfo* partner, const BodyWheel& wheel) {
    const double speed = wheel.own_speed;
    const double own = engineForce(info, wheel), other = partner ? engineForce(*partner, wheel) : own;
    const double against = own != 0 ? std::clamp(1 - other / own, 0.0, 1.0) : 0;
    const double ends = kSlipEnds - against * (kSlipEnds - kSlipEndsAgainst);
    return {kLossAgainst * against * wheel.tyre.parameters.Fzo / speed, (ends - kSlipFading) * speed, ends * speed};
}

WheelDemand demandOf(const btWheelInfo& info, const BodyWheel& wheel, double spin, bool from_file) {
    const double radius = wheel.tyre.parameters.Ro;
    const double most = mostDemand(wheel);
    const double force = engineForce(info, wheel);
    const double rim = spin * radius / (kFastestRim * wheel.own_speed);
    const double left = rim * force > 0 ? std::max(1 - rim * rim, 0.0) : 1;
    WheelDemand demand;
    demand.steer = within(info.m_steering, -kMostSteer, kMostSteer, 0);
    // At the loaded radius that is a little more than the force asked for: about what spinning the wheel up and rolling
    // it take, so that the car accelerates as the stock vehicle does.
    demand.drive_torque = left * force * radius;
    demand.brake_torque = within(info.m_brake * kStepsOfStock, 0, most, 0) * radius;
    demand.friction = from_file ? 1 : frictionOf(info.m_frictionSlip);
    return demand;
}
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
