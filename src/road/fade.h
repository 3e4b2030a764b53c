// A surface that begins somewhere along the road and grows smoothly to its full height.
#pragma once

#include "tread/height_field.h"

namespace tread {

// `surface` at `way` m behind its beginning, fully there after `length` m.
inline SurfacePoint fadedIn(SurfacePoint surface, double way, double length) {
    if (way <= 0) return {};
    if (way >= length) return surface;
    const double share = way / length;
    SurfacePoint faded = share * share * (3 - 2 * share) * surface;
    faded.slope_x += 6 * share * (1 - share) / length * surface.height;
    return faded;
}

}  // namespace tread
