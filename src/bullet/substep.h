// Steps of a car within one step of the Bullet world: how long they may be, and how many of them it takes.
#pragma once

#include <algorithm>
#include <cmath>

namespace tread {

class Substep {
public:
    static constexpr double kShortest = 1e-4;  // s
    static constexpr double kLongest = 0.02;   // s: one step of a game
    static constexpr double kUsual = 0.001;    // s: 60 Hz and 1000 Hz then differ by rounding of the step alone

    // Within the limits; what is no number is the shortest.
    void limit(double longest) { longest_ = longest >= kShortest ? std::min(longest, kLongest) : kShortest; }

    // How many equal ones make a step of the world, s.
    int within(double dt) const { return std::max(1, static_cast<int>(std::ceil(dt / longest_ - 1e-6))); }

private:
    double longest_ = kUsual;
};

}  // namespace tread
