#include "tread/c_api.h"

#include <algorithm>
#include <cstring>
#include <exception>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "base/text/concat.h"
#include "base/text/number_text.h"
#include "host/car.h"
#include "host/channels.h"
#include "host/failure.h"
#include "host/parameters.h"
#include "host/version.h"
#include "tread/load.h"

using tread::Vector3;
using tread::host::Car;
using tread::host::Channel;

struct tread_car {
    tread::VehicleParams params;
    double step;
    std::unique_ptr<Car> car;
    bool changed = false;  // parameters, since the car was made
    std::string error;

    // Makes the car anew where parameters have changed; ground and air stay.
    void remake() {
        if (!changed) return;
        auto other = std::make_unique<Car>(params, step);
        other->takeSurroundings(*car);
        car = std::move(other);
        changed = false;
    }
};

namespace {

using tread::concat;
using tread::host::Failure;
using tread::host::refuse;

// ---- Structs that begin with their size ----

// A copy of what the caller's struct has of ours, the rest as in `usual`.
template <class Struct>
Struct read(const Struct* given, Struct usual, const char* name) {
    if (!given) refuse(concat({"found NULL, expected a ", name}));
    if (given->size < sizeof(std::size_t) || given->size > 16 * sizeof(Struct))
        refuse(concat({"found a ", name, " whose size is not set, expected sizeof(", name, ")"}));
    const std::size_t size = std::min(given->size, sizeof(Struct));
    std::memcpy(static_cast<void*>(&usual), given, size);
    usual.size = sizeof(Struct);
    return usual;
}

template <class Struct>
void write(const Struct& result, Struct* target, const char* name) {
    read(target, Struct{}, name);
    const std::size_t size = target->size;
    std::memcpy(static_cast<void*>(target), &result, std::min(size, sizeof(Struct)));
    target->size = size;
}

void copyTo(double (&target)[3], const Vector3& v) {
    for (int i = 0; i < 3; ++i) target[i] = v[i];
}
Vector3 toVector(const double* v) {
    return {v[0], v[1], v[2]};
}

tread_plane usualPlane() {
    return {sizeof(tread_plane), {0, 0, 0}, {0, 0, 1}, {0, 0, 0}, 1, 1};
}
tread::RoadContact contactOf(const tread_plane& plane) {
    return {toVector(plane.point), toVector(plane.normal), toVector(plane.velocity), plane.friction, plane.exists != 0};
}

// ---- Calls whose faults stay inside ----

// Runs `action`; what it throws becomes a status and a text.
template <class Action>
tread_status statusOf(std::string& error, const Action& action) {
    try {
        action();
        return TREAD_OK;
    } catch (const Failure& failure) {
        error = failure.what();
        return failure.kind == Failure::Kind::broken ? TREAD_BROKEN : TREAD_FAULTY;
    } catch (const std::exception& other) {
        error = other.what();
    } catch (...) {
        error = "the host's own function threw something that is no std::exception";
    }
    return TREAD_FAULTY;
}

template <class Action>
tread_status on(tread_car* car, const Action& action) {
    if (!car) return TREAD_FAULTY;
    try {
        return statusOf(car->error, action);
    } catch (...) {
        return TREAD_FAULTY;  // no memory even for the text
    }
}

void demand(const void* pointer, const char* what) {
    if (!pointer) refuse(concat({"found NULL, expected ", what}));
}

template <class Make>
tread_car* made(const tread_options* options, char* error, std::size_t error_size, const Make& make) {
    std::unique_ptr<tread_car> car;
    std::string text;
    const tread_status status = statusOf(text, [&] {
        const tread_options usual{sizeof(tread_options), 0};
        const double step = options ? read(options, usual, "tread_options").step : 0;
        car.reset(new tread_car{make(), step == 0 ? Car::kUsualStep : step, nullptr, false, {}});
        car->car = std::make_unique<Car>(car->params, car->step);
    });
    if (status == TREAD_OK) return car.release();
    if (error && error_size > 0) {
        const std::size_t length = std::min(text.size(), error_size - 1);
        std::memcpy(error, text.data(), length);
        error[length] = '\0';
    }
    return nullptr;
}

// ---- Channels ----

const char* textOf(const std::vector<Channel>& channels, std::size_t index, std::string Channel::*text) {
    return index < channels.size() ? (channels[index].*text).c_str() : nullptr;
}

int indexIn(const std::vector<Channel>& channels, const char* name) {
    const auto index = name ? tread::host::indexOf(channels, name) : std::nullopt;
    return index ? static_cast<int>(*index) : -1;
}

template <class Struct>
void copyChannels(const std::vector<Channel>& channels, const Struct& from, double* values, std::size_t count) {
    demand(values, "an array of numbers");
    for (std::size_t i = 0; i < std::min(count, channels.size()); ++i)
        values[i] = tread::host::valueOf(from, channels[i]);
}

tread::VehicleInput inputFrom(const double* values, std::size_t count) {
    demand(values, "an array of inputs");
    const std::vector<Channel>& channels = tread::host::inputChannels();
    if (count > channels.size())
        refuse(concat(
            {"found ", std::to_string(count), " inputs, expected ", std::to_string(channels.size()), " at most"}));
    tread::VehicleInput input;
    for (std::size_t i = 0; i < count; ++i) tread::host::valueOf(input, channels[i]) = values[i];
    return input;
}

tread::ChassisMotion motionFrom(const tread_motion& m) {
    const double* q = m.orientation;
    return {toVector(m.position), {q[0], q[1], q[2], q[3]}, toVector(m.velocity), toVector(m.angular_velocity)};
}

}  // namespace

