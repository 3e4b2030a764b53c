// Parts of the car's state that several of its sub-models have in common: plain numbers, so that a copy is a snapshot.
#pragma once

#include <array>
#include <cstddef>

namespace tread {

// A signal and its past, for a pure time delay.
struct DelayLine {
    static constexpr std::size_t kIntervals = 200;  // of the delay: no longer than a millisecond for one of 0.2 s

    std::array<double, kIntervals + 1> past{};  // at equal distances of time
    std::size_t newest = 0;                     // index of the newest of these
    double age = 0;                             // s, since the newest
};

// A part that yields to the aligning moment of tyres.
template <class T>
struct BasicAligningCompliance {
    T deflection = 0;  // rad
    T rate = 0;        // rad/s, over the last step
    T moment = 0;      // N m, at the beginning of the last step, without what the resistance took from it
};
using AligningCompliance = BasicAligningCompliance<double>;

}  // namespace tread
