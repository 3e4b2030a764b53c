// A diagnosis as it could come out, filled in by hand.
#pragma once

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "diagnose/answer/diagnosis.h"

namespace tread::shared {

// Yaw rate and lateral acceleration of a slalom; `late` s behind, `size` times.
inline Log slalom(double late, double size) {
    Log log{{{"time", "s", {}}, {"chassis.yaw_rate", "rad/s", {}}, {"chassis.ay", "m/s2", {}}}};
    for (int i = 0; i <= 800; ++i) {
        const double t = 0.01 * i, r = size * 0.25 * std::sin(1.2 * (t - late) * (1 + 0.25 * t)) * std::min(t, 1.0);
        log.channels[0].values.push_back(t);
        log.channels[1].values.push_back(r);
        log.channels[2].values.push_back(22 * r);
    }
    return log;
}

// The same values at all times of a slalom.
inline Log constantly(int steps, double step, const std::map<std::string, double>& values) {
    Log log{{{"time", "s", {}}}};
    for (int i = 0; i <= steps; ++i) log.channels[0].values.push_back(step * i);
    for (const auto& [name, value] : values)
        log.channels.push_back({name, "", std::vector<double>(log.channels.front().values.size(), value)});
    return log;
}

inline diagnose::answer::Diagnosis sampleDiagnosis() {
    diagnose::answer::Diagnosis d;
    d.verdict = diagnose::answer::Verdict::explained;
    d.answer = "Mostly tyre relaxation (p = 0.97); 1 % of the gap remains unexplained (2 % in the held-out drives)";
    d.causes = {"tyre_relaxation"};
    d.effects = {
        {"tyre_relaxation",
         0.97,
         212,
         {{"front.tyre.parameters.cFy", {105000, 6000, 95100, 114900, 141800, false}},
          {"rear.tyre.parameters.cFy", {105000, 6000, 95100, 114900, 141800, false}}}},
        {"steering_delay",
         0.02,
         205,
         {{"steering.delay", {0.008, 0.003, 0.003, 0.013, 0, false}}, {"steering.lag", {0, 0.002, 0, 0.003, 0, true}}}},
        {"damping", 0.004, 12, {}},
        {"roll_steer_rear", 0.001, 6, {}},
        {"compliance_steer_rear", 0.0002, 4.5, {}}};
    d.probability_of_nothing = 1e-9;
    d.probability_of_unknown = 0.005;
    d.where.channels = {
        {"chassis.yaw_rate", 0.62}, {"chassis.ay", 0.3}, {"chassis.roll_rate", 0.05}, {"chassis.vx", 0.03}};
    d.where.recordings = {
        {"sine_sweep", 0.55}, {"step_steer_80", 0.3}, {"double_lane_change", 0.13}, {"coast_down", 0.02}};
    d.where.phases = {{"transient steering", 0.8}, {"steady turning", 0.12}, {"straight", 0.08}};
    d.where.bands = {{"below 0.3 Hz", 0.05}, {"0.3-1 Hz", 0.25}, {"1-3 Hz", 0.6}, {"above 3 Hz", 0.1}};
    d.where.regimes = {{"20-30 m/s", 0.7}, {"10-20 m/s", 0.3}};
    d.where.generalised_force = {{"yaw", 0.5}, {"lateral", 0.4}, {"roll", 0.07}, {"longitudinal", 0.03}};
    d.where.axle_force = {{"front", 0.71}, {"rear", 0.29}};
    for (const auto& [recording, share] : d.where.recordings) {
        for (const auto& [channel, part] : d.where.channels)
            d.where.channels_of_recording[recording][channel] = share * part;
    }
    d.how_far = {{4.1, 2.9, 1.08, 1}, {3.6, 2.7, 1.12, 1}, 0.92, 0.88, 0.95, false};
    d.training = {.gap = 17,
                  .tolerances = {0.5, 0.41, 0.57},
                  .causes = {0.43, 0.36, 0.5},
                  .remainder = {0.01, 0, 0.02},
                  .noise = {0.06, 0.05, 0.08},
                  .each = {{"tyre_relaxation", {0.43, 0.36, 0.5}, {0.43, 0.36, 0.5}}}};
    d.held_out = {.gap = 13,
                  .tolerances = {0.46, 0.46, 0.46},
                  .causes = {0.44, 0.44, 0.44},
                  .remainder = {0.02, 0.02, 0.02},
                  .noise = {0.08, 0.08, 0.08},
                  .each = {{"tyre_relaxation", {0.44, 0.44, 0.44}, {0.44, 0.44, 0.44}}}};
    d.nuisance = {{"mass", {1362, 14, 1350, 15, 0.8, false}},
                  {"inertia.yaw", {2010, 30, 1920, 50, 1.8, false}},
                  {"brakes.front_share", {0.82, 0.02, 0.8, 0.2, 0.1, false}},
                  {"front.suspension.spring", {23900, 700, 22000, 790, 2.4, true}}};
    d.expected_evidence = {
        {"tyre_relaxation", 180}, {"steering_delay", 96}, {"damping", 40}, {"brake_fade", 0.2}, {"brake_gain", 1.1}};
    d.confusable = {{"damping", "roll_inertia", 0.86, 4.2, "sine_sweep"},
                    {"roll_steer_rear", "compliance_steer_rear", 0.97, 2.1, "double_lane_change"}};
    d.next = {{"scenarios/sine_sweep.yaml", {"tyre_relaxation"}, {"steering_delay"}, 34},
              {"scenarios/straight_braking_100.yaml", {"brake_gain"}, {}, 120}};
    d.unexplained = {.generalised_force = "lateral", .when = {"sine_sweep", 3.2}};
    d.unexplained.sizes = {{"lateral", 1.8}, {"yaw error", 0.6}};
    d.unexplained.beyond_ordinary = 0.4;
    d.credible_set = {"tyre_relaxation"};
    d.baselines = {"steering_delay", "tyre_relaxation"};
    d.cuts = {{"sine_sweep", 6.5, 0.19}};
    d.data_warnings = {
        "coast_down, chassis.roll: changes only at about 20 Hz: a slower signal, held between its samples."};
    d.seconds = 41;
    d.simulations = 2310;
    for (const char* name : {"double_lane_change", "sine_sweep"}) {
        diagnose::answer::Overlay overlay{.recording = name,
                                          .measured = slalom(0.06, 1),
                                          .nominal = slalom(0, 1.05),
                                          .calibrated = slalom(0.015, 1.01),
                                          .extended = slalom(0.058, 1)};
        overlay.hold_out = overlay.recording == "double_lane_change";
        overlay.rows = overlay.measured;
        overlay.floor = constantly(800, 0.01, {{"chassis.yaw_rate", 0.004}, {"chassis.ay", 0.09}});
        overlay.gap = {{"chassis.yaw_rate", overlay.hold_out ? 900 : 2000}, {"chassis.ay", 700}, {"chassis.vx", 50}};
        overlay.remainder = {{"chassis.yaw_rate", 30}, {"chassis.ay", 10}, {"chassis.vx", 0}};
        if (!overlay.hold_out) overlay.allowed = constantly(8, 1, {{"chassis.yaw_rate", 0.02}, {"chassis.ay", 0.3}});
        d.overlays.push_back(overlay);
    }
    return d;
}

}  // namespace tread::shared
