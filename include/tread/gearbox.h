// Clutch or torque converter, gearbox and its shift map.
#pragma once

#include <string_view>
#include <variant>
#include <vector>

#include "tread/curve.h"
#include "tread/describe.h"

namespace tread {

// Closes with engine speed, as a driver or an automatic clutch would close it.
struct ClutchParams {
    static constexpr std::string_view kName = "clutch";
    double torque = 0;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(torque),
              About{"N m", "largest torque of the closed clutch", kNonNegative}.usually(0.01, 1e4));
    }
};
static_assert(describesEveryMember<ClutchParams>());

// Pump torque = capacity(speed ratio) * pump speed^2, turbine torque = torque_ratio(speed ratio) * pump torque, speed
// ratio = turbine over pump. On overrun turbine and pump change places, without multiplication of torque.
struct TorqueConverterParams {
    static constexpr std::string_view kName = "torque_converter";
    Curve capacity;
    Curve torque_ratio;
    double lock_up_torque = 0;
    double lock_up_speed_ratio = 0.9;
    int lock_up_gear = 1;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(capacity), About{"N m s2/rad2", "pump torque over pump speed squared, 0 at the speed ratio 1",
                                           kNonNegative, 0.1, "-"}
                                         .usually(0, 1)
                                         .over(0, 3));
        field(TREAD_FIELD(torque_ratio),
              About{"-", "turbine torque over pump torque, 1 from the coupling point on", kPositive, 0.05, "-"}
                  .usually(0.5, 4)
                  .over(0, 3));
        field(TREAD_FIELD(lock_up_torque),
              About{"N m", "torque of the closed lock-up clutch (0: none)", kNonNegative}.usually(0.01, 1e4));
        field(TREAD_FIELD(lock_up_speed_ratio),
              About{"-",
                    "speed ratio at which the lock-up clutch begins to close; it is closed at 1",
                    {0, 1, false, true}});
        field(TREAD_FIELD(lock_up_gear), About{"", "lowest gear in which it closes", {1, kInfinity}}.usually(1, 16));
    }
    static void check(const auto& self, auto&& complain) {
        if (self.capacity.empty() || self.capacity.points.back() != Curve::Point{1, 0})
            complain(
                "capacity",
                "the last point must be [1, 0]: a converter whose halves turn at the same speed transmits nothing");
        if (self.torque_ratio.empty() || self.torque_ratio.points.back().y != 1)
            complain("torque_ratio", "the last point must have the torque ratio 1: the stator freewheels there");
    }
};
static_assert(describesEveryMember<TorqueConverterParams>());

using CouplingParams = std::variant<ClutchParams, TorqueConverterParams>;

struct GearboxParams {
    std::vector<double> ratios;
    double final_drive = kRequired;
    double efficiency = 1;
    double inertia = kRequired;
    double shift_up_speed = 0;
    double shift_down_speed = 0;
    Curve shift_up_share{{{0, 0.45}, {1, 1}}};
    Curve shift_down_share{{{0, 1}, {1, 1}}};
    double shift_time = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(ratios), About{"-", "gear ratios, first gear first", kPositive}.usually(0.3, 20));
        field(TREAD_FIELD(final_drive), About{"-", "final drive ratio", kPositive}.usually(0.5, 15));
        field(TREAD_FIELD(efficiency), About{"-", "output torque over input torque when driving", {0, 1, true}, 0.03});
        field(TREAD_FIELD(inertia), About{"kg m2", "inertia at the gearbox input", kPositive}.usually(1e-8, 5));
        field(TREAD_FIELD(shift_up_speed),
              About{"rad/s", "engine speed of upshifts at full throttle", kNonNegative}.usually(50, 4000));
        field(TREAD_FIELD(shift_down_speed),
              About{"rad/s", "engine speed below which the gearbox shifts down", kNonNegative}.usually(30, 4000));
        field(
            TREAD_FIELD(shift_up_share),
            About{"-", "shift map: factor on shift_up_speed versus throttle", kPositive, 0, "-"}.usually(0.05, 3).over(
                0, 1));
        field(TREAD_FIELD(shift_down_share),
              About{"-", "shift map: factor on shift_down_speed versus throttle (kick-down)", kPositive, 0, "-"}
                  .usually(0.05, 10)
                  .over(0, 1));
        field(TREAD_FIELD(shift_time),
              About{"s", "time of a gear change: the clutch is open, then closes in the last third", kNonNegative, 0.3}
                  .usually(0, 3));
    }

    static void check(const auto& self, auto&& complain) {
        if (self.ratios.empty()) complain("ratios", "found no gear, expected at least one ratio");
        for (std::size_t i = 1; i < self.ratios.size(); ++i) {
            if (self.ratios[i] >= self.ratios[i - 1])
                complain("ratios", "each ratio must be smaller than that of the gear before");
        }
        if (self.ratios.size() < 2) return;
        if (self.shift_up_speed == 0)
            complain("shift_up_speed", "missing, expected the speed at which a gearbox with several gears shifts up");
        if (self.shift_down_speed == 0)
            complain("shift_down_speed",
                     "missing, expected the speed at which a gearbox with several gears shifts down");
        if (self.shift_up_speed == 0 || self.shift_down_speed == 0) return;
        // Down at a pedal position, and at once up again?
        for (const Curve* map : {&self.shift_up_share, &self.shift_down_share}) {
            for (const Curve::Point& p : map->points) {
                const double up = self.shift_up_speed * self.shift_up_share(p.x);
                const double down = self.shift_down_speed * self.shift_down_share(p.x);
                for (std::size_t i = 1; i < self.ratios.size(); ++i) {
                    if (down * self.ratios[i - 1] / self.ratios[i] < up) continue;
                    complain("shift_down_share",
                             "the gearbox would shift up and down without end: where it shifts down, the engine is "
                             "then above the speed at which it shifts up; lower the speeds for shifting down");
                    return;
                }
            }
        }
    }
};
static_assert(describesEveryMember<GearboxParams>());

}  // namespace tread
