// What the runs of a campaign start from: its file and all that this names, or the folder of its results.
#pragma once

#include <string>
#include <vector>

#include "campaign/plan.h"
#include "commands.h"
#include "describable.h"

namespace tread::program {

// `file`: a campaign, or a folder that holds the results of one. `settings`: path=value, of the campaign's file. Throws
// LoadError with every fault of all files.
campaign::Plan readCampaign(const std::string& file, const std::vector<std::string>& settings = {});

// Faults of a campaign's file and of what it names; for `tread check`.
FileReading readCampaignFile(const Path& file);

// Whether runs of this program may stand beside those that the folder has. Throws LoadError when not.
void expectSameProgram(const campaign::Plan& plan, const std::string& folder);

// The folder of the results: that of -o; of a campaign that is given as a folder that folder; else out/<name>.
Path resultFolder(const std::string& file, const std::string& output);

}  // namespace tread::program
