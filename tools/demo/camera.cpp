#include "camera.h"

#include <cmath>

namespace tread::demo {

using scene::scalar;
using scene::vector;

View Chase::look(const btTransform& chassis, Camera camera, double seconds) {
    constexpr double kFollows = 3.5;  // 1/s
    btVector3 forward = chassis.getBasis().getColumn(2);
    forward.setY(0);
    forward = forward.length() > scalar(0.1) ? forward.normalized() : behind_;
    behind_ = cut_ ? forward : behind_.lerp(forward, scalar(1 - std::exp(-kFollows * seconds)));
    if (behind_.length() < scalar(0.1)) behind_ = forward;
    behind_.normalize();
    cut_ = false;
    const btVector3 at = chassis.getOrigin(), up = vector(0, 1, 0);
    const btVector3 left = up.cross(behind_);
    View view{at, at};
    switch (camera) {
        case Camera::behind:
            view = {at - scalar(7.2) * behind_ + scalar(2.7) * up + scalar(1.6) * left, at + scalar(1.5) * behind_};
            break;
        case Camera::side:
            view = {at + vector(8, 2.2, -1.5), at};
            break;
        case Camera::above:
            view = {at - scalar(6) * behind_ + scalar(17) * up, at + scalar(3) * behind_};
            break;
    }
    if (view.eye.y() < scalar(0.4)) view.eye.setY(scalar(0.4));
    return view;
}

}  // namespace tread::demo
