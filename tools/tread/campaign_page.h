// The page over the results of a campaign.
#pragma once

#include <string>

#include "campaign/result.h"
#include "commands.h"

namespace tread::program {

// From results.sqlite in the folder.
std::string campaignPage(const campaign::Plan& plan, const Path& folder, const campaign::Tally& tally);

// "1000 runs, 12 not accepted"; with the title, "Tolerances of a lane change: 1000 runs, 12 not accepted, 3 missing".
std::string outcomeText(const campaign::Tally& tally);
std::string campaignAnswer(const campaign::Plan& plan, const campaign::Tally& found);

}  // namespace tread::program
