// Are two logs the same within tolerance, and if not: where and when do they part?
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/tolerances.h"
#include "log/log.h"

namespace tread {

struct Divergence {
    double time;  // s, of the reference
    double reference;
    double candidate;
};

// Differences are candidate minus reference over the common time, on the samples of the reference.
struct ChannelComparison {
    std::string channel;
    std::string unit;
    bool same = true;
    std::size_t samples = 0;  // that were compared
    double peak = 0;          // largest magnitude of the whole reference channel
    double allowed = 0;       // difference up to which the channels are the same
    double largest = 0;       // largest magnitude of the difference
    double largest_time = 0;  // s
    double rms = 0;           // of the difference
    // Share of the reference's variance that the candidate explains, 0 to 1. None where the reference does not vary,
    // and where the mean of the reference is nearer to it than the candidate (`no_fit`): how far below 0 the formula
    // then falls says how little the reference varies, not how good the candidate is.
    std::optional<double> r_squared;
    bool no_fit = false;
    std::optional<Divergence> first;  // where the tolerance is left
    std::size_t reference_not_finite = 0;
    std::size_t candidate_not_finite = 0;

    // Largest difference over the allowed one; 0 when nothing differs.
    double severity() const;
};

struct Comparison {
    bool same = true;
    double from = 0;                          // s, common time
    double to = 0;                            // s
    double time_shift = 0;                    // s by which the candidate was late; taken out before comparing
    std::vector<ChannelComparison> channels;  // in the order of the reference
    std::vector<std::string> missing;         // channels that only the reference has: a difference
    std::vector<std::string> extra;           // channels that only the candidate has: no difference
    std::vector<std::string> faults;          // why the logs differ beyond their values, one sentence each
    std::vector<std::string> notes;           // what the reader should know, one sentence each
    std::string nothing;                      // why no channel was compared, in a clause; empty: some were

    std::size_t differing() const;
};

// The candidate is read, linearly between its samples, at the times of the reference. A value that is not finite in one
// log but not in the other is a difference; so is a log that ends early.
Comparison compare(const Log& reference, const Log& candidate, const Tolerances& tolerances = {});

// What "no fit" stands for in the place of R2.
inline constexpr std::string_view kNoFit =
    "no fit: the mean of the reference is closer to the reference than the candidate is, so there is no R2";

// What was found besides values, one sentence each: faults, notes, channels that only one log has.
std::vector<std::string> remarks(const Comparison& comparison);

// First line: the answer in words. Then what was found besides values, and a table of the worst channels.
std::string text(const Comparison& comparison, std::size_t worst = 10);
nlohmann::json json(const Comparison& comparison);

}  // namespace tread
