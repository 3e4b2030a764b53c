// The ground of a Bullet world as a road: one ray per wheel and step.
#pragma once

#include <LinearMath/btScalar.h>

#include <array>

#include "tread/api.h"
#include "tread/bullet_precision.h"
#include "tread/road.h"
#include "tread/wheels.h"

class btCollisionObject;
class btCollisionWorld;

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

// Casts a ray from above each wheel centre along gravity. The car's own body and objects without contact response
// (triggers) are no ground. Between two beginStep() a wheel keeps the plane that its ray found.
class TREAD_API BulletRoad final : public Road {
public:
    // `world` and `own_body` must outlive the road. `ray_length`: m, from the wheel centre down; `up` is a unit vector.
    BulletRoad(const btCollisionWorld& world, const btCollisionObject& own_body, const Vector3& up = Vector3::UnitZ(),
               double ray_length = 1.5);

    void beginStep() override;
    RoadContact contact(const Vector3& centre_W, std::size_t wheel) const override;

private:
    RoadContact cast(const Vector3& centre_W) const;

    const btCollisionWorld& world_;
    const btCollisionObject& own_body_;
    Vector3 up_;
    double ray_length_;
    mutable std::array<RoadContact, kWheels> found_;
    mutable std::array<bool, kWheels> known_{};
};
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
