// From where the car is seen.
#pragma once

#include "script.h"

namespace tread::demo {

struct View {
    btVector3 eye, target;
};

class Chase {
public:
    // Follows the car; the first look after `cut` is there at once.
    View look(const btTransform& chassis, Camera camera, double seconds);
    void cut() { cut_ = true; }

private:
    btVector3 behind_{0, 0, -1};  // direction in which the car went lately
    bool cut_ = true;
};

}  // namespace tread::demo
