// The page over the results of a campaign.
#pragma once

#include <string>

#include "campaign/result.h"
#include "commands.h"

namespace tread::program {

// From results.sqlite in the folder.
std::string campaignPage(const campaign::Plan& plan, const Path& folder, const campaign::Tally& tally);

}  // namespace tread::program
