// How much of what is wrong with a car its drives show, in bands: from the sealed key alone (CaseKey::shows).
//
// Of something that is expected to give n nats, a fit of its free size gains (z + sqrt(2 n))^2 / 2 nats with z standard
// normal: n is half the squared signal over noise, and the noise moves the fitted signal by one standard deviation.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "blind/key.h"

namespace tread {

// ---- The examiner's lines; no threshold of the diagnosis is among them ----

// Below 6 nats, 5 nats (odds of 150 to 1) are gained in at most 62 of 100 cases: "nothing shows" is then no error.
inline constexpr double kShows = 6;  // nat
// From 22 nats, 5 nats are gained in 9997 of 10 000 cases: a diagnosis has no excuse in the noise.
inline constexpr double kTestable = 22;  // nat
// From 100 nats, the signal is 14 standard deviations of the noise and more.
inline constexpr double kStrong = 100;  // nat
// That the best imitation by another effect leaves unexplained. The evidence for the true one over the imitation is
// normal with this mean and twice this variance: at 6 nats the true one fits better in 96 of 100 cases.
inline constexpr double kToldApart = 6;  // nat

// That something which is expected to give so many nats gains at least `gained`.
double chanceToGain(double gained, double expected);

enum class Band { hidden, faint, testable, strong };
constexpr auto enumNames(Band) {
    return std::array<std::string_view, 4>{"below 6", "6 to 22", "22 to 100", "100 and more"};
}
inline constexpr std::array kBands{Band::hidden, Band::faint, Band::testable, Band::strong};

// The lower end belongs to the band.
Band bandOf(double nats);
std::string_view nameOf(Band band);

// ---- Of a case ----

// The effects that act, and the outsider.
std::vector<std::string> wrongWith(const CaseKey& key);

// Throws LoadError where the key does not say what the drives show of it, as one of another version of tread.
const Shows& showsOf(const CaseKey& key, const std::string& name);

// What the drives show least and most; one of the names at least.
double weakest(const CaseKey& key, const std::vector<std::string>& names);
double strongest(const CaseKey& key, const std::vector<std::string>& names);

// Each is told apart from its best imitation.
bool toldApart(const CaseKey& key, const std::vector<std::string>& names);

// Something is wrong of which the drives show 6 nats or more.
bool anythingShows(const CaseKey& key);

}  // namespace tread
