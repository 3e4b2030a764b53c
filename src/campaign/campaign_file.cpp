#include "campaign/campaign_file.h"

#include <string>

#include "base/read_yaml.h"
#include "base/setting.h"

namespace tread::campaign {
namespace {

std::string listing(std::string_view) {
    return "`tread describe campaign` lists all paths";
}

}  // namespace

CampaignFile loadCampaign(const std::filesystem::path& file, const std::vector<std::string>& settings) {
    CampaignFile campaign = readYaml<CampaignFile>(file);
    applySettings(campaign, settings, "--set", listing);
    const auto place = [&](std::string& name) {
        if (!name.empty()) name = (file.parent_path() / name).lexically_normal().string();
    };
    for (std::string& name : campaign.vehicles) place(name);
    for (std::string& name : campaign.scenarios) place(name);
    for (Correlated& group : campaign.correlated) place(group.identified);
    if (campaign.title.empty()) campaign.title = file.stem().string();
    return campaign;
}

}  // namespace tread::campaign
