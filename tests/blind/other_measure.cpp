#include "blind/other_measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "blind/drives/measure.h"
#include "blind/world/draws.h"
#include "blind/world/instruments.h"
#include "log/log_columns.h"
#include "recording/diagnosis_file.h"
#include "recording/instruments.h"
#include "run/simulate.h"

namespace other_car {
namespace {

using tread::Phase;
using tread::blind::drives::Drive;
using tread::blind::drives::kSpeedScatter;
using tread::blind::world::addNoise;
using tread::blind::world::drawnNoise;
using tread::blind::world::drawnSurroundings;
using tread::blind::world::enginePhase;
using tread::blind::world::InstrumentSheet;
using tread::blind::world::instrumentSheets;
using tread::blind::world::pushingOf;
using tread::blind::world::PushSource;
using tread::blind::world::seedOf;
using tread::recording::Instrument;

constexpr double kGear = 5;  // the gear of Params::drive_ratio
enum DriveStream : std::uint64_t { start_stream, noise_stream, surroundings_stream, misreading_stream };

// Driver inputs of a drive, phase by phase.
class Hands {
public:
    Hands(const Drive& drive, double throttle) : phases_(drive.scenario.phases), held_{.throttle = throttle} {}

    bool done() const { return phase_ == phases_.size(); }

