#include "vehicle/fleet/lane_kind.h"

#include <bit>
#include <cstring>
#include <new>

#include "road/plane.h"
#include "vehicle/fleet/lane_numbers.h"

namespace tread {

#ifdef __x86_64__
extern const LaneKind kEightLanes;  // lane_cars_avx512.cpp
extern const LaneKind kFourLanes;   // lane_cars_avx2.cpp
#endif

namespace {

LaneSuspension<double> numbersOf(const SuspensionParams& s) {
    return {.spring = s.spring,
            .damper = {s.damper.bump, s.damper.rebound, s.damper.friction},
            .anti_roll_bar = s.anti_roll_bar,
            .bump_stop = s.bump_stop,
            .rebound_stop = s.rebound_stop,
            .side_view_slope_braking = s.side_view_slope_braking,
            .side_view_slope_driving = s.side_view_slope_driving,
            .camber = s.camber,
            .camber_by_travel = s.camber_by_travel,
            .toe = s.toe,
            .toe_by_travel = s.toe_by_travel,
            .steer_by_lateral_force = s.steer_by_lateral_force,
            .steer_by_aligning_moment = s.steer_by_aligning_moment,
            .steer_by_longitudinal_force = s.steer_by_longitudinal_force,
            .camber_by_lateral_force = s.camber_by_lateral_force};
}

LaneCorner<double> numbersOf(const Vehicle::Corner& c) {
    return {.hub_B = {c.hub_B.x(), c.hub_B.y(), c.hub_B.z()},
            .static_force = c.static_force,
            .lateral_slope = c.lateral_slope,
            .unsprung_mass = c.unsprung_mass,
            .wheel_inertia = c.wheel_inertia,
            .tyre = {c.tyre.parameters, c.tyre.lambda},
            .tyre_shift = {c.tyre_shift.slip, c.tyre_shift.camber},
            .temperature = c.temperature,
            .aligning_stiffness = c.aligning_stiffness};
}

bool isStraight(const SuspensionParams& s) {
    return s.spring_curve.empty() && s.damper.bump_curve.empty() && s.damper.rebound_curve.empty();
}

}  // namespace

const LaneKind* laneKind([[maybe_unused]] std::size_t most_lanes) {
#ifdef __x86_64__
    if (most_lanes >= kEightLanes.lanes && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl"))
        return &kEightLanes;
    if (most_lanes >= kFourLanes.lanes && __builtin_cpu_supports("avx2")) return &kFourLanes;
#endif
    return nullptr;
}

std::shared_ptr<void> memoryFor(const LaneKind& kind) {
    const std::align_val_t aligned{kind.alignment};
    void* memory = operator new(kind.bytes, aligned);
    std::memset(memory, 0, kind.bytes);
    return {memory, [aligned](void* p) { operator delete(p, aligned); }};
}

std::optional<GroundNumbers> planeOf(const Road& road) {
    const auto* plane = dynamic_cast<const PlaneRoad*>(&road);
    if (!plane) return std::nullopt;
    return numbersOf(plane->contact(Vector3::Zero(), 0));
}

bool fitsInLane(const Vehicle& vehicle) {
    return isStraight(vehicle.params.front.suspension) && isStraight(vehicle.params.rear.suspension) &&
           !vehicle.recedes;
}

std::vector<double> numbersOf(const Vehicle& vehicle) {
    LaneNumbers<double> n;
    n.params.mass = vehicle.params.mass;
    n.params.inertia = vehicle.params.inertia;
    n.params.front.suspension = numbersOf(vehicle.params.front.suspension);
    n.params.rear.suspension = numbersOf(vehicle.params.rear.suspension);
    for (std::size_t i = 0; i < kWheels; ++i) n.corners[i] = numbersOf(vehicle.corners[i]);
    for (int i = 0; i < 6; ++i) {
        for (int k = 0; k < 6; ++k) n.inverse_mass.element[i][k] = vehicle.inverse_mass(i, k);
    }
    const auto numbers = std::bit_cast<std::array<double, kLaneNumbers>>(n);
    return {numbers.begin(), numbers.end()};
}

MotionNumbers numbersOf(const ChassisMotion& m) {
    const auto& [p, q, v, w] = m;
    return {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z(), v.x(), v.y(), v.z(), w.x(), w.y(), w.z()};
}

ChassisMotion motionOf(const MotionNumbers& n) {
    return {{n[0], n[1], n[2]}, {n[3], n[4], n[5], n[6]}, {n[7], n[8], n[9]}, {n[10], n[11], n[12]}};
}

GroundNumbers numbersOf(const RoadContact& contact) {
    const auto& [p, n, v, friction, exists] = contact;
    return {p.x(), p.y(), p.z(), n.x(), n.y(), n.z(), v.x(), v.y(), v.z(), friction, exists ? 1.0 : 0.0};
}

void askRoad(const Road& road, const std::array<double, 3>& centre_W, std::size_t wheel, GroundNumbers& ground) {
    ground = numbersOf(road.contact({centre_W[0], centre_W[1], centre_W[2]}, wheel));
}

}  // namespace tread
