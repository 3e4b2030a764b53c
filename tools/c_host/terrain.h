/* The terrain of this host: low hills, and ice on a part of them. */
#pragma once

#include "tread/c_api.h"

/* The tangent plane below a wheel, for tread. */
void terrain_below(void* user, int wheel, const double centre[3], tread_plane* plane);
