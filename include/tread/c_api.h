// tread for C, and for every language that can call C: a car that a host program steps.
//
//     char error[400];
//     tread_car* car = tread_car_load("vehicles/compact.yaml", NULL, error, sizeof error);
//     const tread_start start = {.size = sizeof start, .speed = 20};
//     tread_car_start(car, &start);
//     double inputs[TREAD_MOST_INPUTS] = {0}, outputs[TREAD_MOST_OUTPUTS];
//     const int steering = tread_input_index("steering_wheel_angle");
//     const int yaw_rate = tread_output_index("chassis.yaw_rate");
//     for (;;) {
//         inputs[steering] = 0.3;
//         tread_car_set_inputs(car, inputs, tread_input_count(), TREAD_HELD);
//         if (tread_car_advance(car, 0.01) != TREAD_OK) puts(tread_car_error(car));
//         tread_car_outputs(car, outputs, tread_output_count());
//         outputs[yaw_rate];
//     }
//
// Numbers are SI units and radians. Axes are ISO 8855 in the car (x forward, y left, z up) and z up in the world,
// gravity 9.80665 m/s2. Wheels are 0 front left, 1 front right, 2 rear left, 3 rear right.
//
// A call that fails says so by its status, changes nothing unless it says otherwise, and leaves a sentence for
// tread_car_error(). No exception leaves these functions. Two cars do not know of each other: each may have its thread;
// one car is for one thread at a time. Pointers may not be NULL where nothing else is said.
//
// Structs begin with their size, which the caller sets to sizeof: members that later versions add at the end then have
// their defaults.
#pragma once

#include <stddef.h>

#include "tread/api.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct tread_car tread_car;

// The numbers are the exit statuses of the program `tread`.
typedef enum tread_status {
    TREAD_OK = 0,
    TREAD_FAULTY = 2,  // what the caller gave; the car can go on
    TREAD_BROKEN = 3   // the car broke down: start it again, or set a state of before
} tread_status;

// "0.1.0".
TREAD_API const char* tread_version(void);

// ---- A car ----

typedef struct tread_options {
    size_t size;
    double step;  // s, of the car, 0.0001 to 0.01; 0: 0.001
} tread_options;

// The car of a vehicle file, or of its text; files that the text includes are looked for in the current folder. `name`
// stands for the file in messages. `options` may be NULL.
// NULL when it fails: `error`, unless NULL, then has one line for each fault, cut to error_size bytes with its zero.
TREAD_API tread_car* tread_car_load(const char* file, const tread_options* options, char* error, size_t error_size);
TREAD_API tread_car* tread_car_parse(const char* text, const char* name, const tread_options* options, char* error,
                                     size_t error_size);

// NULL is allowed.
TREAD_API void tread_car_free(tread_car* car);

// What the last call that failed on this car found and expected; "" when none has. Valid until the next call.
TREAD_API const char* tread_car_error(const tread_car* car);

// Sets a parameter by its path to what could stand in the file: tread_car_set(car, "mass", "1.4 t"),
// tread_car_set(car, "front.suspension.spring", "25000"). `tread describe vehicle` lists the paths. A started car takes
// it at its next start.
TREAD_API tread_status tread_car_set(tread_car* car, const char* path, const char* value);

// Reads a parameter that is a number, in SI units.
TREAD_API tread_status tread_car_parameter(tread_car* car, const char* path, double* value);

// ---- What surrounds it ----

// The ground under one wheel, as its tangent plane in the world.
typedef struct tread_plane {
    size_t size;
    double point[3];     // m, any point of it
    double normal[3];    // out of the ground, of any length
    double velocity[3];  // m/s, of the ground itself
    double friction;     // scales the friction of the tyre, at least 0
    int exists;          // 0: nothing under the wheel
} tread_plane;

// Gives the ground below (or above) a wheel's centre, m in the world. `plane` is z = 0 with friction 1 when it is
// called; the function changes what differs. It is called several times in each step of 1 ms, and by tread_car_start
// for the place of the start with some height of the centre; on the thread of the caller. It calls nothing on this car.
typedef void (*tread_ground_function)(void* user, int wheel, const double centre[3], tread_plane* plane);

// From now on the function is asked. NULL: the planes count again.
TREAD_API tread_status tread_car_use_ground(tread_car* car, tread_ground_function function, void* user);

// From now on this plane is under the wheel, until another is set; z = 0 with friction 1 at first. Planes count, no
// longer the function.
TREAD_API tread_status tread_car_set_plane(tread_car* car, int wheel, const tread_plane* plane);

// Velocity of the air from now on, m/s in the world. Still at first.
TREAD_API tread_status tread_car_set_wind(tread_car* car, const double velocity[3]);

// ---- Start ----

typedef struct tread_start {
    size_t size;
    double x, y;           // m
    double heading;        // rad, 0 along x, positive to the left
    double speed;          // m/s, forward, at least 0
    const double* inputs;  // tread_input_count() of them, as brakes are held at the start; NULL: none
} tread_start;

