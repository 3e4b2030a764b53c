// Tables of a diagnosis.
#pragma once

#include <string>
#include <vector>

#include "diagnose/answer/diagnosis.h"
#include "report/html.h"

namespace tread {

// Names in readable form: "tyre relaxation", "yaw rate".
std::string shownName(std::string_view name);
std::vector<std::string> shownNames(const std::vector<std::string>& names);

void addEffects(HtmlPage& page, const diagnose::answer::Diagnosis& diagnosis);
// `extended`: name of the last stage of the model.
void addLevels(HtmlPage& page, const diagnose::answer::HowFar& how_far, const char* extended = "with the effect");
void addWhere(HtmlPage& page, const diagnose::answer::WhereItLies& where);
void addLimits(HtmlPage& page, const diagnose::answer::Diagnosis& diagnosis);
void addNuisances(HtmlPage& page, const diagnose::answer::Diagnosis& diagnosis);
// Priors and thresholds of the diagnosis.
void addSettings(HtmlPage& page);

}  // namespace tread
