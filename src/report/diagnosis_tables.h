// Bars and tables of a diagnosis.
#pragma once

#include <map>
#include <string>

#include "diagnose/answer/diagnosis.h"
#include "report/html.h"

namespace tread {

// Name of an effect, a channel, a phase or a manoeuvre for people: "tyre relaxation", "yaw rate".
std::string shownName(std::string_view name);

// What the gap consists of: a bar and a table for the drives that were fitted, and for those held out.
void addParts(HtmlPage& page, const diagnose::answer::Diagnosis& diagnosis);
// What the named causes change, number by number.
void addChanges(HtmlPage& page, const diagnose::answer::Diagnosis& diagnosis);
// Numbers that moved within their tolerances.
void addMoved(HtmlPage& page, const std::map<std::string, diagnose::answer::NuisanceEstimate>& numbers);
// The nominal car fitted to the references.
void addCarBefore(HtmlPage& page, const diagnose::answer::FittedBefore& before);
// Effects by probability, and pairs that are hard to tell apart.
void addRivals(HtmlPage& page, const diagnose::answer::Diagnosis& diagnosis);
// Ends of drives that are not compared, and warnings about the data.
void addLeftOut(HtmlPage& page, const diagnose::answer::Diagnosis& diagnosis);
// What no cause explains, and where it acts.
void addRemainder(HtmlPage& page, const diagnose::answer::Diagnosis& diagnosis);
void addWhere(HtmlPage& page, const diagnose::answer::WhereItLies& where);
// Manoeuvres to drive, and effects that these drives would not show.
void addNextDrives(HtmlPage& page, const diagnose::answer::Diagnosis& diagnosis);
// Priors and thresholds of the diagnosis.
void addSettings(HtmlPage& page);

}  // namespace tread
