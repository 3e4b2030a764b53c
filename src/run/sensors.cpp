#include "run/sensors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>

#include "base/math/elementary.h"
#include "base/math/turn.h"
#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "vehicle/vectors.h"

namespace tread {
namespace {

// Channels that depend on where a sensor sits and how it is turned.
enum class Quantity { position, velocity, acceleration, rate };
struct Directed {
    std::string_view channel;
    Quantity quantity;
    int axis;
};
constexpr std::array<Directed, 12> kDirected{{{"chassis.x", Quantity::position, 0},
                                              {"chassis.y", Quantity::position, 1},
                                              {"chassis.z", Quantity::position, 2},
                                              {"chassis.vx", Quantity::velocity, 0},
                                              {"chassis.vy", Quantity::velocity, 1},
                                              {"chassis.vz", Quantity::velocity, 2},
                                              {"chassis.ax", Quantity::acceleration, 0},
                                              {"chassis.ay", Quantity::acceleration, 1},
                                              {"chassis.az", Quantity::acceleration, 2},
                                              {"chassis.roll_rate", Quantity::rate, 0},
                                              {"chassis.pitch_rate", Quantity::rate, 1},
                                              {"chassis.yaw_rate", Quantity::rate, 2}}};

const Directed* directed(std::string_view channel) {
    const auto found =
        std::find_if(kDirected.begin(), kDirected.end(), [&](const Directed& one) { return one.channel == channel; });
    return found == kDirected.end() ? nullptr : &*found;
}

Vector3 placeOf(const SensorParams& params) {
    return {params.position.x, params.position.y, params.position.z};
}

bool isTurned(const SensorParams& params) {
    const SensorMisalignment& angles = params.misalignment;
    return params.fixed_to_body || angles.roll != 0 || angles.pitch != 0 || angles.yaw != 0;
}

// Sensors of one seed and different names have different noise (FNV-1a).
std::uint64_t seedOf(const SensorParams& params) {
    std::uint64_t hash = 14695981039346656037u;
    for (const char c : params.loggedName()) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
    return hash ^ static_cast<std::uint64_t>(params.seed);
}

// Columns: x horizontal along the heading, y to the left, z up.
Eigen::Matrix3d levelAxes(const Eigen::Matrix3d& body) {
    Eigen::Matrix3d axes;
    axes.col(2) = Vector3::UnitZ();
    axes.col(0) = Vector3(body(0, 0), body(1, 0), 0).normalized();
    axes.col(1) = axes.col(2).cross(axes.col(0));
    return axes;
}

}  // namespace

std::vector<SensorFault> sensorFaults(const std::vector<SensorParams>& sensors,
                                      std::span<const std::string_view> channels) {
    std::vector<SensorFault> faults;
    std::set<std::string> names;
    for (std::size_t i = 0; i < sensors.size(); ++i) {
        const SensorParams& sensor = sensors[i];
        const std::string& name = sensor.loggedName();
        if (std::find(channels.begin(), channels.end(), sensor.channel) == channels.end()) {
            const std::string suggestion = didYouMean(sensor.channel, channels);
            faults.push_back({i, "channel",
                              "found " + quote(sensor.channel) + ", which is not a channel, expected the name of one" +
                                  (suggestion.empty() ? ";" : suggestion) + " `tread describe log` lists all"});
            continue;
        }
        if (!names.insert(name).second) {
            faults.push_back({i, "name", "found a second sensor " + quote(name) + ", expected a name for each"});
        }
        const Directed* direction = directed(sensor.channel);
        const auto refuse = [&](const char* path, bool given, bool allowed) {
            if (!given || allowed) return;
            faults.push_back({i, path,
                              "found a sensor of " + quote(sensor.channel) + " with a " + path +
                                  ", which that channel does not depend on; remove it"});
        };
        refuse("position", !placeOf(sensor).isZero(0), direction && direction->quantity != Quantity::rate);
        const bool turns = direction && direction->quantity != Quantity::position;
        refuse("fixed_to_body", sensor.fixed_to_body, turns);
        refuse("misalignment", isTurned(sensor) && !sensor.fixed_to_body, turns);
    }
    return faults;
}

Sensor::Sensor(const SensorParams& params, double step)
    : params_(params),
      elsewhere_(directed(params.channel) && (isTurned(params) || !placeOf(params).isZero(0))),
      turned_((turnAbout(Vector3::UnitZ(), params.misalignment.yaw) *
               turnAbout(Vector3::UnitY(), params.misalignment.pitch) *
               turnAbout(Vector3::UnitX(), params.misalignment.roll))
                  .toRotationMatrix()),
      random_(seedOf(params)),
      filters_(params.low_pass * step < 0.5),  // what is faster than half the step's frequency is not in the run
      delay_steps_(params.delay / step) {
    if (filters_) {
        // Second-order Butterworth, bilinear transform with its corner in place.
        const double k = tangent(std::numbers::pi * params.low_pass * step);
        const double norm = 1 / (1 + std::numbers::sqrt2 * k + k * k);
        b_ = k * k * norm;
        a1_ = 2 * (k * k - 1) * norm;
        a2_ = (1 - std::numbers::sqrt2 * k + k * k) * norm;
    }
    past_.resize(static_cast<std::size_t>(std::floor(delay_steps_)) + 2);
}

void Sensor::observe(double value, const PointMotion& body) {
    if (elsewhere_) value = mounted(value, body);
    if (!begun_) {
        // As if it had always been so.
        x1_ = x2_ = y1_ = y2_ = value;
        std::fill(past_.begin(), past_.end(), value);
        begun_ = true;
    }
    if (filters_) value = filtered(value);
    value_ = params_.delay > 0 ? delayed(value) : value;
}

double Sensor::mounted(double value, const PointMotion& body) const {
    const Directed& what = *directed(params_.channel);
    const Eigen::Matrix3d body_axes = body.motion.orientation.toRotationMatrix();
    const Vector3 arm = times(body_axes, placeOf(params_));
    const Vector3& spin = body.motion.angular_velocity_W;
    const Eigen::Matrix3d mounting = params_.fixed_to_body ? body_axes : levelAxes(body_axes);
    const Vector3 axis = times<Vector3>(mounting, turned_.col(what.axis));
    switch (what.quantity) {
        case Quantity::position:
            return value + arm(what.axis);
        case Quantity::velocity:
            return axis.dot(body.motion.velocity_W + spin.cross(arm));
        case Quantity::acceleration: {
            const Vector3 there =
                body.acceleration_W + body.angular_acceleration_W.cross(arm) + spin.cross(spin.cross(arm));
            return axis.dot(there) + kStandardGravity * (axis.z() - (what.axis == 2 ? 1 : 0));
        }
        case Quantity::rate:
            return axis.dot(spin);
    }
    return value;
}

double Sensor::filtered(double x) {
    const double y = b_ * (x + 2 * x1_ + x2_) - a1_ * y1_ - a2_ * y2_;
    x2_ = x1_, x1_ = x;
    y2_ = y1_, y1_ = y;
    return y;
}

double Sensor::delayed(double value) {
    newest_ = (newest_ + 1) % past_.size();
    past_[newest_] = value;
    const double whole = std::floor(delay_steps_), part = delay_steps_ - whole;
    const std::size_t later = (newest_ + past_.size() - static_cast<std::size_t>(whole)) % past_.size();
    const std::size_t earlier = (later + past_.size() - 1) % past_.size();
    return past_[later] + part * (past_[earlier] - past_[later]);
}

double Sensor::reading() {
    double shown = params_.gain * value_;
    if (params_.bias != 0) shown += params_.bias;
    if (params_.noise > 0) shown += params_.noise * random_.normal();
    if (params_.resolution > 0) shown = params_.resolution * std::round(shown / params_.resolution);
    return shown;
}

}  // namespace tread
