/* Drives a car of tread over the terrain of this host and prints a log of it:
 *
 *     c_host CAR.yaml own     tread moves the chassis
 *     c_host CAR.yaml body    the host's rigid body is the chassis
 *
 * The log is one that `tread compare` reads. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "rigid_body.h"
#include "terrain.h"
#include "tread/c_api.h"

static const double dt = 0.005;    /* s, the step of this host */
static const double duration = 12; /* s */
static const double speed = 15;    /* m/s, at the start */

static const char* const shown[] = {"chassis.x",        "chassis.y",        "chassis.z",
                                    "chassis.roll",     "chassis.yaw",      "chassis.vx",
                                    "chassis.yaw_rate", "steering.angle",   "wheel.front_left.load",
                                    "wheel.rear_right.load"};
enum { shown_count = sizeof shown / sizeof *shown };

/* A slalom from 2 s on, the brake from 9 s on. */
static void drive(double time, double inputs[]) {
    inputs[tread_input_index("steering_wheel_angle")] = time > 2 ? 0.6 * sin(1.5 * (time - 2)) : 0;
    if (time > 9) {
        inputs[tread_input_index("throttle")] = 0;
        inputs[tread_input_index("brake")] = 0.25;
    }
}

static void print_header(void) {
    int i;
    printf("time [s]");
    for (i = 0; i < shown_count; ++i)
        printf(",%s [%s]", shown[i], tread_output_unit((size_t)tread_output_index(shown[i])));
    printf("\n");
}

static tread_status print_row(tread_car* car) {
    double outputs[TREAD_MOST_OUTPUTS];
    const tread_status status = tread_car_outputs(car, outputs, tread_output_count());
    int i;
    printf("%.9g", tread_car_time(car));
    for (i = 0; i < shown_count; ++i) printf(",%.17g", outputs[tread_output_index(shown[i])]);
    printf("\n");
    return status;
}

/* The body of this host, made of what the car is and put where it starts. */
static tread_status make_body(tread_car* car, rigid_body* body) {
    tread_body is = {.size = sizeof is};
    tread_status status = tread_car_body(car, &is);
    if (status != TREAD_OK) return status;
    body->mass = is.mass;
    memcpy(body->inertia, is.inertia, sizeof is.inertia);
    body->motion.size = sizeof body->motion;
    return tread_car_motion(car, &body->motion);
}

static tread_status step(tread_car* car, rigid_body* body) {
    tread_force push = {.size = sizeof push};
    tread_status status;
    if (!body) return tread_car_advance(car, dt);
    status = tread_car_push(car, &body->motion, dt, TREAD_SEMI_IMPLICIT, &push);
    if (status == TREAD_OK) rigid_body_step(body, push.force, push.moment, dt);
    return status;
}

static tread_status run(tread_car* car, rigid_body* body) {
    const tread_start start = {.size = sizeof start, .x = 5, .speed = speed};
    double inputs[TREAD_MOST_INPUTS] = {0};
    long k;
    tread_status status = tread_car_use_ground(car, terrain_below, NULL);
    if (status == TREAD_OK) status = tread_car_start(car, &start);
    if (status == TREAD_OK) status = tread_car_inputs(car, inputs, tread_input_count());
    if (status == TREAD_OK && body) status = make_body(car, body);
    for (k = 0; status == TREAD_OK && k * dt < duration; ++k) {
        status = print_row(car);
        drive((double)(k + 1) * dt, inputs);
        if (status == TREAD_OK) status = tread_car_set_inputs(car, inputs, tread_input_count(), TREAD_RAMP);
        if (status == TREAD_OK) status = step(car, body);
    }
    return status;
}

int main(int argc, char** argv) {
    char error[2000];
    rigid_body body;
    tread_car* car;
    tread_status status;
    if (argc != 3 || (strcmp(argv[2], "own") != 0 && strcmp(argv[2], "body") != 0)) {
        fprintf(stderr, "usage: c_host CAR.yaml own|body\n");
        return TREAD_FAULTY;
    }
    car = tread_car_load(argv[1], NULL, error, sizeof error);
    if (!car) {
        fprintf(stderr, "%s\n", error);
        return TREAD_FAULTY;
    }
    print_header();
    status = run(car, strcmp(argv[2], "body") == 0 ? &body : NULL);
    if (status != TREAD_OK) fprintf(stderr, "%s\n", tread_car_error(car));
    tread_car_free(car);
    return status;
}
