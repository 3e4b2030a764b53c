#include "fmu/object/instance.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/math/elementary.h"
#include "base/text/concat.h"
#include "base/text/number_text.h"
#include "base/text/text_file.h"
#include "host/failure.h"
#include "host/parameters.h"

namespace tread::fmu {
namespace {

using host::refuse;

bool isGiven(const Variable& variable) {
    return variable.role == Role::input || variable.role == Role::parameter;
}
bool isFound(const Variable& variable) {
    return variable.role == Role::output || variable.role == Role::calculated || variable.role == Role::independent;
}

RoadContact planeAt(double x, double y, const WheelGround& ground) {
    const double flat = 1 - ground.nx * ground.nx - ground.ny * ground.ny;
    if (!(flat > 0))
        refuse(concat({"found a normal of the ground with nx = ", numberText(ground.nx),
                       " and ny = ", numberText(ground.ny), ", expected one of length 1 with nz > 0"}));
    RoadContact plane;
    plane.point_W = {x, y, ground.height};
    plane.normal_W = {ground.nx, ground.ny, std::sqrt(flat)};
    plane.friction = ground.friction;
    return plane;
}

}  // namespace

Instance::Instance(const std::filesystem::path& resources, std::string_view token, std::string_view fmi_version) {
    const std::filesystem::path file = resources / kCarFile;
    std::string fault;
    const std::optional<std::string> text = readTextFile(file, fault);
    if (!text) refuse(concat({file.string(), ": ", fault}));
    token_ = tokenOf(*text, fmi_version);
    if (token != token_)
        refuse(concat({"found the GUID ", quote(token), ", expected ", token_,
                       ": model description and shared object are not of the same FMU"}));
    values_.parameters.car = host::vehicleOfText(*text, file.string());
    variables_ = variablesOf(values_);
    defaults_ = givenValues();
}

const Variable& Instance::variable(std::size_t reference, bool flag) const {
    if (reference >= variables_.size())
        refuse(concat({"found the value reference ", std::to_string(reference), ", expected at most ",
                       std::to_string(variables_.size() - 1)}));
    const Variable& found = variables_[reference];
    if ((found.flag != nullptr) != flag)
        refuse(concat({found.name, " is a ", found.flag ? "boolean" : "real number", ", not a ",
                       flag ? "boolean" : "real number"}));
    return found;
}

double Instance::get(std::size_t reference, bool flag) {
    const Variable& asked = variable(reference, flag);
    if (isFound(asked)) {
        if (phase_ == Phase::instantiated && asked.role != Role::independent)
            refuse(concat({asked.name, " is not known before the initialisation mode"}));
        observe();
    }
    return asked.get();
}

void Instance::set(std::size_t reference, double value, bool flag) {
    const Variable& target = variable(reference, flag);
    if (!isGiven(target)) refuse(concat({target.name, " is computed and cannot be set"}));
    const bool parameter = target.role == Role::parameter;
    if (parameter && phase_ != Phase::instantiated && phase_ != Phase::initialising)
        refuse(concat({target.name, " is a parameter: it can be set until the initialisation mode ends"}));
    const bool sound = std::isfinite(value) && (!parameter || target.limits.allow(value));
    if (!sound) {
        const std::string limits = limitsText(target.limits);
        refuse(concat(
            {target.name, ": found ", numberText(value), ", expected ", limits.empty() ? "a finite number" : limits}));
    }
    target.set(value);
    if (phase_ != Phase::stepping) started_ = false;
}

void Instance::setStartTime(double time) {
    if (!std::isfinite(time)) refuse("found a start time that is not finite");
    start_time_ = time;
}

void Instance::enterInitialisation() {
    if (phase_ != Phase::instantiated) refuse("the initialisation mode can be entered once, after the instantiation");
    phase_ = Phase::initialising;
}

void Instance::exitInitialisation() {
    if (phase_ != Phase::initialising) refuse("the initialisation mode has not been entered");
    if (!started_) start();
    phase_ = Phase::stepping;
}

void Instance::terminate() {
    phase_ = Phase::terminated;
}

void Instance::reset() {
    restore({Phase::instantiated, 0, defaults_, {}, {}});
}

// The car of the parameters.
void Instance::make() {
    std::vector<double> given = givenValues();
    if (car_ && given == made_of_) return;
    host::checkParameters(values_.parameters.car);
    car_ = std::make_unique<host::Car>(values_.parameters.car, values_.parameters.settings.step);
    made_of_ = std::move(given);
}

void Instance::start() {
    make();
    const StartSettings& start = values_.parameters.start;
    const double c = cosine(start.heading), s = sine(start.heading);
    for (std::size_t i = 0; i < kWheels; ++i) {
        const Vector3& hub = car_->vehicle().corners[i].hub_B;
        values_.wheel_centre[i] = {start.x + c * hub.x() - s * hub.y(), start.y + s * hub.x() + c * hub.y(), 0};
    }
    setSurroundings();
    car_->start(
        {start.x, start.y, start.heading, start.speed, {.brake = start.brake, .parking_brake = start.parking_brake}});
    values_.found = {car_->input().throttle, car_->input().steering_wheel_angle};
    started_ = true;
    observed_ = false;
}

// Ground and air of the inputs, for wheels where they are. The flat road is the same everywhere: one plane, so that its
// numbers do not depend on where communication steps begin.
void Instance::setSurroundings() {
    const Inputs& inputs = values_.inputs;
    const Settings& settings = values_.parameters.settings;
    for (std::size_t i = 0; i < kWheels; ++i) {
        const WheelCentre& at = values_.wheel_centre[i];
        const RoadContact flat{.friction = settings.friction};
        car_->ground().setPlane(i, settings.external_ground ? planeAt(at.x, at.y, inputs.ground[i]) : flat);
    }
    car_->setWind({inputs.wind.x, inputs.wind.y, inputs.wind.z});
}

void Instance::step(double time, double duration) {
    if (phase_ != Phase::stepping) refuse("a step needs the initialisation mode before it");
    constexpr double kRounding = 1e-6;  // of the step: masters add up their times
    if (!(duration >= 0)) refuse(concat({"found a step of ", numberText(duration), " s, expected at least 0"}));
    if (!(std::abs(time - this->time()) <= kRounding * std::max(duration, values_.parameters.settings.step)))
        refuse(concat({"found a step that begins at ", numberText(time), " s, expected ", numberText(this->time()),
                       " s, where the last one ended"}));
    if (duration == 0) return;
    observe();
    setSurroundings();
    car_->setInput(values_.inputs.driver,
                   values_.parameters.settings.ramp_inputs ? host::Course::ramp : host::Course::held);
    observed_ = false;
    car_->advance(duration);
}

Vector3 Instance::wheelCentre(std::size_t wheel) const {
    const ChassisMotion& motion = car_->motion();
    const Vector3 at_B = car_->vehicle().corners[wheel].hub_B + Vector3(0, 0, car_->state().wheels[wheel].travel);
    return motion.position_W + motion.orientation * at_B;
}

void Instance::observe() {
    if (phase_ == Phase::initialising && !started_) start();
    values_.time = time();
    if (observed_ || !car_) return;
    values_.outputs = car_->output();
    for (std::size_t i = 0; i < kWheels; ++i) {
        const Vector3 at = wheelCentre(i);
        values_.wheel_centre[i] = {at.x(), at.y(), at.z()};
    }
    observed_ = true;
}

// ---- State ----

std::vector<double> Instance::givenValues() const {
    std::vector<double> given;
    for (const Variable& one : variables_) {
        if (isGiven(one)) given.push_back(one.get());
    }
    return given;
}

Instance::Saved Instance::save() const {
    Saved saved{phase_, start_time_, givenValues(), values_.found, {}};
    if (car_ && started_) saved.car = car_->snapshot();
    return saved;
}

void Instance::restore(const Saved& saved) {
    phase_ = saved.phase;
    start_time_ = saved.start_time;
    values_.found = saved.found;
    std::size_t next = 0;
    for (const Variable& one : variables_) {
        if (isGiven(one)) one.set(saved.values[next++]);
    }
    started_ = saved.car.has_value();
    observed_ = false;
    if (!saved.car) {
        car_.reset();
        return;
    }
    make();
    car_->restore(*saved.car);
}

namespace {

struct Head {
    std::uint64_t token, content;
    double phase, start_time, throttle, steering_wheel_angle, has_car;
};

std::uint64_t hashOf(std::string_view text) {
    return host::hashOf(std::as_bytes(std::span(text)));
}

}  // namespace

std::size_t Instance::serialisedSize() const {
    return sizeof(Head) + defaults_.size() * sizeof(double) + host::snapshotSize();
}

std::vector<std::byte> Instance::serialise(const Saved& saved) const {
    std::vector<std::byte> bytes(serialisedSize());
    const std::span<std::byte> content = std::span(bytes).subspan(sizeof(Head));
    const std::size_t values = saved.values.size() * sizeof(double);
    std::memcpy(content.data(), saved.values.data(), values);
    if (saved.car) {
        const std::vector<std::byte> car = host::bytesOf(*saved.car, hashOf(token_));
        std::memcpy(content.data() + values, car.data(), car.size());
    }
    const Head head{hashOf(token_),       host::hashOf(content), static_cast<double>(saved.phase),
                    saved.start_time,     saved.found.throttle,  saved.found.steering_wheel_angle,
                    saved.car ? 1.0 : 0.0};
    std::memcpy(bytes.data(), &head, sizeof head);
    return bytes;
}

Instance::Saved Instance::deserialise(std::span<const std::byte> bytes) const {
    Head head;
    if (bytes.size() != serialisedSize())
        refuse(concat({"found a state of ", std::to_string(bytes.size()), " bytes, expected ",
                       std::to_string(serialisedSize())}));
    std::memcpy(&head, bytes.data(), sizeof head);
    if (head.token != hashOf(token_)) refuse("found a state of another FMU, expected one of this FMU");
    const std::span<const std::byte> content = bytes.subspan(sizeof head);
    const bool sound = head.content == host::hashOf(content) && head.phase >= 0 && head.phase <= 3;
    if (!sound) refuse("found a state that is damaged: its checksum is another");
    Saved saved{static_cast<Phase>(static_cast<int>(head.phase)),
                head.start_time,
                std::vector<double>(defaults_.size()),
                {head.throttle, head.steering_wheel_angle},
                {}};
    const std::size_t values = saved.values.size() * sizeof(double);
    std::memcpy(saved.values.data(), content.data(), values);
    if (head.has_car != 0) saved.car = host::snapshotOf(content.subspan(values), hashOf(token_));
    return saved;
}

}  // namespace tread::fmu
