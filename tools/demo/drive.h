// A drive in the demo: track, car, marks and clock, without window or pictures.
#pragma once

#include "script.h"
#include "traces.h"

namespace tread::demo {

class Drive {
public:
    Drive();

    void begin(Place place, double speed = 0, double heading = 0);
    void step(const Pedals& pedals);
    // Steps as often as the time asks for; the pose shown is between the last two steps.
    void run(const Pedals& pedals, double seconds);
    void changeRate(int steps);

    Track track;
    Car car{track};
    SkidMarks marks;
    double rate = 60;  // Hz
    Place place = Place::plane;
    double time = 0;  // s
    CarPose shown;

private:
    CarPose before_, now_;
    double left_ = 0;  // s, not yet stepped
};

}  // namespace tread::demo
