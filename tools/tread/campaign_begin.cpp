#include "campaign_begin.h"

#include <fmt/format.h>

#include <algorithm>

#include "campaign/folder.h"
#include "campaign/result.h"
#include "campaign_inputs.h"
#include "log/csv.h"
#include "store/result_folder.h"
#include "terminal.h"
#include "tread/problem.h"

namespace tread::program {

std::uint64_t spaceAt(Path folder) {
    std::error_code error;
    folder = std::filesystem::absolute(folder, error);
    while (!std::filesystem::exists(folder, error) && folder != folder.parent_path()) folder = folder.parent_path();
    const auto space = std::filesystem::space(folder, error);
    return error ? UINT64_MAX : space.available;
}

campaign::Measure measureOf(const Stop& stop) {
    return [&stop](const VehicleParams& vehicle, const Scenario& scenario, Log* log) {
        return measureUnless(stop, vehicle, scenario, log);
    };
}

campaign::Probe probed(const campaign::Plan& plan, const Path& folder, const Stop& stop) {
    campaign::Probe found = campaign::probe(plan, measureOf(stop));
    for (const std::string& sentence : found.without_effect) warn(sentence);
    const std::uint64_t needed = bytesNeeded(plan, found.bytes_of_log), free = spaceAt(folder);
    if (needed > free) {
        throw LoadError({{folder.string(), 0, 0, "",
                          fmt::format("the campaign needs {} of disk, but only {} are free; choose another folder with "
                                      "-o{}",
                                      bytesText(needed), bytesText(free),
                                      plan.inputs.campaign.logs ? ", or leave out logs" : "")}});
    }
    return found;
}

void beginCampaign(const campaign::Plan& plan, const Path& folder, bool may_probe, const Stop& stop) {
    expectSameProgram(plan, folder.string());
    openFolder(folder, plan);
    if (plan.inputs.campaign.logs) makeFolder(folder / "logs");
    const std::vector<bool> present = piecesPresent(folder, plan);
    if (may_probe && std::find(present.begin(), present.end(), true) == present.end()) probed(plan, folder, stop);
}

std::string timeText(double seconds) {
    if (seconds < 100) return fmt::format("{:.2g} s", seconds);
    if (seconds < 6000) return fmt::format("{:.0f} min", seconds / 60);
    return fmt::format("{:.1f} h", seconds / 3600);
}

std::string bytesText(std::uint64_t bytes) {
    const double mega = static_cast<double>(bytes) / 1e6;
    if (mega < 0.1) return fmt::format("{:.0f} kB", 1e3 * mega);
    return mega < 1000 ? fmt::format("{:.3g} MB", mega) : fmt::format("{:.3g} GB", mega / 1000);
}

}  // namespace tread::program
