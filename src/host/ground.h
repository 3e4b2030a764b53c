// The ground of a host program: planes that it sets under each wheel, a function that it is asked with, or any road.
#pragma once

#include <array>
#include <functional>
#include <memory>

#include "tread/road.h"
#include "tread/wheels.h"

namespace tread::host {

// The plane of the ground below (or above) a wheel centre.
using GroundFunction = std::function<RoadContact(const Vector3& centre_W, std::size_t wheel)>;

class Ground final : public Road {
public:
    // One of three; the last call counts. At first: the plane z = 0 under each wheel.
    void use(std::shared_ptr<Road> road);
    void use(GroundFunction function);
    void setPlane(std::size_t wheel, const RoadContact& plane);

    const std::array<RoadContact, kWheels>& planes() const { return planes_; }
    void setPlanes(const std::array<RoadContact, kWheels>& planes) { planes_ = planes; }

    void beginStep() override;
    RoadContact contact(const Vector3& centre_W, std::size_t wheel) const override;

    // Refuses, naming the wheel, when the function has answered with something that is no plane; the wheel had no
    // ground then.
    void throwIfFaulty() const;

private:
    std::array<RoadContact, kWheels> planes_{};
    GroundFunction function_;
    std::shared_ptr<Road> road_;
    mutable int faulty_wheel_ = -1;  // the first one with such an answer
};

}  // namespace tread::host
