// Phrases for the answer of a diagnosis.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "diagnose/answer/diagnosis.h"

namespace tread::diagnose::answer {

// Name of a measured channel for people, such as "yaw rate"; an unknown channel keeps its name.
std::string channelInWords(const std::string& channel);

// Name of an effect for people: "tyre relaxation", "yaw rate delay (can)".
std::string effectInWords(std::string_view name);

// With a capital letter at its beginning.
std::string capitalised(std::string sentence);

// "12 %", "-5 %"
std::string roundedPercent(double share);

// "12 %"; "less than 1 %" where it would round to nothing.
std::string percentInWords(double share);

// A number with so many significant digits: 1234.5, 141800, 2.5e-06.
std::string shortNumber(double value, int significant_digits = 4);

// What a kind of force in the remainder is, such as "errors of the side forces, in proportion to the lateral
// acceleration".
std::string kindOfForceInWords(const std::string& kind);

// Kinds of force that are larger in the remainder than in an ordinary drive, largest first: their sizes, in usual ones.
std::vector<std::pair<double, std::string>> largeForces(const Unexplained& unexplained);

// "p = 0.97"; close to 1 it reads "p > 0.99", because nothing is certain.
std::string probabilityInWords(double p);

// "follows the square of the lateral acceleration"; empty when there is no law.
std::string followsInWords(const ForceLaw& law);

// The law of an unexplained force, with its coefficients; empty when there is none.
std::string lawInWords(const ForceLaw& law);

// "a vibration at 5 Hz that the references lack: roll rate 22 times, lateral acceleration 6 times their amplitude (12
// nats)"; empty when there is none.
std::string vibrationInWords(const Vibration& vibration);

// "step_1, at about 3.2 s"; empty without a recording.
std::string momentInWords(const Moment& moment);

// The causes that a manoeuvre tells apart: "grip from mass".
std::string separatesInWords(const NextDrive& next);

// The evidence that it can be expected to give: "48 nats". Beyond 100, a larger figure would claim more than any model
// can know.
std::string evidenceInWords(const NextDrive& next);

// Yes: causes are named, or none is found. No: the cause is not known, or the drives cannot show one. The exit status
// of the command.
bool isAnswered(const Diagnosis& diagnosis);

// Whether no cause is named although it is likely that some effect acts: none of them is certain enough.
bool isUncertain(const Diagnosis& diagnosis);

bool isCause(const Diagnosis& diagnosis, const std::string& effect);

// Effects that the drives would not show at their typical size. What is named as a cause or a rival was seen, at a
// larger one, and is not among them.
std::vector<std::string> unseenEffects(const Diagnosis& diagnosis);

// The causes of a diagnosis, those that explain most on their own first.
std::vector<std::string> causesInOrder(const Diagnosis& diagnosis);

// The manoeuvre that tells the causes from an alternative; empty when none is known.
std::string tellingDrive(const Diagnosis& diagnosis);

// Effects that act together: "grip and mass".
std::string together(const std::vector<std::string>& causes);
std::vector<std::string> eachTogether(const std::vector<std::vector<std::string>>& alternatives);

// "grip (p = 0.97)"
std::string certainly(const Diagnosis& diagnosis, const std::string& effect);

// Effects that are neither causes nor in an alternative, of at least this probability; the most probable first.
std::vector<RankedEffect> otherEffects(const Diagnosis& diagnosis, double least_probability);

// Pairs that are hard to tell apart of which one is a cause.
std::vector<ConfusablePair> pairsOfCauses(const Diagnosis& diagnosis);

// Effects that are in an alternative but not among the causes, each once.
std::vector<std::string> namesOnlyIn(const std::vector<std::vector<std::string>>& alternatives,
                                     const std::vector<std::string>& causes);

}  // namespace tread::diagnose::answer
