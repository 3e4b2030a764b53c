#include "recording/observation.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

#include "log/log_columns.h"
#include "recording/position.h"
#include "tread/vehicle_output.h"

namespace tread::recording {
namespace {

// Linear interpolation in evenly spaced rows; constant beyond both ends.
double at(std::span<const double> values, double rows_per_second, double t) {
    const double row = std::clamp(t * rows_per_second, 0.0, static_cast<double>(values.size() - 1));
    const auto below = static_cast<std::size_t>(row);
    const auto above = std::min(below + 1, values.size() - 1);
    return values[below] + (row - static_cast<double>(below)) * (values[above] - values[below]);
}

std::vector<double> derivative(std::span<const double> values, double rows_per_second) {
    std::vector<double> rates(values.size(), 0);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::size_t before = i > 0 ? i - 1 : 0, after = std::min(i + 1, values.size() - 1);
        if (after > before)
            rates[i] = (values[after] - values[before]) * rows_per_second / static_cast<double>(after - before);
    }
    return rates;
}

const std::vector<double>& column(const Log& motion, const std::string& name) {
    if (const Channel* channel = motion.find(name)) return channel->values;
    throw std::logic_error("the model's motion has no " + name);
}

// Acceleration at the position of the inertial unit, with the gravity that a tilted unit reads (small angles) (D3).
std::vector<double> acceleration(const Log& motion, const InertialUnit& unit, bool lateral, double rows_per_second) {
    std::vector<double> values = column(motion, lateral ? "chassis.ay" : "chassis.ax");
    const double lean = lateral ? unit.roll : -unit.pitch;
    for (double& value : values) value += kStandardGravity * lean;
    if (unit.fixed_to_body != 0) {
        const double share = lateral ? unit.fixed_to_body : -unit.fixed_to_body;
        const std::vector<double>& angle = column(motion, lateral ? "chassis.roll" : "chassis.pitch");
        for (std::size_t i = 0; i < values.size(); ++i) values[i] += kStandardGravity * share * angle[i];
    }
    if (unit.yaw != 0) {
        const std::vector<double>& across = column(motion, lateral ? "chassis.ax" : "chassis.ay");
        for (std::size_t i = 0; i < values.size(); ++i) values[i] += (lateral ? -unit.yaw : unit.yaw) * across[i];
    }
    if (unit.x == 0 && unit.y == 0 && unit.z == 0) return values;
    const std::vector<double>& yaw_rate = column(motion, "chassis.yaw_rate");
    const std::vector<double> yaw = derivative(yaw_rate, rows_per_second);
    const std::vector<double> tilt =
        derivative(column(motion, lateral ? "chassis.roll_rate" : "chassis.pitch_rate"), rows_per_second);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double squared = yaw_rate[i] * yaw_rate[i];
        values[i] += lateral ? yaw[i] * unit.x - squared * unit.y - tilt[i] * unit.z
                             : -yaw[i] * unit.y - squared * unit.x + tilt[i] * unit.z;
    }
    return values;
}

// Velocity of the point at which a further instrument measures it, along the axes of that instrument (D4).
std::vector<double> velocity(const Log& motion, const InertialUnit& point, bool lateral) {
    std::vector<double> values = column(motion, lateral ? "chassis.vy" : "chassis.vx");
    const double arm = lateral ? point.x : -point.y, skew = lateral ? -point.yaw : point.yaw;
    if (arm == 0 && skew == 0) return values;
    const std::vector<double>& yaw_rate = column(motion, "chassis.yaw_rate");
    const std::vector<double>& across = column(motion, lateral ? "chassis.vx" : "chassis.vy");
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += arm * yaw_rate[i] + skew * across[i];
    return values;
}

InertialUnit mountingOf(const Instruments& instruments, std::string_view channel) {
    const std::string_view source = sourceOf(channel);
    if (source.empty()) return instruments.inertial_unit;
    for (const Mounting& mounting : instruments.mountings) {
        if (mounting.source == source) return mounting.unit;
    }
    return {};
}

