// Steps of a car within one step of the Bullet world: how long they may be, and how many of them it takes.
#pragma once

#include <algorithm>
#include <cmath>

namespace tread {

class Substep {
public:
    static constexpr double kShortest = 1e-4;  // s
    static constexpr double kLongest = 0.02;   // s, of a whole car

    // As long as `usual` until limited, and never longer than `most`, s.
    constexpr Substep(double usual, double most) : longest_(usual), most_(most) {}

    // Within the limits; what is no number is the shortest.
    void limit(double longest) { longest_ = longest >= kShortest ? std::min(longest, most_) : kShortest; }

    // How many equal ones make a step of the world, s; none longer than `most` either, down to a millisecond.
    int within(double dt, double most) const {
        const double longest = std::min(longest_, std::max(most, 1e-3));
        return std::max(1, static_cast<int>(std::ceil(dt / longest - 1e-6)));
    }
    int within(double dt) const { return within(dt, longest_); }

private:
    double longest_, most_;
};

}  // namespace tread
