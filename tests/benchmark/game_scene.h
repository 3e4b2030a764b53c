// The grounds on which a game's car is measured: plane, height field and mesh of the same gentle hills.
#pragma once

#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>

#include <cmath>
#include <memory>
#include <vector>

#include "stock_vs_tread/scene.h"

namespace tread::game {

enum class Ground { plane, height_field, mesh };

// Hills of 2 cm, 20 m long, on a grid of 2 m; about 100 000 triangles.
class Hills {
public:
    static constexpr int kSide = 225;
    static constexpr double kGrid = 2;  // m

    void add(scene::World& world, Ground ground) {
        if (ground == Ground::plane) {
            world.addPlane();
            return;
        }
        heights_.resize(kSide * kSide);
        const auto height = [](int i, int j) { return 0.02 * std::sin(0.6 * i) * std::sin(0.6 * j); };
        for (int j = 0; j < kSide; ++j) {
            for (int i = 0; i < kSide; ++i)
                heights_[static_cast<std::size_t>(j * kSide + i)] = static_cast<float>(height(i, j));
        }
        if (ground == Ground::height_field) {
            auto shape =
                std::make_unique<btHeightfieldTerrainShape>(kSide, kSide, heights_.data(), -0.02f, 0.02f, 1, false);
            shape->setLocalScaling(scene::vector(kGrid, 1, kGrid));
            shape->buildAccelerator();
            world.add(std::move(shape));
            return;
        }
        const auto at = [&](int i, int j) {
            return scene::vector(kGrid * (i - kSide / 2), height(i, j), kGrid * (j - kSide / 2));
        };
        scene::addGrid(mesh_, kSide, kSide, at);
        world.add(std::make_unique<btBvhTriangleMeshShape>(&mesh_, true));
    }

private:
    std::vector<float> heights_;
    btTriangleMesh mesh_;
};

}  // namespace tread::game