// What an ideal instrument would show without delay.
std::vector<double> shownBy(const Log& motion, const Instruments& instruments, std::string_view channel,
                            double rows_per_second) {
    const std::string quantity(quantityOf(channel));
    const InertialUnit unit = mountingOf(instruments, channel);
    if (quantity == "chassis.ax" || quantity == "chassis.ay")
        return acceleration(motion, unit, quantity == "chassis.ay", rows_per_second);
    if (quantity != channel && (quantity == "chassis.vx" || quantity == "chassis.vy"))
        return velocity(motion, unit, quantity == "chassis.vy");
    return column(motion, quantity);
}

}  // namespace

const std::vector<ObservedQuantity>& observedQuantities() {
    static const std::vector<ObservedQuantity> quantities{
        {"chassis.vx", &Instruments::speed, "speed"},
        {"chassis.ax", &Instruments::ax, "longitudinal acceleration"},
        {"chassis.ay", &Instruments::ay, "lateral acceleration"},
        {"chassis.yaw_rate", &Instruments::yaw_rate, "yaw rate"},
        {"chassis.roll_rate", &Instruments::roll_rate, "roll rate"},
        {"chassis.roll", &Instruments::roll, "roll angle"},
        {"chassis.vy", &Instruments::sideslip, "lateral velocity"},
        {"chassis.sideslip", &Instruments::sideslip, "sideslip angle"},
        {"wheel.front_left.spin", &Instruments::wheel_speed, "front left wheel speed"},
        {"wheel.front_right.spin", &Instruments::wheel_speed, "front right wheel speed"},
        {"wheel.rear_left.spin", &Instruments::wheel_speed, "rear left wheel speed"},
        {"wheel.rear_right.spin", &Instruments::wheel_speed, "rear right wheel speed"},
    };
    return quantities;
}

std::string observedQuantitiesListed() {
    std::string list;
    for (const ObservedQuantity& quantity : observedQuantities()) list += (list.empty() ? "" : ", ") + quantity.channel;
    return list;
}

const ObservedQuantity* observedQuantity(std::string_view channel) {
    const auto& all = observedQuantities();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const ObservedQuantity& one) { return one.channel == quantityOf(channel); });
    return found == all.end() ? nullptr : &*found;
}

const Channel* measuredAs(const Log& log, std::string_view quantity) {
    if (const Channel* first = log.find(quantity)) return first;
    if (const Channel* tracked = log.find(std::string(quantity) + "@" + std::string(kPositionSource))) return tracked;
    const auto found = std::find_if(log.channels.begin(), log.channels.end(),
                                    [&](const Channel& channel) { return quantityOf(channel.name) == quantity; });
    return found == log.channels.end() ? nullptr : &*found;
}

Instrument instrumentOf(const Instruments& instruments, std::string_view channel) {
    if (sourceOf(channel).empty()) return instruments.*observedQuantity(channel)->instrument;
    for (const FurtherInstrument& one : instruments.further) {
        if (one.channel == channel) return one.instrument;
    }
    return {};
}

std::vector<double> readings(const Log& motion, const Instruments& instruments, std::string_view channel,
                             const std::vector<double>& times) {
    const std::vector<double>& time = column(motion, "time");
    const double rows_per_second = time.size() > 1 ? 1 / (time[1] - time[0]) : 1;
    const Instrument instrument = instrumentOf(instruments, channel);
    const double delay = instrument.delay + instruments.latency;
    const std::vector<double> shown = shownBy(motion, instruments, channel, rows_per_second);
    std::vector<double> result(times.size());
    for (std::size_t i = 0; i < times.size(); ++i)
        result[i] = instrument.gain * at(shown, rows_per_second, times[i] - delay) + instrument.bias;
    // The bias is that of the sideslip angle, so lateral velocity has bias * vx instead of the bias added above.
    if (quantityOf(channel) == "chassis.vy" && instrument.bias != 0) {
        const std::vector<double>& vx = column(motion, "chassis.vx");
        for (std::size_t i = 0; i < times.size(); ++i)
            result[i] += instrument.bias * (at(vx, rows_per_second, times[i] - delay) - 1);
    }
    return result;
}

}  // namespace tread::recording
