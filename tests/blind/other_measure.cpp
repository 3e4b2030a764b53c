#include "blind/other_measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "blind/gauges.h"
#include "log/log_columns.h"
#include "recording/instruments.h"

namespace other_car {
namespace {

using tread::Drive;
using tread::Phase;

constexpr double kStep = 0.001;  // s
constexpr int kRowSteps = 10;    // a row every so many steps
constexpr double kGear = 5;      // that of its ratio
enum Stream : std::uint64_t { start_stream, noise_stream, disturbance_stream, vibration_stream };

// The foot and hand of a drive, phase by phase.
class Hands {
public:
    Hands(const Drive& drive, double throttle) : phases_(drive.scenario.phases), held_{.throttle = throttle} {}

    bool done() const { return phase_ == phases_.size(); }

    // At the end of the next step.
    Input next(double speed) {
        const Phase& phase = phases_[phase_];
        if (elapsed_ == 0) start_speed_ = speed, missing_way_ = 0;
        elapsed_ += kStep;
        Input now;
        now.hand_wheel = tread::valueAt(phase.steering, held_.hand_wheel, elapsed_);
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
    Input held_;  // at the start of the phase
};

// What a step shows, under the names of the gauges.
using Motion = std::map<std::string, std::vector<double>, std::less<>>;

void observe(Motion& motion, const Car& car, const Input& driver, const Input& acting) {
    static constexpr std::array kWheels{"wheel.front_left.spin", "wheel.front_right.spin", "wheel.rear_left.spin",
                                        "wheel.rear_right.spin"};
    const Vector& s = car.state();
    const Forces f = car.forces(acting);
    motion["driver.steering_wheel_angle"].push_back(driver.hand_wheel);
    motion["driver.throttle"].push_back(driver.throttle);
    motion["driver.brake"].push_back(driver.brake);
    motion["chassis.ax"].push_back(f.ax);
    motion["chassis.ay"].push_back(f.ay);
    motion["chassis.yaw_rate"].push_back(s[kYawRate]);
    motion["chassis.roll_rate"].push_back(s[kRollRate]);
    motion["chassis.roll"].push_back(car.roll());
    motion["chassis.vx"].push_back(s[kVx]);
    for (std::size_t i = 0; i < 4; ++i) motion[kWheels[i]].push_back(s[kSpin + i]);
    motion["yaw acceleration"].push_back(f.rate[kYawRate]);
    motion["roll acceleration"].push_back(f.rate[kRollRate]);
}

// Accelerations where the unit sits, with what gravity adds when it leans.
void mount(Motion& motion, const tread::recording::InertialUnit& unit) {
    std::vector<double>&ax = motion["chassis.ax"], &ay = motion["chassis.ay"];
    const std::vector<double>&yaw = motion["yaw acceleration"], &roll = motion["roll acceleration"];
    for (std::size_t i = 0; i < ax.size(); ++i) {
        const double turning = std::pow(motion["chassis.yaw_rate"][i], 2);
        ax[i] += -yaw[i] * unit.y - turning * unit.x - kGravity * unit.pitch;
        ay[i] += yaw[i] * unit.x - turning * unit.y - roll[i] * unit.z + kGravity * unit.roll;
    }
}

double at(const std::vector<double>& values, double step) {
    const double place = std::clamp(step, 0.0, static_cast<double>(values.size() - 1));
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

// The input as it was a while ago, never before the start.
class Late {
public:
    double operator()(double value, double delay) {
        past_.push_back(value);
        return at(past_, static_cast<double>(past_.size() - 1) - delay / kStep);
    }

private:
    std::vector<double> past_;
};

Motion driven(const Truth& truth, const Drive& drive, std::uint64_t seed, const tread::Conditions& conditions) {
    tread::Random start(tread::seedOf(seed, start_stream));
    Car car(truth.car, drive.scenario.start.speed * (1 + conditions.speed_scatter * start.normal()));
    tread::Pushing pushing = tread::wandering(conditions.disturbance, kStep, tread::seedOf(seed, disturbance_stream));
    Input driver{.throttle = car.holdingThrottle()}, acting = driver;
    Hands hands(drive, driver.throttle);
    Late hand_wheel, brake;
    Motion motion;
    observe(motion, car, driver, acting);
    while (!hands.done()) {
        const tread::Push push = pushing(0, {}, {});
        car.push(push.force.x(), push.force.y(), push.moment.z(), push.moment.x());
        driver = hands.next(car.state()[kVx]);
        const Input before = acting;
        acting = {hand_wheel(driver.hand_wheel, truth.steering_delay), driver.throttle,
                  brake(driver.brake, truth.brake_delay)};
        car.step(before, acting, kStep);
        observe(motion, car, driver, acting);
    }
    return motion;
}

}  // namespace

tread::Log measure(const Truth& truth, const Drive& drive, std::uint64_t seed, const tread::Conditions& conditions) {
    Motion motion = driven(truth, drive, seed, conditions);
    mount(motion, truth.instruments.inertial_unit);
    const std::size_t rows = (motion["chassis.vx"].size() - 1) / kRowSteps + 1;
    tread::Log log;
    log.channels.push_back({"time", "s", {}});
    for (std::size_t i = 0; i < rows; ++i) log.channels[0].values.push_back(static_cast<double>(i * kRowSteps) * kStep);
    log.channels.push_back({"driveline.gear", "-", std::vector<double>(rows, kGear)});
    tread::Random noise(tread::seedOf(seed, noise_stream));
    for (const tread::Gauge& gauge : tread::gauges()) {
        const tread::recording::Instrument& instrument = truth.instruments.*gauge.instrument;
        tread::Channel channel{
            std::string(gauge.channel), std::string(*tread::logUnit(std::string(gauge.channel))), {}};
        for (std::size_t i = 0; i < rows; ++i) {
            const double then = static_cast<double>(i * kRowSteps) - std::max(instrument.delay, 0.0) / kStep;
            const double reading = instrument.gain * at(motion[channel.name], then) + instrument.bias;
            channel.values.push_back(reading + (conditions.noise ? gauge.noise * noise.normal() : 0));
        }
        log.channels.push_back(std::move(channel));
    }
    if (conditions.noise) tread::vibrate(log, tread::seedOf(seed, vibration_stream));
    return log;
}

}  // namespace other_car