// Puts the car on its ground in equilibrium at time 0, so that nothing moves that the driver does not move. Its inputs
// are then those that hold speed and heading (tread_car_inputs).
TREAD_API tread_status tread_car_start(tread_car* car, const tread_start* start);

// ---- Inputs and outputs: arrays of numbers, whose names do not change within a version ----

enum { TREAD_MOST_INPUTS = 64, TREAD_MOST_OUTPUTS = 512 };  // room that suffices

TREAD_API size_t tread_input_count(void);
TREAD_API const char* tread_input_name(size_t index);     // "throttle"; NULL beyond the last
TREAD_API const char* tread_input_unit(size_t index);     // "rad"; "-" for a pure number
TREAD_API const char* tread_input_meaning(size_t index);  // "throttle pedal"
TREAD_API int tread_input_index(const char* name);        // -1: there is none of this name

TREAD_API size_t tread_output_count(void);
TREAD_API const char* tread_output_name(size_t index);     // "wheel.front_left.load"
TREAD_API const char* tread_output_unit(size_t index);     // "N"
TREAD_API const char* tread_output_meaning(size_t index);  // "front left wheel: normal load of the tyre"
TREAD_API int tread_output_index(const char* name);

typedef enum tread_course {
    TREAD_HELD = 0,  // the new inputs hold from the beginning of the next step of the host
    TREAD_RAMP = 1   // the inputs move linearly from the last ones to these at the end of the next step
} tread_course;

// The first `count` inputs; the others are 0. A pedal beyond its range is at the end of its range.
TREAD_API tread_status tread_car_set_inputs(tread_car* car, const double* values, size_t count, tread_course course);
TREAD_API tread_status tread_car_inputs(tread_car* car, double* values, size_t count);

// The first `count` outputs at the car's time, or one by its name.
TREAD_API tread_status tread_car_outputs(tread_car* car, double* values, size_t count);
TREAD_API tread_status tread_car_output(tread_car* car, const char* name, double* value);

// s, since the start.
TREAD_API double tread_car_time(const tread_car* car);

// ---- Step: tread moves the chassis ----

// Advances car and chassis by any duration, s. One that is a whole number of the car's steps gives the same bits
// however the host divides its time; any other is divided into equal steps that are no longer; one of less than 10 us
// waits for the next.
// A step that breaks the car, or finds no plane where it asked for the ground, is not undone.
TREAD_API tread_status tread_car_advance(tread_car* car, double duration);

// ---- Step: the host's rigid body is the chassis ----

// What the host makes its body of. Its origin is the centre of gravity, its axes are ISO 8855.
typedef struct tread_body {
    size_t size;
    double mass;           // kg, of the whole car
    double inertia[3][3];  // kg m2, of the whole car about the centre of gravity
    double reference[3];   // m, from it to the point to which the outputs `chassis` refer (not 0 in a loaded car)
} tread_body;
TREAD_API tread_status tread_car_body(tread_car* car, tread_body* body);

typedef struct tread_motion {
    size_t size;
    double position[3];          // m, of the centre of gravity, in the world
    double orientation[4];       // w x y z, from the car's axes to the world's
    double velocity[3];          // m/s, in the world
    double angular_velocity[3];  // rad/s, in the world
} tread_motion;

// The motion of the car. After tread_car_start the host puts its body there.
TREAD_API tread_status tread_car_motion(tread_car* car, tread_motion* motion);

// How the host moves a body under a force that it holds over its step.
typedef enum tread_integration {
    TREAD_EXACT = 0,         // to second order or better, with gyroscopic moments
    TREAD_SEMI_IMPLICIT = 1  // velocity first, then the pose with it, without gyroscopic moments: most game engines
} tread_integration;

typedef struct tread_force {
    size_t size;
    double force[3];                 // N, on the centre of gravity, in the world; the host adds the weight
    double moment[3];                // N m, about the centre of gravity, in the world
    double acceleration[3];          // m/s2, of force and weight together
    double angular_acceleration[3];  // rad/s2, by which the body's angular velocity has to change
} tread_force;

// Advances the car on the host's body, which shows this motion now, by `duration` (at least 10 us), and gives the
// constant force and moment that take the body along. What else acts on the body is felt at the next call, as a change
// of its velocities.
// A call that fails as tread_car_advance() can is not undone.
TREAD_API tread_status tread_car_push(tread_car* car, const tread_motion* body, double duration,
                                      tread_integration integration, tread_force* force);

// ---- State ----

// The car's state as bytes, from which it goes on bit for bit: on this version of tread, with the same parameters and
// the same step; others refuse it. Planes, wind and inputs are part of it, a ground function is not.
TREAD_API size_t tread_car_state_size(const tread_car* car);
TREAD_API tread_status tread_car_get_state(tread_car* car, void* bytes, size_t size);
TREAD_API tread_status tread_car_set_state(tread_car* car, const void* bytes, size_t size);

#ifdef __cplusplus
}
#endif
