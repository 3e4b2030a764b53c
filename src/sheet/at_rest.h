// The car standing on a level road: what its data sheet starts from.
#pragma once

#include "tread/vehicle.h"

namespace tread::sheet {

struct AtRest {
    Vehicle vehicle;
    double height;              // m, of the centre of gravity above the road
    PerWheel<double> load;      // N
    PerWheel<double> travel;    // m
    PerWheel<double> radius;    // m, wheel centre to road
    PerWheel<TyreParams> tyre;  // at its pressure and temperature

    const VehicleParams& car() const { return vehicle.params; }
    const AxleParams& axle(std::size_t axle) const { return axle == 0 ? car().front : car().rear; }
    double rearDistance() const { return car().wheelbase - car().front_axle_distance; }
    // Sum over the wheels of an axle.
    double sum(const PerWheel<double>& values, std::size_t axle) const {
        return values[2 * axle] + values[2 * axle + 1];
    }
    double axleLoad(std::size_t axle) const { return sum(load, axle); }
    double meanRadius(std::size_t axle) const { return 0.5 * sum(radius, axle); }
};

AtRest atRest(const VehicleParams& params);

// Slope of the suspension force of a wheel over its travel, N/m, when the other wheel of the axle moves the same way
// (`with` 1) or the other way (-1, which twists the anti-roll bar).
double wheelRate(const AtRest& rest, std::size_t wheel, double with);

// Damping of a wheel, N s/m: mean of bump and rebound, without dry friction.
double wheelDamping(const AtRest& rest, std::size_t wheel);

}  // namespace tread::sheet
