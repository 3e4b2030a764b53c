/* The rigid body of this host, moved as game engines do: velocities first, then the pose with them. */
#pragma once

#include "tread/c_api.h"

typedef struct rigid_body {
    double mass;          /* kg */
    double inertia[3][3]; /* kg m2, in its own axes */
    tread_motion motion;
} rigid_body;

/* Force and moment in the world, at the centre of gravity; the weight is added. */
void rigid_body_step(rigid_body* body, const double force[3], const double moment[3], double dt);