    // Inputs at the end of the next step.
    Input next(double speed) {
        const Phase& phase = phases_[phase_];
        if (elapsed_ == 0) start_speed_ = speed, missing_way_ = 0;
        elapsed_ += kStep;
        Input now;
        now.steering_wheel = tread::valueAt(phase.steering, held_.steering_wheel, elapsed_);
        now.brake = tread::valueAt(phase.brake, held_.brake, elapsed_);
        if (const auto* hold = std::get_if<tread::HoldSpeed>(&phase.throttle)) {
            missing_way_ += kStep * (start_speed_ - speed);
            now.throttle = std::clamp(
                held_.throttle + hold->proportional * (start_speed_ - speed) + hold->integral * missing_way_, 0.0, 1.0);
        } else {
            now.throttle = tread::valueAt(phase.throttle, held_.throttle, elapsed_);
        }
        if (elapsed_ >= *phase.until.duration - kStep / 2) ++phase_, elapsed_ = 0, held_ = now;
        return now;
    }

private:
    const std::vector<Phase>& phases_;
    std::size_t phase_ = 0;
    double elapsed_ = 0, start_speed_ = 0, missing_way_ = 0;
    Input held_;  // inputs at the start of the phase
};

// Quantities that are recorded in each step.
enum Seen {
    kHand,
    kThrottle,
    kPedal,
    kAx,
    kAy,
    kTurning,
    kRollSpeed,
    kLean,
    kSpeed,
    kWheels,
    kYawing = kWheels + 4,
    kRolling,
    kNodding,
    kEngine,
    kSeen
};
constexpr std::array<std::string_view, kYawing> kChannels{"driver.steering_wheel_angle",
                                                          "driver.throttle",
                                                          "driver.brake",
                                                          "chassis.ax",
                                                          "chassis.ay",
                                                          "chassis.yaw_rate",
                                                          "chassis.roll_rate",
                                                          "chassis.roll",
                                                          "chassis.vx",
                                                          "wheel.front_left.spin",
                                                          "wheel.front_right.spin",
                                                          "wheel.rear_left.spin",
                                                          "wheel.rear_right.spin"};
using Series = std::vector<double>;
using Motion = std::array<Series, kSeen>;

void observe(Motion& motion, const Car& car, const Input& driver) {
    const Vector& s = car.state();
    const Forces& f = car.lastForces();
    motion[kHand].push_back(driver.steering_wheel);
    motion[kThrottle].push_back(driver.throttle);
    motion[kPedal].push_back(driver.brake);
    motion[kAx].push_back(f.ax);
    motion[kAy].push_back(f.ay);
    motion[kTurning].push_back(s[kYawRate]);
    motion[kRollSpeed].push_back(s[kRollRate]);
    motion[kLean].push_back(car.roll());
    motion[kSpeed].push_back(s[kVx]);
    for (std::size_t i = 0; i < 4; ++i) motion[kWheels + i].push_back(s[kSpin + i]);
    motion[kYawing].push_back(f.rate[kYawRate]);
    motion[kRolling].push_back(f.rate[kRollRate]);
    motion[kNodding].push_back(car.pitch());
    motion[kEngine].push_back(car.engineSpeed());
}

// Accelerations at the position of the inertial unit, with gravity by its misalignment and, where it is fixed to the
// body, by the roll and pitch of the body.
void mount(Motion& motion, const tread::recording::InertialUnit& unit) {
    for (std::size_t i = 0; i < motion[kAx].size(); ++i) {
        const double turning = motion[kTurning][i] * motion[kTurning][i], yaw = motion[kYawing][i];
        motion[kAx][i] +=
            -yaw * unit.y - turning * unit.x - kGravity * (unit.pitch + unit.fixed_to_body * motion[kNodding][i]);
        motion[kAy][i] += yaw * unit.x - turning * unit.y - motion[kRolling][i] * unit.z +
                          kGravity * (unit.roll + unit.fixed_to_body * motion[kLean][i]);
    }
}

double at(const Series& values, double step) {
    const double place = std::clamp(step, 0.0, static_cast<double>(values.size() - 1));
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

double latency(const Instrument& instrument) {  // in steps, never negative
    return std::max(instrument.delay, 0.0) / kStep;
}

// Reading of an instrument with a first-order low pass.
Series read(const Series& values, const Instrument& instrument, double low_pass) {
    Series shown = values;
    const double taken = low_pass > 0 ? -std::expm1(-2 * std::numbers::pi * low_pass * kStep) : 1;
    for (std::size_t i = 1; i < shown.size(); ++i) shown[i] = shown[i - 1] + taken * (values[i] - shown[i - 1]);
    const Series filtered = shown;
    for (std::size_t i = 0; i < shown.size(); ++i)
        shown[i] = instrument.gain * at(filtered, static_cast<double>(i) - latency(instrument)) + instrument.bias;
    return shown;
}

// True input of the driver from its reading.
Series unread(const Series& shown, const Instrument& instrument) {
    Series values;
    for (std::size_t i = 0; i < shown.size(); ++i)
        values.push_back((at(shown, static_cast<double>(i) + latency(instrument)) - instrument.bias) / instrument.gain);
    return values;
}

std::vector<Input> driverOf(const Recorded& recorded, const tread::recording::Instruments& instruments) {
    Series hand, throttle, brake;
    for (const Input& one : recorded)
        hand.push_back(one.steering_wheel), throttle.push_back(one.throttle), brake.push_back(one.brake);
    hand = unread(hand, instruments.steering_wheel_angle);
    throttle = unread(throttle, instruments.throttle);
    brake = unread(brake, instruments.brake);
    std::vector<Input> driver;
    for (std::size_t i = 0; i < hand.size(); ++i) driver.push_back({hand[i], throttle[i], brake[i]});
    return driver;
}

// Delays an input; before the start it is constant.
class Late {
public:
    double operator()(double value, double delay) {
        past_.push_back(value);
        return at(past_, static_cast<double>(past_.size() - 1) - delay / kStep);
    }

private:
    Series past_;
};

// Output of the car as tread has it: forces of outsiders depend on it.
tread::VehicleOutput seen(const Car& car, const Params& params, const Input& acting) {
    const Vector& s = car.state();
    const Forces& f = car.lastForces();
    tread::VehicleOutput out;
    tread::ChassisOutput& c = out.chassis;
    c.x = s[kX], c.y = s[kY], c.yaw = s[State::kYaw];
    c.roll = s[kRoll], c.pitch = s[kPitch];
    c.vx = s[kVx], c.vy = s[kVy], c.sideslip = std::atan2(s[kVy], s[kVx]);
    c.roll_rate = s[kRollRate], c.pitch_rate = s[kPitchRate], c.yaw_rate = s[kYawRate];
    c.ax = f.ax, c.ay = f.ay;
    for (std::size_t i = 0; i < 4; ++i) {
        const bool front = i < 2;
        const Axle& axle = front ? params.front : params.rear;
        const double along = front ? params.front_distance : params.front_distance - params.wheelbase;
        out.wheel[i].load = f.load[i], out.wheel[i].fx = f.fx[i], out.wheel[i].fy = f.fy[i];
        out.wheel[i].spin = s[kSpin + i];
        out.wheel[i].travel = axle.travelByRoll() * (i % 2 == 0 ? -s[kRoll] : s[kRoll]) + along * s[kPitch];
    }
    out.steering.angle = acting.steering_wheel;
    out.driveline = {.engine_speed = car.engineSpeed(), .engine_torque = car.engineTorque(acting), .gear = kGear};
    return out;
}

// Initial speed, external forces, and recorded inputs, if these replace those of the drive.
struct Driving {
    double start_speed;
    tread::Pushing push;
    const std::vector<Input>* inputs = nullptr;
};

// The model is valid while the car rolls forward.
bool drivable(const Vector& s) {
    constexpr double kSlowest = 1;  // m/s
    return s[kVx] > kSlowest && std::abs(s[kVy]) < s[kVx];
}

Motion driven(const Truth& truth, const Drive& drive, Driving driving) {
    Car car(truth.car, driving.start_speed);
    Input driver{.throttle = car.holdingThrottle()};
    Hands hands(drive, driver.throttle);
    if (driving.inputs) driver = driving.inputs->front();
    Input acting = driver;
    Late steering_wheel, brake;
    Motion motion;
    observe(motion, car, driver);
    for (std::size_t i = 1; driving.inputs ? i < driving.inputs->size() : !hands.done(); ++i) {
        if (driving.push) {
            const tread::Push push = driving.push(
                static_cast<double>(i - 1) * kStep,
                {.steering_wheel_angle = driver.steering_wheel, .throttle = driver.throttle, .brake = driver.brake},
                seen(car, truth.car, acting));
            car.push({push.force.x(), push.force.y(), push.moment.x(), push.moment.y(), push.moment.z()});
        }
        driver = driving.inputs ? (*driving.inputs)[i] : hands.next(car.state()[kVx]);
        const Input before = acting;
        acting = {steering_wheel(driver.steering_wheel, truth.steering_delay), driver.throttle,
                  brake(driver.brake, truth.brake_delay)};
        car.step(before, acting, kStep);
        observe(motion, car, driver);
        if (!drivable(car.state()))
            throw tread::SimulationError("the other car spins or stops", static_cast<double>(i) * kStep);
    }
    return motion;
}

// Sum of all pushes.
tread::Pushing together(std::vector<tread::Pushing> pushes) {
    std::erase_if(pushes, [](const tread::Pushing& one) { return !one; });
    if (pushes.empty()) return {};
    return [pushes](double time, const tread::VehicleInput& driver, const tread::VehicleOutput& car) {
        tread::Push sum;
        for (const tread::Pushing& one : pushes) {
            const tread::Push more = one(time, driver, car);
            sum.force += more.force;
            sum.moment += more.moment;
        }
        return sum;
    };
}

const Series& seriesOf(const Motion& motion, std::string_view channel) {
    const auto found = std::find(kChannels.begin(), kChannels.end(), channel);
    return motion[static_cast<std::size_t>(found - kChannels.begin())];
}

// Readings without noise.
Replayed readings(const Truth& truth, Motion motion) {
    mount(motion, truth.instruments.inertial_unit);
    const std::size_t steps = motion[kSpeed].size(), rows = (steps - 1) / kRowSteps + 1;
    const auto rowsOf = [&](const Series& values) {
        Series some;
        for (std::size_t i = 0; i < rows; ++i) some.push_back(values[i * kRowSteps]);
        return some;
    };
    Replayed all{{}, Recorded(steps), rowsOf(motion[kEngine])};
    all.log.channels.push_back({"time", "s", {}});
    for (std::size_t i = 0; i < rows; ++i)
        all.log.channels[0].values.push_back(static_cast<double>(i * kRowSteps) * kStep);
    all.log.channels.push_back({"driveline.gear", "-", Series(rows, kGear)});
    for (const InstrumentSheet& sheet : instrumentSheets()) {
        const std::string name(sheet.channel);
        const auto slow = truth.low_pass.find(name);
        const Series shown = read(seriesOf(motion, name), truth.instruments.*sheet.instrument,
                                  slow == truth.low_pass.end() ? 0 : slow->second);
        all.log.channels.push_back({name, std::string(*tread::logUnit(name)), rowsOf(shown)});
        double Input::*input = name == kChannels[kHand]       ? &Input::steering_wheel
                               : name == kChannels[kThrottle] ? &Input::throttle
                               : name == kChannels[kPedal]    ? &Input::brake
                                                              : nullptr;
        for (std::size_t i = 0; input && i < steps; ++i) all.recorded[i].*input = shown[i];
    }
    return all;
}

}  // namespace

ProvingGround drawnGround(const tread::VehicleParams& nominal, tread::Random& random) {
    std::vector<PushSource> surroundings = drawnSurroundings(nominal, random);
    return {std::move(surroundings), drawnNoise(random)};
}

Replayed replay(const Truth& truth, const Drive& drive, const Replay& how) {
    const std::vector<Input> inputs = how.recorded ? driverOf(*how.recorded, truth.instruments) : std::vector<Input>{};
    const Driving driving{.start_speed = drive.scenario.start.speed * (1 + how.faster),
                          .push = together({how.push, truth.push ? truth.push() : tread::Pushing{}}),
                          .inputs = how.recorded ? &inputs : nullptr};
    Replayed all = readings(truth, driven(truth, drive, driving));
    tread::Random misreading(how.misreading);
    if (truth.misread) truth.misread(all.log, misreading);
    return all;
}

tread::Log measure(const Truth& truth, const ProvingGround& ground, const Drive& drive, std::uint64_t seed) {
    tread::Random start(seedOf(seed, start_stream));
    Replay how;
    how.push = pushingOf(ground.surroundings, seedOf(seed, surroundings_stream));
    how.faster = kSpeedScatter * start.normal();
    how.misreading = seedOf(seed, misreading_stream);
    Replayed all = replay(truth, drive, how);
    const std::vector<double> phase = enginePhase(all.log.channels.front().values, all.engine_speed);
    addNoise(all.log, ground.noise, phase, seedOf(seed, noise_stream));
    return all.log;
}

}  // namespace other_car
