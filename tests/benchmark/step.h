// The time step of the benchmarks of cars.
#pragma once

namespace tread {

inline constexpr double kStep = 0.001;  // s

}  // namespace tread
