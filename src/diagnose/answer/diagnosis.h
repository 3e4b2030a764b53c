// The answer of a diagnosis. `diagnosis.json` has the same names.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "log/log.h"
#include "tread/describe.h"

namespace tread::diagnose::answer {

// partly_explained: causes are named, and beside them remains what no effect of the catalogue explains.
enum class Verdict { explained, nothing, ambiguous, unknown, not_testable, partly_explained };
constexpr auto enumNames(Verdict) {
    return std::array<std::string_view, 6>{"explained", "nothing",      "ambiguous",
                                           "unknown",   "not_testable", "partly_explained"};
}

struct Estimate {  // estimate of one parameter
    double value = 0, sd = 0, low = 0, high = 0, neutral = 0;
    bool at_bound = false;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(value), About{"-", "best estimate, SI units"});
        field(TREAD_FIELD(sd), About{"-", "standard deviation of the change from `neutral`"});
        field(TREAD_FIELD(low), About{"-", "lower end of the 90 % interval, by the same"});
        field(TREAD_FIELD(high), About{"-", "upper end of the 90 % interval"});
        field(TREAD_FIELD(neutral),
              About{"-", "value of the nominal car, or of the car before the change as fitted to its drives"});
        field(TREAD_FIELD(at_bound), About{"", "the estimate is at the end of its plausible range"});
    }
};
static_assert(describesEveryMember<Estimate>());

struct RankedEffect {
    std::string name;
    double probability = 0;
    double log_evidence = 0;
    std::map<std::string, Estimate> parameters;
    std::string against = {};

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(name), About{"", "name of the effect"});
        field(TREAD_FIELD(probability), About{"-", "probability that it is one of the causes"});
        field(TREAD_FIELD(log_evidence), About{"nat", "log evidence relative to that of no effect"});
        field(TREAD_FIELD(parameters), About{"", "estimates by path"});
        field(TREAD_FIELD(against), About{"", "why the effect alone is not the answer although it has evidence"});
    }
};
static_assert(describesEveryMember<RankedEffect>());

// A set of effects that has more evidence than others, and yet cannot be the answer.
struct RuledOut {
    std::vector<std::string> effects;
    double log_evidence = 0;
    std::string reason;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(effects), About{"", "names of the effects"});
        field(TREAD_FIELD(log_evidence), About{"nat", "log evidence relative to that of no effect"});
        field(TREAD_FIELD(reason), About{"", "why they are not the answer"});
    }
};
static_assert(describesEveryMember<RuledOut>());

using Shares = std::map<std::string, double>;  // share by name, sum 1

struct WhereItLies {
    Shares channels, recordings, phases, bands, regimes, generalised_force;
    Shares axle_force;  // front and rear: shares of the side force that would close the gap
    std::map<std::string, Shares> channels_of_recording;  // by recording and channel; all of them together sum to 1
};

// Share of the squared gap of the nominal car, with its 90 % interval over the drives.
struct Part {
    double share = 0, low = 0, high = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(share), About{"-", "share of the squared gap of the nominal car"});
        field(TREAD_FIELD(low), About{"-", "lower end of the 90 % interval over the drives"});
        field(TREAD_FIELD(high), About{"-", "upper end of the 90 % interval over the drives"});
    }
};
static_assert(describesEveryMember<Part>());

// What one cause closes: beside the tolerances alone, and after all other causes. Overlapping causes share a part of
// the gap, and the two differ.
struct CausePart {
    std::string name;
    Part first, last;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(name), About{"", "name of the effect"});
        field(TREAD_FIELD(first), About{"", "share that it closes beside the tolerances alone"});
        field(TREAD_FIELD(last), About{"", "share that it closes after all other causes"});
    }
};
static_assert(describesEveryMember<CausePart>());

// The squared gap between the recordings and the nominal car, in parts that sum to 1. Differences are divided by what
// noise and usual disturbances cause (D46).
struct Decomposition {
    double gap = 0;
    Part tolerances, causes, remainder, noise;
    std::vector<CausePart> each;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(gap), About{"-", "mean squared difference of the nominal car, over that of a perfect model"});
        field(TREAD_FIELD(tolerances), About{"", "part that numbers of the car within their tolerances explain"});
        field(TREAD_FIELD(causes), About{"", "part that all causes together explain besides"});
        field(TREAD_FIELD(remainder), About{"", "part that remains unexplained"});
        field(TREAD_FIELD(noise), About{"", "part that a perfect model would leave: noise and usual disturbances"});
        field(TREAD_FIELD(each), About{"", "part of each cause"});
    }
};
static_assert(describesEveryMember<Decomposition>());

// Root mean square of the gap in units of the noise. `floor` is the level that a perfect model would leave.
struct GapLevels {
    double nominal = 0, calibrated = 0, extended = 0, floor = 0;
};

struct HowFar {
    GapLevels training, held_out;
    double closure = 0, closure_low = 0, closure_high = 0;  // share of the nominal car's gap to the true car
    bool in_sample = false;                                 // true when no recording was held out
};

// A number of car, road or instruments that is known within a tolerance, as a fit found it.
struct NuisanceEstimate {
    double value = 0, sd = 0, nominal = 0, prior_sd = 0, z = 0;
    bool at_bound = false;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(value), About{"-", "best estimate, SI units"});
        field(TREAD_FIELD(sd), About{"-", "standard deviation"});
        field(TREAD_FIELD(nominal), About{"-", "value of the nominal car"});
        field(TREAD_FIELD(prior_sd), About{"-", "standard deviation of its tolerance"});
        field(TREAD_FIELD(z), About{"-", "change in standard deviations of its tolerance"});
        field(TREAD_FIELD(at_bound), About{"", "the estimate is at the end of its plausible range"});
    }
};
static_assert(describesEveryMember<NuisanceEstimate>());

