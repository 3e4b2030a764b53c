#include "tread/raycast_fleet.h"

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>

#include <algorithm>

#include "base/threads/crew.h"
#include "bullet/drop_in/raycast_parts.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

struct RaycastFleet::Implementation {
    explicit Implementation(int threads) : crew(std::max(threads, 1) - 1), many(threads > 1) {}

    Crew crew;
    bool many;
    std::mutex one_at_a_time{};  // the game's own raycasters and surfaces
    std::vector<RaycastVehicle*> vehicles{};
    std::vector<RaycastVehicle*> awake{};  // in this step
    std::vector<Footprint> of_all{};       // vehicles, in the last step
    std::vector<Footprint> of_awake{};     // and of those that are awake, one more than there are
};

RaycastFleet::RaycastFleet(int threads) : self_(new Implementation(threads)) {}

RaycastFleet::~RaycastFleet() {
    for (RaycastVehicle* vehicle : self_->vehicles) vehicle->self_->one_at_a_time = nullptr;
    delete self_;
}

void RaycastFleet::add(RaycastVehicle& vehicle) {
    auto& all = self_->vehicles;
    if (std::find(all.begin(), all.end(), &vehicle) != all.end()) return;
    all.push_back(&vehicle);
    vehicle.self_->one_at_a_time = self_->many ? &self_->one_at_a_time : nullptr;
}

void RaycastFleet::remove(RaycastVehicle& vehicle) {
    if (std::erase(self_->vehicles, &vehicle) > 0) vehicle.self_->one_at_a_time = nullptr;
}

int RaycastFleet::size() const {
    return static_cast<int>(self_->vehicles.size());
}

void RaycastFleet::updateAction(btCollisionWorld* world, btScalar step) {
    auto& [crew, many, one_at_a_time, vehicles, awake, of_all, of_awake] = *self_;
    awake.clear();
    of_awake.clear();
    of_all.resize(vehicles.size() + 1);
    for (std::size_t i = 0; i < vehicles.size(); ++i) {
        RaycastVehicle& vehicle = *vehicles[i];
        of_all[i] = vehicle.self_->footprint();
        vehicle.self_->fetchInputs(of_all[i + 1]);
        if (!world || !vehicle.self_->isIn(*world) || !vehicle.self_->begin(world, step)) continue;
        awake.push_back(&vehicle);
        of_awake.push_back(of_all[i]);
    }
    of_awake.emplace_back();
    const auto drive = [&cars = awake, &footprints = of_awake, world, step](std::size_t i) {
        cars[i]->self_->fetchInputs(footprints[i + 1]);
        cars[i]->self_->fetchState(footprints[i + 1]);
        cars[i]->self_->drive(world, step);
    };
    std::exception_ptr thrown;
    try {
        crew.each(awake.size(), drive);
    } catch (...) {
        thrown = std::current_exception();
    }
    for (RaycastVehicle* vehicle : awake) vehicle->self_->finish();
    if (thrown) std::rethrow_exception(thrown);
}

void RaycastFleet::debugDraw(btIDebugDraw* drawer) {
    for (RaycastVehicle* vehicle : self_->vehicles) vehicle->debugDraw(drawer);
}
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
