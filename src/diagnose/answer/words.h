// The parts of an answer in words.
#pragma once

#include <string>
#include <vector>

#include "diagnose/answer/diagnosis.h"

namespace tread::diagnose::answer {

// The first line of an answer: the verdict, with its causes and how sure they are.
std::string inWords(const Diagnosis& diagnosis);

// A measured channel as people name it: "yaw rate"; one that is not known stays as it is.
std::string channelInWords(const std::string& channel);

// "p = 0.97"; nothing is certain.
std::string probabilityInWords(double p);

// What forces of unknown cause follow, with numbers; empty when nothing is known of it.
std::string lawInWords(const ForceLaw& law);

// "step_1, about 3.2 s"; empty without a recording.
std::string momentInWords(const Moment& moment);

// What a manoeuvre tells apart: "grip from mass".
std::string separatesInWords(const NextDrive& next);

// What acts together: "grip and mass".
std::string together(const std::vector<std::string>& causes);
std::vector<std::string> eachTogether(const std::vector<std::vector<std::string>>& alternatives);

// The effects that stand in alternatives and not among the causes, each once.
std::vector<std::string> namesOnlyIn(const std::vector<std::vector<std::string>>& alternatives,
                                     const std::vector<std::string>& causes);

}  // namespace tread::diagnose::answer
