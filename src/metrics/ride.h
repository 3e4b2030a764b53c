// What the evaluation of a ride and its figures share.
#pragma once

namespace tread {

inline constexpr double kRideApproach = 2;  // s at the beginning, in which the road may still be smooth

}  // namespace tread
