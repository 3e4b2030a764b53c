// The step at which the benchmarks of cars advance.
#pragma once

namespace tread {

inline constexpr double kStep = 0.001;  // s

}  // namespace tread
