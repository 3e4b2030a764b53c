#include "host/snapshot.h"

#include <cstring>

#include "host/failure.h"
#include "host/version.h"

namespace tread::host {
namespace {

// The numbers of a snapshot without what is not trivially copyable; as they lie in memory: bytes are for the machine
// and the program that wrote them.
struct Plain {
    std::array<double, 3> position, velocity, angular_velocity, wind, link_velocity, link_angular_velocity;
    std::array<double, 4> orientation;  // w x y z
    VehicleState state;
    VehicleInput input, next;
    std::array<std::array<double, 11>, kWheels> planes;  // point, normal, velocity, friction, whether there is one
    double ramps, time, time_rest, carried, yaw;
};
static_assert(std::is_trivially_copyable_v<Plain>);

struct Head {
    std::array<char, 8> mark;
    std::uint64_t layout, car, content;
};
constexpr std::array<char, 8> kMark{'t', 'r', 'e', 'a', 'd', 'c', 'a', 'r'};

// Counts up when the meaning of a number changes and the sizes do not.
constexpr std::uint64_t kMeaning = 1;

std::uint64_t layout() {
    const std::array<std::uint64_t, 3> facts{kMeaning, sizeof(Plain), sizeof(VehicleState)};
    return hashOf(std::as_bytes(std::span(facts)), hashOf(std::as_bytes(std::span(version()))));
}

std::array<double, 3> toArray(const Vector3& v) {
    return {v.x(), v.y(), v.z()};
}
Vector3 toVector(const std::array<double, 3>& a) {
    return {a[0], a[1], a[2]};
}

std::array<double, 11> toArray(const RoadContact& c) {
    return {c.point_W.x(),    c.point_W.y(),    c.point_W.z(),    c.normal_W.x(), c.normal_W.y(),      c.normal_W.z(),
            c.velocity_W.x(), c.velocity_W.y(), c.velocity_W.z(), c.friction,     c.exists ? 1.0 : 0.0};
}
RoadContact toPlane(const std::array<double, 11>& a) {
    return {{a[0], a[1], a[2]}, {a[3], a[4], a[5]}, {a[6], a[7], a[8]}, a[9], a[10] != 0};
}

}  // namespace

std::uint64_t hashOf(std::span<const std::byte> bytes, std::uint64_t basis) {
    for (const std::byte byte : bytes) basis = (basis ^ static_cast<std::uint64_t>(byte)) * 1099511628211u;
    return basis;
}

std::size_t snapshotSize() {
    return sizeof(Head) + sizeof(Plain);
}

std::vector<std::byte> bytesOf(const Snapshot& s, std::uint64_t car) {
    Plain plain;
    std::memset(static_cast<void*>(&plain), 0, sizeof plain);
    const Quaternion& q = s.motion.orientation;
    plain.position = toArray(s.motion.position_W);
    plain.velocity = toArray(s.motion.velocity_W);
    plain.angular_velocity = toArray(s.motion.angular_velocity_W);
    plain.wind = toArray(s.wind_W);
    plain.link_velocity = toArray(s.link.velocity_W);
    plain.link_angular_velocity = toArray(s.link.angular_velocity_W);
    plain.orientation = {q.w(), q.x(), q.y(), q.z()};
    plain.state = s.state;
    plain.input = s.input;
    plain.next = s.next;
    for (std::size_t i = 0; i < kWheels; ++i) plain.planes[i] = toArray(s.planes[i]);
    plain.ramps = s.ramps ? 1 : 0;
    plain.time = s.time;
    plain.time_rest = s.time_rest;
    plain.carried = s.carried;
    plain.yaw = s.yaw;

    const std::span<const std::byte> content = std::as_bytes(std::span(&plain, 1));
    const Head head{kMark, layout(), car, hashOf(content)};
    std::vector<std::byte> bytes(snapshotSize());
    std::memcpy(bytes.data(), &head, sizeof head);
    std::memcpy(bytes.data() + sizeof head, &plain, sizeof plain);
    return bytes;
}

Snapshot snapshotOf(std::span<const std::byte> bytes, std::uint64_t car) {
    Head head;
    if (bytes.size() < sizeof head) refuse("found bytes that are no state of a car: they are too few");
    std::memcpy(&head, bytes.data(), sizeof head);
    if (head.mark != kMark) refuse("found bytes that are no state of a car");
    if (head.layout != layout())
        refuse("found a state that another version of tread has written; use it with that version");
    if (bytes.size() != snapshotSize()) refuse("found a state that is incomplete, or followed by something else");
    if (head.car != car)
        refuse("found the state of another car, expected one of this car: with the same parameters and the same step");
    const std::span<const std::byte> content = bytes.subspan(sizeof head);
    if (hashOf(content) != head.content) refuse("found a state that is damaged: its checksum is another");
    Plain plain;
    std::memcpy(static_cast<void*>(&plain), content.data(), sizeof plain);

    Snapshot s;
    const auto& q = plain.orientation;
    s.motion = {
        toVector(plain.position), {q[0], q[1], q[2], q[3]}, toVector(plain.velocity), toVector(plain.angular_velocity)};
    s.wind_W = toVector(plain.wind);
    s.link = {toVector(plain.link_velocity), toVector(plain.link_angular_velocity)};
    s.state = plain.state;
    s.input = plain.input;
    s.next = plain.next;
    for (std::size_t i = 0; i < kWheels; ++i) s.planes[i] = toPlane(plain.planes[i]);
    s.ramps = plain.ramps != 0;
    s.time = plain.time;
    s.time_rest = plain.time_rest;
    s.carried = plain.carried;
    s.yaw = plain.yaw;
    return s;
}

}  // namespace tread::host
