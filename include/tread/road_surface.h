// A described road as analytic queries, without rays.
//
// A tyre is no point: it lies on a stretch of road and does not feel what is much shorter. Its contact is the plane
// that touches the road averaged over a square of `contact_length`, level with the road's (the fixed-footprint model of
// K. M. Captain, A. B. Boghani, D. N. Wormley, Analytical tire models for dynamic vehicle simulation, Vehicle System
// Dynamics 8, 1979). Height and normal are those of one surface, so that a wheel rolls over it without gaining energy
// to the first order of the slope. A step of the road becomes a slope as long as the contact; a wheel that meets an
// obstacle higher than about a tenth of its radius would touch it earlier than this model says.
#pragma once

#include <memory>
#include <vector>

#include "tread/api.h"
#include "tread/height_field.h"
#include "tread/road.h"
#include "tread/road_params.h"

namespace tread {

class TREAD_API RoadSurface final : public Road {
public:
    explicit RoadSurface(const RoadParams& params);
    ~RoadSurface() override;

    // The wheel's plane below (or above) its centre, along z.
    RoadContact contact(const Vector3& centre_W, std::size_t wheel) const override;

    SurfacePoint at(double x, double y) const;        // of the road itself
    SurfacePoint averaged(double x, double y) const;  // as a tyre feels it
    double friction(double x, double y) const;

private:
    struct TREAD_INTERNAL Parts;
    SurfacePoint base(double x, double y) const;
    SurfacePoint fieldAveraged(double x, double y) const;

    std::unique_ptr<const Parts> parts_;
};

// The simplest road that is what the parameters say: a plane is a plane.
TREAD_API std::unique_ptr<Road> makeRoad(const RoadParams& params);

// A rectangle of the road.
struct RoadArea {
    double x_from, x_to;  // m
    double y_from, y_to;
};

// The road's own height at the points of a grid that covers the area, for example for a collision shape.
TREAD_API HeightField sampled(const RoadSurface& road, const RoadArea& area, double spacing);

}  // namespace tread
