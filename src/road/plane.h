// A plane road with grade and bank.
#pragma once

#include <cmath>

#include "tread/road.h"

namespace tread {

class PlaneRoad final : public Road {
public:
    // Rises by `grade` along x and by `bank` along y (tangents); `friction` scales that of the tyre file.
    explicit PlaneRoad(double grade = 0, double bank = 0, double friction = 1) {
        contact_.normal_W = Vector3(-grade, -bank, 1).normalized();
        contact_.friction = friction;
    }

    RoadContact contact(const Vector3&, std::size_t) const override { return contact_; }

private:
    RoadContact contact_;
};

}  // namespace tread
