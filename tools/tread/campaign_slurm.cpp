#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/text/number_text.h"
#include "base/text/trimmed.h"
#include "campaign.h"
#include "campaign/folder.h"
#include "campaign_begin.h"
#include "campaign_inputs.h"
#include "log/csv.h"
#include "output.h"
#include "store/result_folder.h"
#include "terminal.h"
#include "tread/problem.h"

namespace tread::program {
namespace {

constexpr double kTaskSeconds = 300;        // long against the second that Slurm takes to start a task, short to lose
constexpr std::uint64_t kMostTasks = 1000;  // Slurm's own default limit of an array is 1001 (MaxArraySize)

std::string quoted(const std::string& word) {
    std::string out = "'";
    for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

std::string scriptOf(const CampaignSlurmOptions& options, const std::string& name, const Path& log,
                     const std::string& more, const std::string& command) {
    std::string script = fmt::format(
        "#!/bin/bash\n#SBATCH --job-name={}\n#SBATCH --cpus-per-task={}\n#SBATCH --requeue\n#SBATCH "
        "--open-mode=append\n"
        "#SBATCH --output={}\n{}",
        name, options.cpus, log.string(), more);
    if (!options.partition.empty()) script += "#SBATCH --partition=" + options.partition + "\n";
    if (!options.time.empty()) script += "#SBATCH --time=" + options.time + "\n";
    return script + "exec " + command + "\n";
}

// Number of the job that a script becomes. Throws LoadError with Slurm's own words when it refuses.
std::string submitted(const Path& script, const std::string& option) {
    const std::string command = "sbatch --parsable " + option + " " + quoted(script.string()) + " 2>&1";
    std::FILE* const pipe = popen(command.c_str(), "r");
    std::string said;
    if (pipe) {
        char buffer[4096];
        for (std::size_t n = 0; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) said.append(buffer, n);
    }
    const int state = pipe ? pclose(pipe) : -1;
    const int status = WIFEXITED(state) ? WEXITSTATUS(state) : -1;
    constexpr int kNotFound = 127;  // of a shell
    if (status == kNotFound || !pipe) {
        throw LoadError({{"--submit", 0, 0, "",
                          fmt::format("found no sbatch: Slurm is not installed on this machine; the scripts are in {}, "
                                      "submit them where it is",
                                      script.parent_path().string())}});
    }
    if (status != 0) {
        std::string words(trimmed(said));
        std::replace(words.begin(), words.end(), '\n', ' ');
        throw LoadError({{"--submit", 0, 0, "", fmt::format("Slurm refuses {}: {}", script.string(), words)}});
    }
    // Warnings may stand before it; of several clusters their name behind it.
    std::string job;
    for (std::size_t begin = 0; begin < said.size();) {
        const std::size_t end = std::min(said.find('\n', begin), said.size());
        if (said[begin] >= '0' && said[begin] <= '9') job = said.substr(begin, end - begin);
        begin = end + 1;
    }
    return job.substr(0, job.find(';'));
}

}  // namespace

int campaignSlurm(const CampaignSlurmOptions& options) {
    const campaign::Plan plan = readCampaign(options.file, options.settings);
    const Path folder = std::filesystem::absolute(resultFolder(options.file, options.output)).lexically_normal();
    beginCampaign(plan, folder, false);
    const campaign::Probe found = probed(plan, folder);
    const double seconds = found.seconds_per_run * static_cast<double>(plan.runs);
    const auto wanted = static_cast<std::uint64_t>(std::ceil(seconds / (kTaskSeconds * options.cpus)));
    const std::uint64_t most = std::min(plan.pieces(), options.tasks > 0 ? UINT64_MAX : kMostTasks);
    const std::uint64_t tasks =
        std::clamp<std::uint64_t>(options.tasks > 0 ? static_cast<std::uint64_t>(options.tasks) : wanted, 1, most);

    const Path slurm = folder / "slurm";
    makeFolder(slurm);
    std::error_code error;
    const std::string program = std::filesystem::read_symlink("/proc/self/exe", error).string();
    const std::string call = fmt::format("{} campaign {} --threads {}", quoted(error ? "tread" : program),
                                         quoted(folder.string()), options.cpus);
    const std::string name = "tread-" + folder.filename().string();
    const Path array = slurm / "array.sh", join = slurm / "merge.sh";
    writeFile(array, scriptOf(options, name, slurm / "%a.log", fmt::format("#SBATCH --array=1-{}\n", tasks),
                              fmt::format("{} --quiet --shard \"$SLURM_ARRAY_TASK_ID\"/{}", call, tasks)));
    // It also computes what a task has left behind that could not be started again.
    writeFile(join, scriptOf(options, name + "-merge", slurm / "merge.log", "", call));

    std::string array_job, join_job;
    if (options.submit) {
        array_job = submitted(array, "");
        join_job = submitted(join, "--dependency=afterany:" + array_job);
    }
    const std::string answer = options.submit ? fmt::format("submitted {} in job {}, the merge in job {}",
                                                            counted(tasks, "task"), array_job, join_job)
                                              : fmt::format("scripts for {} written", counted(tasks, "task"));
    if (options.json) {
        printJson({{"answer", answer},
                   {"tasks", tasks},
                   {"runs", plan.runs},
                   {"seconds_of_a_task", seconds / static_cast<double>(tasks) / options.cpus},
                   {"array_job", array_job},
                   {"merge_job", join_job},
                   {"array_script", array.string()},
                   {"merge_script", join.string()}});
    } else {
        say(fmt::format("{}\n  {}, about {} a task\n  {}\n", answer, counted(plan.runs, "run"),
                        timeText(seconds / static_cast<double>(tasks) / options.cpus),
                        options.submit ? "`tread campaign status " + folder.string() + "` tells how far they are"
                                       : fmt::format("job=$(sbatch --parsable {}) && sbatch "
                                                     "--dependency=afterany:$job {}",
                                                     quoted(array.string()), quoted(join.string()))));
    }
    return kYes;
}

}  // namespace tread::program
