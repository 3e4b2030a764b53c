// What a step reads and writes of a car, for the processor to have it in time.
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>

#include "bullet/drop_in/raycast_parts.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

Footprint RaycastVehicle::Implementation::footprint() {
    const std::size_t count = wheelCount();
    Footprint own{addressOf(this), addressOf(&chassis), count > 0 ? addressOf(&info(0)) : 0, count, {}};
    for (std::size_t i = 0; i < std::min(count, Footprint::kWheels); ++i)
        own.faces[i] = {addressOf(near[i].faces.data()), near[i].faces.size() * sizeof(NearFaces::Face)};
    return own;
}

// A member of another car lies where this car's does.
void RaycastVehicle::Implementation::fetchMember(const Footprint& next, const void* member, std::size_t bytes) const {
    fetchAhead(next.car + (addressOf(member) - addressOf(this)), bytes);
}

void RaycastVehicle::Implementation::fetchInputs(const Footprint& next) const {
    if (next.car == 0) return;
    const std::size_t n = next.wheel_count;
    fetchAhead(next.chassis, sizeof(btRigidBody));
    fetchAhead(next.wheels, n * sizeof(btWheelInfo));
    fetchMember(next, &face, sizeof face);
    fetchMember(next, recipe.body.data(), sizeof recipe.body);
    fetchMember(next, recipe.wheels.data(), n * sizeof recipe.wheels[0]);
    fetchMember(next, &motion, addressOf(&state) - addressOf(&motion));
}

void RaycastVehicle::Implementation::fetchState(const Footprint& next) const {
    if (next.car == 0) return;
    const auto perWheel = [&](const auto& member) { fetchMember(next, &member, next.wheel_count * sizeof member[0]); };
    perWheel(state.wheels);
    perWheel(demands);
    perWheel(grounds);
    perWheel(near);
    perWheel(impulses);
    perWheel(shown_length);
    perWheel(drawn);
    perWheel(drawn_before);
    for (const Block& faces : next.faces) faces.fetch();
}
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
