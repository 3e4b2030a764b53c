#include "answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace tread::program {
namespace {

constexpr std::size_t kPhrases = 3;

// A metric in words. An answer has the first three that are defined, so what says most comes first.
struct Phrase {
    std::string_view metric;
    double scale;  // from the unit of the metric to that of the words
    int decimals;
    std::string_view words;  // {} stands for the number
};

struct Wording {
    std::string_view manoeuvre;
    std::vector<Phrase> phrases;
};

const std::vector<Wording>& wordings() {
    static const std::vector<Wording> list = {
        {"drop_and_settle",
         {{"settling_time", 1, 2, "settles within {} s"},
          {"bounce_frequency", 1, 2, "bounces at {} Hz"},
          {"damping_ratio", 1, 2, "damping ratio {}"},
          {"overshoot", 100, 0, "dips by {} % of the drop"}}},
        {"parked",
         {{"drift", 1, 3, "creeps by {} mm in a minute"},
          {"largest_excursion", 1, 3, "moves by at most {} mm"},
          {"rotation", 1, 4, "turns by {} deg in a minute"}}},
        {"straight_braking",
         {{"stopping_distance", 1, 1, "stops within {} m"},
          {"mfdd", 1, 2, "mean fully developed deceleration {} m/s2"},
          {"locked_share_front_left", 100, 0, "front left wheel locked for {} % of the time"},
          {"lateral_deviation", 1, 2, "{} m off its line"}}},
        {"coast_down",
         {{"time", 1, 1, "coasts for {} s"},
          {"distance", 1, 0, "rolls {} m"},
          {"rolling_resistance", 1, 4, "rolling resistance coefficient {}"}}},
        {"step_steer",
         {{"yaw_rate_response_time", 1000, 0, "yaw rate answers within {} ms"},
          {"yaw_rate_overshoot", 100, 0, "overshoots by {} %"},
          {"steady_ay", 1, 2, "settles at {} m/s2 of lateral acceleration"}}},
        {"sine_steer",
         {{"yaw_rate_gain", 1, 3, "yaw rate gain {} 1/s"},
          {"yaw_rate_phase_lag", 1, 1, "yaw rate lags by {} deg"},
          {"yaw_rate_first_peak_lag", 1000, 0, "first yaw rate peak lags by {} ms"},
          {"ay_phase_lag", 1, 1, "lateral acceleration by {} deg"},
          {"ay_first_peak_lag", 1000, 0, "that of the lateral acceleration by {} ms"}}},
        {"frequency_response",
         {{"yaw_rate_gain_0.5Hz", 1, 3, "yaw rate gain {} 1/s at 0.5 Hz"},
          {"yaw_rate_peak_frequency", 1, 2, "largest at {} Hz"},
          {"yaw_rate_phase_lag_1.0Hz", 1, 0, "lags by {} deg at 1 Hz"}}},
        {"slowly_increasing_steer",
         {{"steering_angle_03g", 1, 1, "steering-wheel angle at 0.3 g {} deg"},
          {"understeer_gradient", 1, 2, "understeer gradient {} deg/g"},
          {"largest_ay", 1, 2, "up to {} m/s2 of lateral acceleration"}}},
        {"sine_with_dwell",
         {{"yaw_rate_ratio_1.00s", 100, 0, "{} % of the peak yaw rate 1 s after the steering (35 % allowed)"},
          {"yaw_rate_ratio_1.75s", 100, 0, "{} % after 1.75 s (20 % allowed)"},
          {"lateral_displacement", 1, 2, "displaced by {} m (at least 1.83 m)"}}},
        {"braking_in_turn",
         {{"mean_deceleration", 1, 2, "decelerates at {} m/s2"},
          {"yaw_rate_ratio", 1, 2, "turns {} times as fast as the circle asks after 1 s"},
          {"path_deviation", 1, 2, "{} m inside of the circle"}}},
        {"power_off",
         {{"yaw_rate_ratio", 1, 2, "turns {} times as fast as the circle asks after 1 s"},
          {"sideslip_change", 1, 2, "sideslip changes by {} deg"},
          {"path_deviation", 1, 2, "{} m inside of the circle"}}},
        {"free_steer",
         {{"settling_time", 1, 2, "straight within {} s of the release"},
          {"yaw_rate_overshoot", 100, 0, "overshoots by {} %"},
          {"last_steering_angle", 1, 1, "hand wheel at {} deg at the end"}}},
        {"split_mu_braking",
         {{"steering_first_2s", 1, 0, "the driver corrects by {} deg in the first 2 s"},
          {"largest_yaw_angle", 1, 1, "the car turns by {} deg"},
          {"mfdd", 1, 2, "MFDD {} m/s2"}}},
        {"acceleration",
         {{"time_0_to_100_kmh", 1, 1, "100 km/h after {} s"},
          {"time_80_to_120_kmh", 1, 1, "80 to 120 km/h within {} s"},
          {"time_400_m", 1, 1, "400 m within {} s"}}},
        {"weave",
         {{"steering_sensitivity", 1, 2, "steering sensitivity {} g/100 deg"},
          {"yaw_rate_lag", 1000, 0, "yaw rate lags by {} ms"},
          {"steering_hysteresis", 1, 1, "hysteresis {} deg"}}},
        {"transition",
         {{"steering_sensitivity", 1, 2, "steering sensitivity {} g/100 deg"},
          {"steering_deadband", 1, 2, "dead band {} deg"}}},
        {"crosswind",
         {{"path_deviation", 1, 2, "{} m off its line after 2 s"},
          {"peak_yaw_rate", 1, 2, "turns at up to {} deg/s"},
          {"peak_ay", 1, 2, "pushed at {} m/s2"}}},
        {"bump",
         {{"highest_az", 1, 1, "body thrown up at {} m/s2"},
          {"lowest_load", 100, 0, "lightest wheel carries {} % of its load"},
          {"settling_time", 1, 1, "calm after {} s"}}},
        {"ride",
         {{"vertical_weighted", 1, 2, "weighted vertical acceleration {} m/s2"},
          {"lowest_load", 1, 0, "lightest wheel carries {} % of its load"},
          {"travel", 1, 1, "suspension travels by {} mm"}}},
        {"straight_running",
         {{"drift", 1, 2, "drifts by {} m"},
          {"last_ay", 1, 3, "{} m/s2 at last"},
          {"hand_torque", 1, 2, "{} N m at the hand wheel"}}},
        {"lane_change",
         {{"cones_hit", 1, 0, "{} cones hit"},
          {"entry_speed", 3.6, 1, "enters at {} km/h"},
          {"least_clearance", 1, 2, "least clearance {} m"}}},
        {"hill_start", {{"roll_back", 1, 2, "rolls back by {} m"}, {"drive_off_time", 1, 1, "drives off within {} s"}}},
        {"steady_circle",
         {{"understeer_gradient", 1, 2, "understeer gradient {} deg/g"},
          {"roll_gradient", 1, 2, "roll gradient {} deg/g"},
          {"largest_ay", 1, 2, "up to {} m/s2 of lateral acceleration"}}}};
    return list;
}

// Rounded, without zeros at the end and without a sign of zero.
std::string shortNumber(double value, int decimals) {
    std::string text = fmt::format("{:.{}f}", value, decimals);
    if (decimals > 0) {
        while (text.back() == '0') text.pop_back();
        if (text.back() == '.') text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

std::string inWords(const Wording& wording, const std::vector<Metric>& metrics) {
    std::string words;
    std::size_t count = 0;
    for (const Phrase& phrase : wording.phrases) {
        const auto metric = std::find_if(metrics.begin(), metrics.end(),
                                         [&](const Metric& candidate) { return candidate.name == phrase.metric; });
        if (metric == metrics.end() || !std::isfinite(metric->value) || count == kPhrases) continue;
        const std::string number = shortNumber(phrase.scale * metric->value, phrase.decimals);
        words += (count == 0 ? "" : ", ") + fmt::format(fmt::runtime(phrase.words), number);
        ++count;
    }
    return words;
}

}  // namespace

std::string runAnswer(const RunRecord& record, const Log& log, const std::vector<Metric>& metrics) {
    const std::string title = record.scenario.title.empty() ? "A scenario without title" : record.scenario.title;
    const std::string car = record.vehicle.name.empty() ? "car without name" : record.vehicle.name;
    std::string words;
    for (const Wording& wording : wordings()) {
        if (wording.manoeuvre == record.scenario.manoeuvre) words = inWords(wording, metrics);
    }
    if (words.empty()) words = fmt::format("drove {} s", shortNumber(log.channels.front().values.back(), 2));
    return fmt::format("{}, {}: {}", title, car, words);
}

}  // namespace tread::program
