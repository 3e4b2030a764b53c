// How alike two curves are, from 0 to 1, after ISO/TS 18571 (objective rating of transient signals): corridor, phase,
// magnitude and slope. Names and numbers as in the public OpenVT implementation; the grades from the literature on the
// standard. It says how alike, never why.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "log/log.h"
#include "tread/describe.h"

namespace tread {

struct ScoreParams {
    std::vector<std::string> scored{"chassis.yaw_rate", "chassis.ay", "chassis.roll", "chassis.sideslip"};
    double least = 0.8;
    double corridor_inner = 0.05;
    double corridor_outer = 0.5;
    double corridor_exponent = 2;
    double largest_shift = 0.2;
    double phase_exponent = 1;
    double magnitude_error = 0.5;
    double magnitude_exponent = 1;
    double warping_window = 0.1;
    double slope_error = 2;
    double slope_exponent = 1;
    double corridor_weight = 0.4;
    double phase_weight = 0.2;
    double magnitude_weight = 0.2;
    double slope_weight = 0.2;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(scored), About{"", "channels to score, as names or patterns with *"});
        field(TREAD_FIELD(least), About{"-", "a channel below this fails; 0.8 is the grade good", kFraction});
        field(
            TREAD_FIELD(corridor_inner),
            About{"-", "half width, as a share of the reference's peak, within which a sample scores 1", kNonNegative});
        field(TREAD_FIELD(corridor_outer), About{"-", "half width beyond which it scores 0", kPositive});
        field(TREAD_FIELD(corridor_exponent), About{"-", "exponent between the two", kPositive});
        field(TREAD_FIELD(largest_shift),
              About{"-", "shift, as a share of the duration, that scores 0; larger shifts are not considered",
                    Limits{0, 0.5, true, true}});
        field(TREAD_FIELD(phase_exponent), About{"-", "exponent of the phase score", kPositive});
        field(TREAD_FIELD(magnitude_error), About{"-", "relative error of the warped curves that scores 0", kPositive});
        field(TREAD_FIELD(magnitude_exponent), About{"-", "exponent of the magnitude score", kPositive});
        field(TREAD_FIELD(warping_window),
              About{"-", "largest shift of a sample by warping, as a share of the duration", Limits{0, 1}});
        field(TREAD_FIELD(slope_error), About{"-", "relative error of the slopes that scores 0", kPositive});
        field(TREAD_FIELD(slope_exponent), About{"-", "exponent of the slope score", kPositive});
        field(TREAD_FIELD(corridor_weight), About{"-", "weight in the total score", kFraction});
        field(TREAD_FIELD(phase_weight), About{"-", "weight in the total score", kFraction});
        field(TREAD_FIELD(magnitude_weight), About{"-", "weight in the total score", kFraction});
        field(TREAD_FIELD(slope_weight), About{"-", "weight in the total score", kFraction});
    }
    static void check(const auto& self, auto&& complain) {
        if (!(self.corridor_outer > self.corridor_inner)) {
            complain("corridor_outer", "found a half width that is not above corridor_inner");
        }
        const double sum = self.corridor_weight + self.phase_weight + self.magnitude_weight + self.slope_weight;
        if (!(sum > 0.999999 && sum < 1.000001)) {
            complain("corridor_weight", "found weights that do not add up to 1, expected 1; correct one of the four");
        }
    }
};
static_assert(describesEveryMember<ScoreParams>());

struct Score {
    double total = 0;
    double corridor = 0;
    double phase = 0;
    double magnitude = 0;
    double slope = 0;
    int shift = 0;  // samples by which the candidate is late
};

// Both on the same uniform time base, at least ten samples, finite.
Score score(std::span<const double> reference, std::span<const double> candidate, const ScoreParams& params = {});

// "excellent", "good", "fair" or "poor".
std::string_view gradeOf(double score);

struct ChannelScore {
    std::string channel;
    std::string reference;  // which measurement
    Score score;
    double shift = 0;  // s by which the candidate is late
};

struct NamedLog {
    std::string name;
    Log log;
};

struct Scores {
    bool passed = false;  // every channel reaches `least`, and there was one
    double least = 0;
    std::vector<ChannelScore> channels;
    std::vector<std::string> notes;  // what was not scored and why, one sentence each
};

// The candidate against each measurement, over their common time on uniform samples.
Scores scoreLogs(const std::vector<NamedLog>& measured, const Log& candidate, const ScoreParams& params);

// First line: the answer in words.
std::string text(const Scores& scores);
nlohmann::json json(const Scores& scores);

}  // namespace tread
