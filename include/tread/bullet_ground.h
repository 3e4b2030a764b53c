// A height field as a collision shape: for bodies in a Bullet world the same ground as for the wheels.
//
//     const tread::RoadSurface road(params);
//     tread::BulletGround ground(sampled(road, {0, 200, -5, 5}, 0.1));
//     btRigidBody body({0, nullptr, &ground.shape()});
//     body.setWorldTransform(ground.place());
#pragma once

#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <LinearMath/btScalar.h>
#include <LinearMath/btTransform.h>

#include <memory>
#include <vector>

#include "tread/api.h"
#include "tread/bullet_precision.h"
#include "tread/height_field.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

// The same triangles as those of HeightField::at, z up; nothing beyond the border.
class TREAD_API BulletGround {
public:
    explicit BulletGround(const HeightField& field);
    BulletGround(const BulletGround&) = delete;
    BulletGround& operator=(const BulletGround&) = delete;

    btHeightfieldTerrainShape& shape() { return *shape_; }
    btTransform place() const { return place_; }  // of the body that carries the shape

private:
    std::vector<btScalar> heights_;  // as Bullet wants them: along x first
    std::unique_ptr<btHeightfieldTerrainShape> shape_;
    btTransform place_;
};
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
