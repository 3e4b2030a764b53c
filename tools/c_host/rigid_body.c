#include "rigid_body.h"

#include <math.h>

static const double gravity = 9.80665; /* m/s2 */

/* Axes of the body in the world, as columns. */
static void axes_of(const double q[4], double axes[3][3]) {
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    axes[0][0] = 1 - 2 * (y * y + z * z);
    axes[0][1] = 2 * (x * y - w * z);
    axes[0][2] = 2 * (x * z + w * y);
    axes[1][0] = 2 * (x * y + w * z);
    axes[1][1] = 1 - 2 * (x * x + z * z);
    axes[1][2] = 2 * (y * z - w * x);
    axes[2][0] = 2 * (x * z - w * y);
    axes[2][1] = 2 * (y * z + w * x);
    axes[2][2] = 1 - 2 * (x * x + y * y);
}

/* Solves inertia x = moment by Cramer's rule. */
static void solve(const double m[3][3], const double b[3], double x[3]) {
    double cofactor[3][3], determinant = 0;
    int i, j;
    for (i = 0; i < 3; ++i) {
        for (j = 0; j < 3; ++j) {
            const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            cofactor[i][j] = m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1];
        }
    }
    for (j = 0; j < 3; ++j) determinant += m[0][j] * cofactor[0][j];
    for (i = 0; i < 3; ++i) {
        x[i] = 0;
        for (j = 0; j < 3; ++j) x[i] += cofactor[j][i] * b[j] / determinant;
    }
}

/* Turns q by the rotation vector r, in the world. */
static void turn(double q[4], const double r[3]) {
    const double angle = sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
    const double s = angle > 0 ? sin(0.5 * angle) / angle : 0.5;
    const double a = cos(0.5 * angle), b = s * r[0], c = s * r[1], d = s * r[2];
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    double length = 0;
    int i;
    q[0] = a * w - b * x - c * y - d * z;
    q[1] = a * x + b * w + c * z - d * y;
    q[2] = a * y - b * z + c * w + d * x;
    q[3] = a * z + b * y - c * x + d * w;
    for (i = 0; i < 4; ++i) length += q[i] * q[i];
    for (i = 0; i < 4; ++i) q[i] /= sqrt(length);
}

void rigid_body_step(rigid_body* body, const double force[3], const double moment[3], double dt) {
    tread_motion* m = &body->motion;
    double axes[3][3], moment_B[3], change_B[3], rotation[3];
    int i, j;
    axes_of(m->orientation, axes);
    for (i = 0; i < 3; ++i) {
        moment_B[i] = 0;
        for (j = 0; j < 3; ++j) moment_B[i] += axes[j][i] * moment[j];
    }
    solve((const double(*)[3])body->inertia, moment_B, change_B);
    for (i = 0; i < 3; ++i) {
        m->velocity[i] += dt * (force[i] / body->mass - (i == 2 ? gravity : 0));
        m->position[i] += dt * m->velocity[i];
        for (j = 0; j < 3; ++j) m->angular_velocity[i] += dt * axes[i][j] * change_B[j];
        rotation[i] = dt * m->angular_velocity[i];
    }
    turn(m->orientation, rotation);
}
