// Included first by the headers that are C++20.
#pragma once

#if __cplusplus < 202002L
#error "This header of tread needs C++20; tread/raycast_vehicle.h and tread/raycast_fleet.h need C++17 only."
#endif
