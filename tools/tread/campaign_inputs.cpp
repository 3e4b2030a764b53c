#include "campaign_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "accepting.h"
#include "base/text/number_text.h"
#include "base/yaml/position.h"
#include "base/yaml/read.h"
#include "base/yaml/setting.h"
#include "blind/key/program_hash.h"
#include "campaign/correlated.h"
#include "campaign/folder.h"
#include "campaign/subject.h"
#include "log/csv.h"
#include "run_inputs.h"
#include "scenario/replay.h"
#include "shipped_file.h"
#include "store/sha256.h"
#include "tread/load.h"

namespace tread::program {
namespace {

using campaign::CampaignFile;
using campaign::CampaignInputs;
using campaign::Plan;
using campaign::Subject;

// Reads files and keeps all their faults.
class Faults {
public:
    explicit Faults(std::string file) : file_(std::move(file)) {}

    template <class Read>
    void collect(const Read& read) {
        try {
            read();
        } catch (const LoadError& error) {
            problems_.insert(problems_.end(), error.problems().begin(), error.problems().end());
        }
    }
    void complain(const std::string& path, const std::string& text) {
        const TextPosition at = positionOfValue(file_, path);
        problems_.push_back({file_, at.line, at.column, path, text});
    }
    void add(Problem problem) { problems_.push_back(std::move(problem)); }
    void stop() {
        if (!problems_.empty()) throwIfAny(std::move(problems_));
    }

private:
    std::string file_;
    std::vector<Problem> problems_;
};

std::string nameOf(const std::string& file) {
    return Path(file).stem().string();
}

void expectOneEach(const std::vector<std::string>& files, const std::string& path, Faults& faults) {
    std::set<std::string> names;
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (!names.insert(nameOf(files[i])).second) {
            faults.complain(path + "." + std::to_string(i),
                            "found a second file named " + quote(nameOf(files[i])) + ", expected names that differ");
        }
    }
}

// The settings of a campaign are those of every scenario: its own fields, and what it changes on the car.
void apply(const std::vector<std::string>& settings, Scenario& scenario, const std::string& file) {
    std::vector<std::string> own;
    for (const std::string& setting : settings) {
        if (setting.starts_with("scenario.")) own.push_back(setting);
        else scenario.car_settings.push_back(setting);
    }
    Subject subject{{}, scenario};
    applySettings(subject, own, file + ": settings", campaign::listingOf);
    scenario = std::move(subject.scenario);
}

// A run of a campaign has one value of each metric.
void expectOneResult(const Scenario& scenario, const std::string& path, Faults& faults) {
    if (!scenario.series.vary) return;
    faults.complain(path, fmt::format("found a scenario with series.vary, which gives several values of each metric, "
                                      "expected one value; make {} a factor of the campaign",
                                      scenario.series.vary->number));
}

// Conditions of the campaign stand beside those of each scenario that has the metric.
void addConditions(CampaignInputs& inputs, const std::string& file, Faults& faults) {
    std::vector<MetricDefinition> known;
    for (campaign::NamedScenario& one : inputs.scenarios) {
        const std::vector<MetricDefinition> own = acceptable(one.scenario);
        Acceptance more;
        for (const AcceptLine& line : inputs.campaign.accept.lines) {
            if (std::any_of(own.begin(), own.end(), [&](const auto& about) { return about.name == line.metric; }))
                more.lines.push_back(line);
        }
        one.scenario.accept = merged(std::move(one.scenario.accept), more);
        known.insert(known.end(), own.begin(), own.end());
    }
    for (const AcceptFault& fault : acceptFaults(inputs.campaign.accept, "any of these scenarios", known))
        faults.add({file, fault.line.line, fault.line.column, "accept." + fault.line.metric, fault.text});
}

// What the folder keeps does not depend on where the files lie.
void detach(CampaignFile& file) {
    for (std::string& name : file.vehicles) name = nameOf(name);
    for (std::string& name : file.scenarios) name = nameOf(name);
    file.settings.clear();
    for (campaign::Correlated& group : file.correlated) {
        const campaign::JointNormal joint = campaign::jointNormal(group);
        group = {joint.paths, joint.mean, joint.covariance, "", group.when};
    }
}

std::vector<std::vector<MetricDefinition>> definitionsOf(const CampaignInputs& inputs) {
    std::vector<std::vector<MetricDefinition>> all;
    for (const campaign::NamedScenario& one : inputs.scenarios) all.push_back(acceptable(one.scenario));
    return all;
}

Plan readFile(const std::string& file, const std::vector<std::string>& settings) {
    CampaignInputs inputs;
    inputs.tread_version = TREAD_VERSION;
    inputs.program = blind::key::programHash().diagnosis;
    inputs.campaign = campaign::loadCampaign(file, settings, shippedFileNamed);
    Faults faults(file);
    expectOneEach(inputs.campaign.vehicles, "vehicles", faults);
    expectOneEach(inputs.campaign.scenarios, "scenarios", faults);
    for (const std::string& vehicle : inputs.campaign.vehicles)
        faults.collect([&] { inputs.vehicles.push_back({nameOf(vehicle), loadVehicle(vehicle)}); });
    for (std::size_t i = 0; i < inputs.campaign.scenarios.size(); ++i) {
        const std::string& name = inputs.campaign.scenarios[i];
        faults.collect([&] {
            Scenario scenario = readScenario(name);
            expectOneResult(scenario, "scenarios." + std::to_string(i), faults);
            if (scenario.manoeuvre.empty() && !inputs.campaign.logs) {
                faults.complain("scenarios." + std::to_string(i),
                                "found a scenario without a manoeuvre, whose runs have no metrics; expected one with a "
                                "manoeuvre, or logs: true");
            }
            apply(inputs.campaign.settings, scenario, file);
            inputs.scenarios.push_back({nameOf(name), withReplaysRead(std::move(scenario))});
        });
    }
    faults.stop();
    addConditions(inputs, file, faults);
    faults.collect([&] { detach(inputs.campaign); });
    faults.stop();
    const auto definitions = definitionsOf(inputs);
    return planOf(std::move(inputs), definitions, file);
}

Plan readFolder(const Path& folder, const std::vector<std::string>& settings) {
    const Path file = campaign::inputsFile(folder);
    if (!std::filesystem::exists(file)) {
        throw LoadError({{folder.string(), 0, 0, "",
                          "found no inputs.yaml, expected the folder of a campaign's results, or a campaign's file"}});
    }
    if (!settings.empty()) {
        throw LoadError(
            {{"--set", 0, 0, "",
              "found settings for a campaign that has begun, expected them with its file and a new folder"}});
    }
    auto inputs = readYaml<CampaignInputs>(file);
    const auto definitions = definitionsOf(inputs);
    Plan plan = planOf(std::move(inputs), definitions, file.string());
    plan.identity = readBytes(file);
    plan.hash = sha256(plan.identity);
    return plan;
}

}  // namespace

Plan readCampaign(const std::string& file, const std::vector<std::string>& settings) {
    return std::filesystem::is_directory(file) ? readFolder(file, settings) : readFile(file, settings);
}

FileReading readCampaignFile(const Path& file) {
    readFile(file.string(), {});
    return {};
}

void expectSameProgram(const Plan& plan, const std::string& folder) {
    if (plan.inputs.program == blind::key::programHash().diagnosis) return;
    throw LoadError({{folder, 0, 0, "",
                      fmt::format("found results of another build of tread (version {}), whose runs may differ from "
                                  "those of this one; finish with that program, or begin anew in another folder",
                                  plan.inputs.tread_version)}});
}

Path resultFolder(const std::string& file, const std::string& output) {
    if (!output.empty()) return output;
    if (std::filesystem::is_directory(file)) return file;
    return Path("out") / Path(file).stem();
}

}  // namespace tread::program
