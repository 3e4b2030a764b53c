#include "campaign/campaign_file.h"

#include <string>

#include "base/yaml/read.h"
#include "base/yaml/setting.h"
#include "store/named_file.h"

namespace tread::campaign {
namespace {

std::string listing(std::string_view) {
    return "`tread describe campaign` lists all paths";
}

}  // namespace

CampaignFile loadCampaign(const std::filesystem::path& file, const std::vector<std::string>& settings,
                          const ShippedFiles& shipped) {
    CampaignFile campaign = readYaml<CampaignFile>(file);
    applySettings(campaign, settings, "--set", listing);
    const std::filesystem::path folder = file.parent_path();
    for (std::string& name : campaign.vehicles) name = namedFile(folder, name, shipped, "vehicles");
    for (std::string& name : campaign.scenarios) name = namedFile(folder, name, shipped, "scenarios");
    for (Correlated& group : campaign.correlated) group.identified = namedFile(folder, group.identified);
    if (campaign.title.empty()) campaign.title = file.stem().string();
    return campaign;
}

}  // namespace tread::campaign
