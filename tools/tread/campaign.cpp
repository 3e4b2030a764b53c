#include "campaign.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <thread>

#include "base/text/number_text.h"
#include "base/yaml/write.h"
#include "campaign/result.h"
#include "campaign/work.h"
#include "campaign_begin.h"
#include "campaign_inputs.h"
#include "campaign_page.h"
#include "drive.h"
#include "log/csv.h"
#include "output.h"
#include "refuse.h"
#include "run/simulate.h"
#include "run_scenario.h"
#include "shared_work.h"
#include "store/claims.h"
#include "terminal.h"
#include "tread/problem.h"

namespace tread::program {
namespace {

using campaign::Plan;
using campaign::Probe;
using campaign::Status;
using campaign::Tally;

unsigned threadsOf(int asked) {
    return asked > 0 ? static_cast<unsigned>(asked) : std::max(1u, std::thread::hardware_concurrency());
}

// "1000 runs: in 2 vehicles, 1 scenario, 64 pieces of up to 16 runs".
std::string sizeText(const Plan& plan) {
    return fmt::format("{}: {} in {}, {} of up to {}", counted(plan.runs, "run"),
                       counted(plan.inputs.vehicles.size(), "vehicle"),
                       counted(plan.inputs.scenarios.size(), "scenario"), counted(plan.pieces(), "piece"),
                       counted(plan.runs_per_piece, "run"));
}

int dryRun(const Plan& plan, const Path& folder, const CampaignOptions& options) {
    const Probe found = probed(plan, folder);
    const double seconds = found.seconds_per_run * static_cast<double>(plan.runs);
    const unsigned threads = threadsOf(options.threads);
    const std::uint64_t bytes = bytesNeeded(plan, found.bytes_of_log);
    const std::string answer = fmt::format("{}; about {} on {}, {} of disk", counted(plan.runs, "run"),
                                           timeText(seconds / threads), counted(threads, "thread"), bytesText(bytes));
    if (options.json) {
        printJson({{"answer", answer},
                   {"runs", plan.runs},
                   {"pieces", plan.pieces()},
                   {"seconds_on_one_core", seconds},
                   {"threads", threads},
                   {"bytes", bytes},
                   {"bytes_free", spaceAt(folder)},
                   {"without_effect", found.without_effect}});
    } else {
        say(fmt::format("{}\n  {}\n  {:.3g} ms a run on one core\n", answer, sizeText(plan),
                        1e3 * found.seconds_per_run));
    }
    return kYes;
}

// One run again, with log and page.
int oneRun(const Plan& plan, const Path& folder, std::uint64_t number, const CampaignOptions& options) {
    if (number >= plan.runs)
        refuse("--run", fmt::format("found {}, expected a run from 0 to {}", number, plan.runs - 1));
    const campaign::PlannedRun run = plannedRun(plan, number);
    campaign::Subject subject = subjectOf(plan, run);
    const RunRecord record{TREAD_VERSION, 0, std::move(subject.vehicle), std::move(subject.scenario)};
    const Path target = folder / "runs" / std::to_string(number);
    listenToSignals();
    try {
        const Driven driven = driveScenario(record, target, {}, [](double) {});
        if (options.json) printJson(driven.json);
        else
            say(fmt::format("run {}: {}\nReport: {}\n", number, driven.answer,
                            std::filesystem::absolute(target / "report.html").lexically_normal().string()));
        return kYes;
    } catch (const Interrupted& error) {
        fmt::print(stderr, "tread campaign: {}\n", error.what());
        return stoppedStatus();
    } catch (const SimulationError& error) {
        fmt::print(stderr, "tread campaign: run {}: {}\n", number, error.what());
        return kRunFailed;
    }
}

nlohmann::json jsonOfTally(const Tally& tally) {
    nlohmann::json statuses;
    constexpr auto kNames = enumNames(Status{});
    for (std::size_t i = 0; i < kNames.size(); ++i) statuses[std::string(kNames[i])] = tally.of[i];
    return {{"runs", tally.runs},
            {"missing", tally.missing},
            {"status", statuses},
            {"damaged", tally.damaged},
            {"seconds", tally.seconds}};
}

// The result of what the folders hold.
int finish(const Plan& plan, const std::vector<Path>& folders, const Path& target, bool partial, bool json) {
    const Tally found = merge(plan, folders, target, partial);
    for (const std::string& piece : found.damaged) warn(piece);
    const bool whole = found.missing == 0;
    if (!whole && !partial) {
        const std::string answer =
            fmt::format("{} of {} missing: `tread campaign {}` computes them, --partial leaves them out",
                        counted(found.missing, "run"), plan.runs, target.string());
        if (json) printJson({{"answer", answer}, {"result", jsonOfTally(found)}});
        else say(answer + "\n", Tone::bad);
        return kNo;
    }
    const Path page = target / "report.html";
    writeFile(page, campaignPage(plan, target, found));
    const std::string answer = campaignAnswer(plan, found);
    if (json) {
        printJson({{"answer", answer}, {"result", jsonOfTally(found)}, {"folder", target.string()}});
    } else {
        say(fmt::format("{}\nTable: {}\nReport: {}\n", answer, (target / "results.csv").string(),
                        std::filesystem::absolute(page).lexically_normal().string()),
            found.failed() > 0 ? Tone::bad : Tone::plain);
    }
    return found.runs > 0 && found.failed() == found.runs ? kRunFailed : kYes;
}

int unfinished(const campaign::Worked& worked, const Path& folder, const CampaignOptions& options) {
    const std::string answer =
        options.shard.empty()
            ? fmt::format("interrupted after {}; the same call goes on", counted(worked.runs, "run"))
            : fmt::format("part {} is done, {} by this call; `tread campaign merge {}` joins the parts", options.shard,
                          counted(worked.runs, "run"), folder.string());
    if (worked.stopped) {
        fmt::print(stderr, "tread campaign: {}\n", answer);
        return stoppedStatus();
    }
    if (options.json) printJson({{"answer", answer}, {"runs", worked.runs}, {"seconds", worked.seconds}});
    else say(answer + "\n");
    return kYes;
}

}  // namespace

int campaign(const CampaignOptions& options) {
    if (options.file.empty())
        refuse("tread campaign", "found no campaign, expected a file (YAML) or the folder of its results");
    const Plan plan = readCampaign(options.file, options.settings);
    const Path folder = resultFolder(options.file, options.output);
    if (options.dry_run) return dryRun(plan, folder, options);
    if (options.run) return oneRun(plan, folder, *options.run, options);
    const Shard shard = shardOf(options.shard);
    listenToSignals();
    try {
        beginCampaign(plan, folder, shard.part == 0);
    } catch (const Interrupted&) {
        return unfinished({.runs = 0, .stopped = true}, folder, options);
    }
    Progress progress(static_cast<double>(plan.runs), "runs");
    const campaign::Worked worked =
        campaign::work(plan, folder, measure, workOptions(options.threads, options.shard, progress));
    if (worked.stopped || !worked.complete) return unfinished(worked, folder, options);
    return finish(plan, {folder}, folder, false, options.json);
}

int campaignMerge(const CampaignMergeOptions& options) {
    const Plan plan = readCampaign(options.folders.front());
    std::vector<Path> folders;
    for (const std::string& folder : options.folders) {
        const std::string identity = readBytes(campaign::inputsFile(folder));
        if (identity != plan.identity) {
            refuse(folder, "found the results of another campaign than in " + options.folders.front() + ": " +
                               campaign::firstDifference(plan.identity, identity));
        }
        folders.emplace_back(folder);
    }
    const Path target = options.output.empty() ? folders.front() : Path(options.output);
    openFolder(target, plan);
    if (std::find(folders.begin(), folders.end(), target) == folders.end()) folders.push_back(target);
    return finish(plan, folders, target, options.partial, options.json);
}

int campaignStatus(const CampaignStatusOptions& options) {
    const Plan plan = readCampaign(options.folder);
    const Tally found = tally(plan, {options.folder});
    const std::size_t running = claimed(options.folder, plan.pieces()).size();
    const double left = found.runs == 0
                            ? std::nan("")
                            : found.seconds / static_cast<double>(found.runs) * static_cast<double>(found.missing);
    for (const std::string& piece : found.damaged) warn(piece);
    std::string answer = found.missing == 0 ? fmt::format("all {} done", counted(plan.runs, "run"))
                                            : fmt::format("{} of {} done", found.runs, counted(plan.runs, "run"));
    if (found.failed() > 0) answer += fmt::format(", {} failed", found.failed());
    if (found.missing > 0 && !std::isnan(left)) answer += fmt::format(", about {} left on one core", timeText(left));
    if (options.json) {
        nlohmann::json json = {
            {"answer", answer}, {"result", jsonOfTally(found)}, {"pieces", plan.pieces()}, {"pieces_running", running}};
        json["seconds_left_on_one_core"] = std::isnan(left) ? nlohmann::json(nullptr) : nlohmann::json(left);
        printJson(json);
    } else {
        say(fmt::format("{}\n  {}\n  {} running\n", answer, outcomeText(found), counted(running, "piece")));
    }
    return found.missing == 0 ? kYes : kNo;
}

}  // namespace tread::program
