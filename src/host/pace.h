// Steps of a car within one step of its host.
//
// A host's step that is a whole number of inner steps, to 1e-6 of one, takes that many inner steps of exactly their own
// length: what comes out does not depend on how the host divides its time. What is missing or too much of such a step
// is carried to the next, so that the times of car and host do not drift apart. Any other step is divided into equal
// ones, no longer than an inner step; one of less than 10 us waits for the next.
#pragma once

#include <cmath>

namespace tread::host {

struct Steps {
    long count;
    double length;  // s, of each
};

class Pace {
public:
    static constexpr double kShortest = 1e-5;  // s: differences over shorter steps are mostly rounding [guess]

    explicit Pace(double step) : step_(step) {}

    double step() const { return step_; }
    double carried() const { return carried_; }  // s, by which the host is ahead of the car
    void carry(double time) { carried_ = time; }

    // Steps within the next `duration` of the host; none when it is shorter than what counts.
    Steps within(double duration) {
        const double ahead = carried_ + duration;
        const double whole = std::round(ahead / step_);
        if (std::abs(ahead - whole * step_) <= kRounding * step_) {
            carried_ = ahead - whole * step_;
            return {static_cast<long>(whole), step_};
        }
        carried_ = ahead < kShortest ? ahead : 0;
        if (carried_ > 0) return {0, step_};
        const double count = std::ceil(ahead / step_);
        return {static_cast<long>(count), ahead / count};
    }

private:
    static constexpr double kRounding = 1e-6;  // of a step: far above the rounding of times, far below what is felt

    double step_;
    double carried_ = 0;
};

}  // namespace tread::host
