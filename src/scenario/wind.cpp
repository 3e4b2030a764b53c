#include "scenario/wind.h"

#include <algorithm>
#include <numbers>

#include "base/math/elementary.h"

namespace tread {
namespace {

// How far the car is into the gust, as a share of its duration or length; a step is over as it begins.
double progress(const GustParams& gust, double time, double x) {
    const double into = gust.time ? time - *gust.time : x - gust.x.value_or(0);
    const double extent = gust.shape == GustShape::step ? 0 : (gust.time ? gust.duration : gust.length).value_or(0);
    if (into < 0) return 0;
    return into < extent ? into / extent : 1;
}

double profile(GustShape shape, double progress) {
    switch (shape) {
        case GustShape::none:
            return 0;
        case GustShape::step:
        case GustShape::ramp:
            return progress;
        case GustShape::cosine:
            return 0.5 * (1 - cosine(2 * std::numbers::pi * progress));
    }
    return 0;
}

}  // namespace

Vector3 windAt(const WindParams& wind, double time, double x) {
    const double speed = wind.speed + wind.gust.speed * profile(wind.gust.shape, progress(wind.gust, time, x));
    return {speed * cosine(wind.direction) + wind.x, speed * sine(wind.direction) + wind.y, 0};
}

}  // namespace tread
