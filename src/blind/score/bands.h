// Bands of detectability, from the sealed key alone (CaseKey::shows).
//
// A fit of the free size of a fault with n nats of expected evidence gains (z + sqrt(2 n))^2 / 2 nats, z standard
// normal: n is half the squared signal-to-noise ratio, and noise moves the fitted signal by one standard deviation.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "blind/key/key.h"

namespace tread::blind::score {

// ---- Limits of the bands. None is a threshold of the diagnosis ----

// Below 6 nats, at most 62 of 100 cases gain 5 nats (odds of 150 to 1): the answer "nothing" is then no error.
inline constexpr double kDetectable = 6;  // nat
// From 22 nats, 9997 of 10 000 cases gain 5 nats: noise does not excuse a wrong diagnosis.
inline constexpr double kTestable = 22;  // nat
// From 100 nats, the signal is at least 14 standard deviations of the noise.
inline constexpr double kStrong = 100;  // nat
// Least separation from the best rival. The evidence for the true effect over the rival is normal with this mean and
// twice this variance: at 6 nats the true effect fits better in 96 of 100 cases.
inline constexpr double kToldApart = 6;  // nat

// Probability that a fault with `expected` nats gains at least `gained` nats.
double chanceToGain(double gained, double expected);

enum class Band { hidden, faint, testable, strong };
constexpr auto enumNames(Band) {
    return std::array<std::string_view, 4>{"below 6", "6 to 22", "22 to 100", "100 and more"};
}
inline constexpr std::array kBands{Band::hidden, Band::faint, Band::testable, Band::strong};

// The lower limit belongs to the band.
Band bandOf(double nats);
std::string_view nameOf(Band band);

// ---- Detectability of the faults of a case ----

// Names of the planted effects and of the outsider.
std::vector<std::string> faultsOf(const key::CaseKey& key);

// Throws LoadError when the key has no detectability of this fault, as keys of other versions of tread.
const key::Detectability& detectabilityOf(const key::CaseKey& key, const std::string& name);

// Least and largest nats of the named faults.
double weakest(const key::CaseKey& key, const std::vector<std::string>& names);
double strongest(const key::CaseKey& key, const std::vector<std::string>& names);

// Whether each has the separation kToldApart.
bool toldApart(const key::CaseKey& key, const std::vector<std::string>& names);

// Whether any fault has kDetectable nats.
bool anyDetectable(const key::CaseKey& key);

}  // namespace tread::blind::score
