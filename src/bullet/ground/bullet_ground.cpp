#include "tread/bullet_ground.h"

#include <algorithm>

#include "bullet/convert.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

BulletGround::BulletGround(const HeightField& field) {
    const std::size_t rows = field.rows();
    const auto columns = static_cast<std::size_t>(field.columns);
    heights_.reserve(field.heights.size());
    for (std::size_t j = 0; j < columns; ++j) {
        for (std::size_t i = 0; i < rows; ++i) heights_.push_back(static_cast<btScalar>(field.node(i, j)));
    }
    constexpr int kUp = 2;
    const auto [lowest, highest] = std::minmax_element(heights_.begin(), heights_.end());
    shape_ = std::make_unique<btHeightfieldTerrainShape>(static_cast<int>(rows), field.columns, heights_.data(),
                                                         *lowest, *highest, kUp, false);
    shape_->setLocalScaling(
        btVector3(static_cast<btScalar>(field.x_spacing), static_cast<btScalar>(field.y_spacing), 1));

    // Bullet centres the grid and its range of heights on the origin of the body.
    const double middle_x = field.x_first + 0.5 * field.x_spacing * static_cast<double>(rows - 1);
    const double middle_y = field.y_first + 0.5 * field.y_spacing * static_cast<double>(columns - 1);
    const double middle_z = 0.5 * (static_cast<double>(*lowest) + static_cast<double>(*highest));
    place_ = btTransform(btQuaternion::getIdentity(), toBullet(Vector3(middle_x, middle_y, middle_z)));
}
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
