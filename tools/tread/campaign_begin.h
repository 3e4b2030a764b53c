// Beginning of a campaign: its folder, what is said before the first run, and words for sizes and times.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "campaign/probe.h"
#include "commands.h"
#include "drive.h"

namespace tread::program {

// Runs whose time is known before the first piece. Throws LoadError when the disk is too small.
campaign::Probe probed(const campaign::Plan& plan, const Path& folder, const Stop& stop = stopAsked);

// Makes the folder that of the campaign. Before its first piece a probe runs, which warns of factors that change
// nothing. Throws LoadError, FileError, Interrupted.
void beginCampaign(const campaign::Plan& plan, const Path& folder, bool may_probe, const Stop& stop = stopAsked);

// A campaign's measure that ends its runs when `stop` says so. Lives as long as that.
campaign::Measure measureOf(const Stop& stop);

std::uint64_t spaceAt(Path folder);  // free bytes where the folder is, or will be
std::string timeText(double seconds);
std::string bytesText(std::uint64_t bytes);

}  // namespace tread::program