// The nominal car fitted to the references. Levels: root mean square of the gap, over that of a perfect model (D46).
struct FittedBefore {
    double nominal = 0, fitted = 0;
    std::map<std::string, NuisanceEstimate> moved = {};

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(nominal), About{"-", "gap of the nominal car in the references; 1: a perfect model"});
        field(TREAD_FIELD(fitted), About{"-", "the same after the fit; 0: no references"});
        field(TREAD_FIELD(moved), About{"", "numbers of the fit, by path"});
    }
};
static_assert(describesEveryMember<FittedBefore>());

// The end of a drive that is not compared.
struct Cut {
    std::string recording;
    double until = 0;
    double share = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(recording), About{"", "name of the recording"});
        field(TREAD_FIELD(until), About{"s", "time after which it is not compared"});
        field(TREAD_FIELD(share), About{"-", "share of its measured rows that is left out"});
    }
};
static_assert(describesEveryMember<Cut>());

struct ConfusablePair {
    std::string a, b;
    double cosine = 0;      // of their signatures, with the nuisances projected out
    double separation = 0;  // nats at typical size
    std::string manoeuvre;  // recording that separates them most
};

struct NextDrive {
    std::string scenario;
    std::vector<std::string> one, other;  // sets of causes that it separates; empty `other`: no cause
    double nats = 0;
};

// Law of forces that no effect of the catalogue explains.
struct ForceLaw {
    std::string follows = {};  // quantity that the force follows, in words; empty when the gain is not clear
    std::string unit = {};     // unit of that quantity; empty for a force that is always the same
    std::map<std::string, double> coefficients = {};  // of each generalised force: N or N m per unit
    std::string generalised_force = {};               // the largest of them; empty when effects act too
    double gain = 0;                                  // nats over the best model
};

// Vibration that the references lack.
struct Vibration {
    double frequency = 0;                       // Hz, where it is clearest; 0: none
    std::map<std::string, double> growth = {};  // of channels that show it: amplitude, over that in the references
    double gain = 0;                            // nats over a difference from day to day
};

struct Moment {
    std::string recording = {};  // empty: no moment found
    double time = 0;             // s
};

struct Unexplained {
    std::string generalised_force;  // longitudinal, lateral, yaw or roll: the largest missing force
    Moment when;                    // moment at which it is largest
    // Kind of errors of readings, if it is clearly beyond its usual size, and further than any kind of force.
    std::string instrument = {};
    ForceLaw law = {};  // law that it follows, if one was found
    Vibration vibration = {};
    // Size of each kind of remainder, over that of an ordinary drive: disturbances, errors in proportion to the
    // acceleration ("lateral error"), errors of readings, and imperfections of each part.
    std::map<std::string, double> sizes = {};
    double beyond_ordinary = 0;  // nats by which the remainder is larger than ordinary
};

// Answers of simpler methods: the name of one effect, or "none".
struct Baselines {
    std::string largest_reduction;
    std::string bic;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(largest_reduction), About{"", "effect that on its own reduces the squared gap most"});
        field(TREAD_FIELD(bic),
              About{"",
                    "effect with the lowest Bayesian information criterion; tolerances fitted, disturbances ignored"});
    }
};
static_assert(describesEveryMember<Baselines>());

// Time histories for report and logs: measured, nominal, calibrated, and with the causes.
struct Overlay {
    std::string recording;
    bool hold_out = false;
    Log measured, nominal, calibrated, extended;
    Log rows = {};     // measured, as it is compared: means over blocks
    Log floor = {};    // standard deviation of these rows by noise and usual disturbances; none where not compared
    Log allowed = {};  // standard deviation of the nominal rows due to tolerances; empty for held-out drives
    // By channel: squared difference of the nominal car, and of the car with the causes, beyond that of a perfect model
    // (D46).
    std::map<std::string, double> gap = {}, remainder = {};
};

struct Diagnosis {
    Verdict verdict = Verdict::not_testable;
    std::string answer;  // in words
    std::vector<std::string> causes;
    std::vector<std::vector<std::string>> alternatives;  // to the causes: sets of the same number of effects
    std::vector<RankedEffect> effects;                   // best first
    std::vector<RuledOut> ruled_out;                     // most probable first
    double probability_of_nothing = 0;                   // no effect, or only effects below the threshold of evidence
    double probability_of_unknown = 0;
    WhereItLies where;
    Decomposition training, held_out;  // held_out is empty without such drives
    HowFar how_far;
    FittedBefore before;
    std::map<std::string, NuisanceEstimate> nuisance;
    std::map<std::string, double> expected_evidence;  // nats, of each effect at its typical size
    std::vector<ConfusablePair> confusable;
    std::vector<NextDrive> next;
    Unexplained unexplained;
    std::vector<std::string> credible_set;
    Baselines baselines;
    bool compared = false;  // true when every recording has a reference
    std::vector<Cut> cuts;  // drives that are not compared to their end
    std::vector<std::string> data_warnings;
    double seconds = 0;
    int simulations = 0;
    std::vector<Overlay> overlays;
};

}  // namespace tread::diagnose::answer
