#include "terrain.h"

#include <math.h>

static const double hill_height = 0.4;  /* m */
static const double hill_number = 0.15; /* rad/m, along x; half of it along y */
static const double ice_from = 150;     /* m */
static const double ice_friction = 0.5;

void terrain_below(void* user, int wheel, const double centre[3], tread_plane* plane) {
    const double kx = hill_number, ky = 0.5 * hill_number;
    const double x = centre[0], y = centre[1];
    (void)user;
    (void)wheel;
    plane->point[0] = x;
    plane->point[1] = y;
    plane->point[2] = hill_height * (1 - cos(kx * x) * cos(ky * y));
    plane->normal[0] = -hill_height * kx * sin(kx * x) * cos(ky * y);
    plane->normal[1] = -hill_height * ky * cos(kx * x) * sin(ky * y);
    plane->normal[2] = 1;
    plane->friction = x > ice_from ? ice_friction : 1;
}
