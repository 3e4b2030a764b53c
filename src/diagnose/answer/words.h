// Phrases for the answer of a diagnosis.
#pragma once

#include <string>
#include <vector>

#include "diagnose/answer/diagnosis.h"

namespace tread::diagnose::answer {

// First line of the answer: the verdict, its causes and their probability.
std::string inWords(const Diagnosis& diagnosis);

// Name of a measured channel for people, such as "yaw rate"; an unknown channel keeps its name.
std::string channelInWords(const std::string& channel);

// "p = 0.97"; close to 1 it reads "p > 0.99", because nothing is certain.
std::string probabilityInWords(double p);

// The law of an unexplained force, with its coefficients; empty when there is none.
std::string lawInWords(const ForceLaw& law);

// "step_1, at about 3.2 s"; empty without a recording.
std::string momentInWords(const Moment& moment);

// The causes that a manoeuvre tells apart: "grip from mass".
std::string separatesInWords(const NextDrive& next);

// Causes that act together: "grip and mass".
std::string together(const std::vector<std::string>& causes);
std::vector<std::string> eachTogether(const std::vector<std::vector<std::string>>& alternatives);

// Effects that are in an alternative but not among the causes, each once.
std::vector<std::string> namesOnlyIn(const std::vector<std::vector<std::string>>& alternatives,
                                     const std::vector<std::string>& causes);

}  // namespace tread::diagnose::answer