const char* tread_version(void) {
    return tread::host::version().data();
}

tread_car* tread_car_load(const char* file, const tread_options* options, char* error, size_t error_size) {
    return made(options, error, error_size, [&] {
        demand(file, "the name of a file");
        return tread::loadVehicle(file);
    });
}

tread_car* tread_car_parse(const char* text, const char* name, const tread_options* options, char* error,
                           size_t error_size) {
    return made(options, error, error_size, [&] {
        demand(text, "the text of a vehicle file");
        return tread::host::vehicleOfText(text, name ? name : "vehicle");
    });
}

void tread_car_free(tread_car* car) {
    delete car;
}

const char* tread_car_error(const tread_car* car) {
    return car ? car->error.c_str() : "found NULL, expected a car";
}

tread_status tread_car_set(tread_car* car, const char* path, const char* value) {
    return on(car, [&] {
        demand(path, "the path of a parameter");
        demand(value, "a value");
        tread::host::setParameter(car->params, path, value);
        car->changed = true;
    });
}

tread_status tread_car_parameter(tread_car* car, const char* path, double* value) {
    return on(car, [&] {
        demand(path, "the path of a parameter");
        demand(value, "room for a number");
        *value = tread::host::parameter(car->params, path);
    });
}

tread_status tread_car_use_ground(tread_car* car, tread_ground_function function, void* user) {
    return on(car, [&] {
        if (!function) return car->car->ground().use(tread::host::GroundFunction());
        car->car->ground().use([function, user](const Vector3& centre, std::size_t wheel) {
            tread_plane plane = usualPlane();
            const double at[3] = {centre.x(), centre.y(), centre.z()};
            function(user, static_cast<int>(wheel), at, &plane);
            return contactOf(plane);
        });
    });
}

tread_status tread_car_set_plane(tread_car* car, int wheel, const tread_plane* plane) {
    return on(car, [&] {
        const tread_plane read_plane = read(plane, usualPlane(), "tread_plane");
        car->car->ground().setPlane(static_cast<std::size_t>(wheel), contactOf(read_plane));
    });
}

tread_status tread_car_set_wind(tread_car* car, const double velocity[3]) {
    return on(car, [&] {
        demand(velocity, "a velocity");
        car->car->setWind(toVector(velocity));
    });
}

tread_status tread_car_start(tread_car* car, const tread_start* start) {
    return on(car, [&] {
        const tread_start at = read(start, tread_start{}, "tread_start");
        tread::Start asked{at.x, at.y, at.heading, at.speed, {}};
        if (at.inputs) asked.input = inputFrom(at.inputs, tread_input_count());
        car->remake();
        car->car->start(asked);
    });
}

size_t tread_input_count(void) {
    return tread::host::inputChannels().size();
}
const char* tread_input_name(size_t index) {
    return textOf(tread::host::inputChannels(), index, &Channel::name);
}
const char* tread_input_unit(size_t index) {
    return textOf(tread::host::inputChannels(), index, &Channel::unit);
}
const char* tread_input_meaning(size_t index) {
    return textOf(tread::host::inputChannels(), index, &Channel::meaning);
}
int tread_input_index(const char* name) {
    return indexIn(tread::host::inputChannels(), name);
}

size_t tread_output_count(void) {
    return tread::host::outputChannels().size();
}
const char* tread_output_name(size_t index) {
    return textOf(tread::host::outputChannels(), index, &Channel::name);
}
const char* tread_output_unit(size_t index) {
    return textOf(tread::host::outputChannels(), index, &Channel::unit);
}
const char* tread_output_meaning(size_t index) {
    return textOf(tread::host::outputChannels(), index, &Channel::meaning);
}
int tread_output_index(const char* name) {
    return indexIn(tread::host::outputChannels(), name);
}

tread_status tread_car_set_inputs(tread_car* car, const double* values, size_t count, tread_course course) {
    return on(car, [&] {
        const bool ramps = course == TREAD_RAMP;
        car->car->setInput(inputFrom(values, count), ramps ? tread::host::Course::ramp : tread::host::Course::held);
    });
}

tread_status tread_car_inputs(tread_car* car, double* values, size_t count) {
    return on(car, [&] { copyChannels(tread::host::inputChannels(), car->car->input(), values, count); });
}

tread_status tread_car_outputs(tread_car* car, double* values, size_t count) {
    return on(car, [&] { copyChannels(tread::host::outputChannels(), car->car->output(), values, count); });
}

tread_status tread_car_output(tread_car* car, const char* name, double* value) {
    return on(car, [&] {
        demand(name, "the name of an output");
        demand(value, "room for a number");
        const std::vector<Channel>& channels = tread::host::outputChannels();
        const auto index = tread::host::indexOf(channels, name);
        if (!index) refuse(tread::host::unknownChannelText(channels, name));
        *value = tread::host::valueOf(car->car->output(), channels[*index]);
    });
}

double tread_car_time(const tread_car* car) {
    return car ? car->car->time() : 0;
}

tread_status tread_car_advance(tread_car* car, double duration) {
    return on(car, [&] { car->car->advance(duration); });
}

tread_status tread_car_body(tread_car* car, tread_body* body) {
    return on(car, [&] {
        const tread::host::BodyProperties properties = car->car->body();
        tread_body result{sizeof result, properties.mass, {}, {}};
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) result.inertia[row][column] = properties.inertia_B(row, column);
        }
        copyTo(result.reference, properties.reference_B);
        write(result, body, "tread_body");
    });
}

tread_status tread_car_motion(tread_car* car, tread_motion* motion) {
    return on(car, [&] {
        const tread::ChassisMotion& m = car->car->motion();
        const tread::Quaternion& q = m.orientation;
        tread_motion result{sizeof result, {}, {q.w(), q.x(), q.y(), q.z()}, {}, {}};
        copyTo(result.position, m.position_W);
        copyTo(result.velocity, m.velocity_W);
        copyTo(result.angular_velocity, m.angular_velocity_W);
        write(result, motion, "tread_motion");
    });
}

tread_status tread_car_push(tread_car* car, const tread_motion* body, double duration, tread_integration integration,
                            tread_force* force) {
    return on(car, [&] {
        const tread_motion still{sizeof still, {0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
        const tread_motion shown = read(body, still, "tread_motion");
        read(force, tread_force{}, "tread_force");
        const bool semi_implicit = integration == TREAD_SEMI_IMPLICIT;
        const tread::host::BodyForce push =
            car->car->push(motionFrom(shown), duration,
                           semi_implicit ? tread::host::Integration::semi_implicit : tread::host::Integration::exact);
        tread_force result{sizeof result, {}, {}, {}, {}};
        copyTo(result.force, push.force_W);
        copyTo(result.moment, push.moment_W);
        copyTo(result.acceleration, push.acceleration_W);
        copyTo(result.angular_acceleration, push.angular_acceleration_W);
        write(result, force, "tread_force");
    });
}

size_t tread_car_state_size(const tread_car*) {
    return tread::host::snapshotSize();
}

tread_status tread_car_get_state(tread_car* car, void* bytes, size_t size) {
    return on(car, [&] {
        demand(bytes, "room for the state");
        const std::vector<std::byte> state = car->car->bytes();
        if (size < state.size())
            refuse(
                concat({"found room for ", std::to_string(size), " bytes, expected ", std::to_string(state.size())}));
        std::memcpy(bytes, state.data(), state.size());
    });
}

tread_status tread_car_set_state(tread_car* car, const void* bytes, size_t size) {
    return on(car, [&] {
        demand(bytes, "a state");
        car->remake();
        car->car->restore(std::span(static_cast<const std::byte*>(bytes), size));
    });
}
