#include "command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "base/text/number_text.h"
#include "campaign.h"
#include "command_guide.h"
#include "commands.h"
#include "describable.h"
#include "output.h"
#include "output_folder.h"

namespace tread::program {
namespace {

// What the value names is told in the help, and completed by the shells.
template <class T>
CLI::Option* addFile(CLI::App& app, const std::string& name, T& value, const std::string& meaning) {
    return app.add_option(name, value, meaning)->type_name("FILE");
}
template <class T>
CLI::Option* addFolder(CLI::App& app, const std::string& name, T& value, const std::string& meaning) {
    return app.add_option(name, value, meaning)->type_name("FOLDER");
}

// A word that may be one of these; what it may be besides is said by the command.
template <class T>
CLI::Option* addName(CLI::App& app, const std::string& name, T& value, const std::string& meaning,
                     const std::vector<std::string_view>& names) {
    const std::string choices = fmt::format("NAME:{{{}}}", fmt::join(names, ","));
    return app.add_option(name, value, meaning)->type_name(choices);
}

void addSettings(CLI::App& app, std::vector<std::string>& settings, const std::string& meaning) {
    // One value each; otherwise files that follow would be read as settings.
    app.add_option("--set", settings, meaning)->allow_extra_args(false)->type_name("PATH=VALUE");
}

void addRun(CLI::App& app, RunOptions& o) {
    addFile(app, "vehicle", o.vehicle, "vehicle file (YAML), or the name of a shipped one: compact")->required();
    CLI::Option* scenario =
        addFile(app, "scenario", o.scenario, "scenario file (YAML), or the name of a shipped one: step_steer_80");
    addFolder(app, "--all", o.all, "folder: drive all its scenarios, with one page that links the reports")
        ->excludes(scenario);
    addFile(app, "--log", o.log, "log of the drive that the scenario repeats (CSV)");
    addFolder(app, "-o,--output", o.output, "folder for log, metrics and report (default: out/<scenario>, or out)");
    addSettings(app, o.settings, "path=value, for example front.suspension.spring=\"25 kN/m\" or scenario.step=0.002");
    addFile(app, "--accept", o.accept, "conditions on metrics (YAML), in addition to those of the scenario");
    addFile(app, "--metrics", o.metrics, "metrics of your own (YAML), in addition to those of the scenario");
    addFile(app, "--junit", o.junit, "write the verdicts as JUnit XML to this file");
    app.add_flag("--strict", o.strict, "treat an implausible number as an error (exit code 2), not a warning");
    app.add_flag("--json", o.json, "print the result as JSON");
}

void addCompare(CLI::App& app, CompareOptions& o) {
    addFile(app, "reference", o.reference, "log to compare with (CSV), or folder of runs")->required();
    addFile(app, "new", o.candidate, "log to judge (CSV), or folder of runs")->required();
    addFile(app, "--tolerances", o.tolerances, "tolerances per channel and metric (YAML)");
    addFile(app, "--report", o.report,
            "write an overlay report (HTML) with a replay of all cars; for folders, a summary");
    addFile(app, "--envelope", o.envelope,
            "iso19364: do measurements (reference) lie within the boundaries around a simulation (new)? Or a file");
    addFile(app, "--score", o.score, "iso18571: how well do the curves agree? Or a file");
    addFile(app, "--repeat", o.repeats,
            "further log: another measurement for --envelope and --score, drawn but not judged in --report");
    addFile(app, "--junit", o.junit, "for folders: write the verdicts as JUnit XML to this file");
    app.add_flag("--update", o.update, "for folders: after the comparison, copy the new runs over the reference");
    app.add_flag("--json", o.json, "print the result as JSON");
}

void addMetrics(CLI::App& app, MetricsOptions& o) {
    addFile(app, "log", o.log, "log (CSV)")->required();
    app.add_option("--manoeuvre", o.manoeuvre, "name of the manoeuvre (default: found from the log)");
    addFile(app, "--scenario", o.scenario, "scenario file that was driven: its course, phases and own metrics");
    addFile(app, "--vehicle", o.vehicle, "vehicle file that was driven: its numbers for own metrics");
    addFile(app, "--metrics", o.metrics, "metrics of your own (YAML)");
    addFile(app, "--accept", o.accept, "conditions on the metrics (YAML); exit code 1 when one is not met");
    app.add_flag("--json", o.json, "print the result as JSON");
}

void addImport(CLI::App& app, ImportOptions& o) {
    addFile(app, "file", o.file, "foreign log (.vbo, .mat, .mcap, text table) or tyre property file (.tir)")
        ->required();
    addFile(app, "--map", o.map, "mapping from its columns to channels (YAML; default: guessed from the names)");
    addFile(app, "--init", o.init, "write the guessed mapping to this file, to be edited, and no log");
    addFile(app, "-o,--output", o.output,
            "log or tyre file to write (default: <file>.tread.csv or .tread.yaml beside the file)");
    app.add_flag("--json", o.json, "print the result as JSON");
}

void addTyre(CLI::App& app, TyreOptions& o) {
    addFile(app, "tyre", o.tyre, "tyre file (YAML or .tir)")->required();
    app.add_option("--axes", o.axes, "axes of the table: paper (y right, z down) or iso (ISO 8855: y left, z up)")
        ->check(CLI::IsMember({"paper", "iso"}));
    addFile(app, "--table", o.table,
            "steady state at the points of this table (CSV); its lambda_* columns replace the tyre file's factors, "
            "they do not multiply them");
    addFile(app, "--transient", o.transient, "contact-patch transients under the motion of this table (CSV)");
    addFile(app, "-o,--output", o.output, "table to write (default: standard output)");
    addFile(app, "--plot", o.plot, "page of curves to write (HTML)");
    app.add_option("--substeps", o.substeps, "integration steps per sample")->check(CLI::Range(1, 10000));
    app.add_option("--interpolate", o.interpolate, "motion between samples: hold or linear")
        ->check(CLI::IsMember({"hold", "linear"}));
    app.add_flag("--standstill", o.standstill,
                 "with the standstill extension that the car uses (default: the model of the paper alone)");
    addSettings(app, o.settings, "path=value, for example lambda.mux=0.8");
    app.add_flag("--json", o.json, "print the result as JSON");
}

void addShard(CLI::App& app, std::string& shard, const std::string& what) {
    app.add_option("--shard", shard, "i/N: only this part of the " + what + ", with i from 1 to N");
}

void addDiagnose(CLI::App& app, DiagnoseRequest& o) {
    addFile(app, "file", o.file, "diagnosis.yaml: nominal car, recordings, tolerances");
    app.add_flag("--check", o.check,
                 "only check the recordings and list the effects that they could show; status 1 if there are warnings");
    app.add_flag("--strict", o.strict, "treat an implausible number as an error (exit code 2), not a warning");
    addFolder(app, "--init", o.init, "write a diagnosis.yaml for the logs in this folder");
    addFile(app, "--vehicle", o.vehicle,
            "nominal car (YAML): for --init, or instead of the vehicle and vehicle_settings of the file");
    addFolder(app, "--data", o.data, "folder of the logs (default: folder of the file)");
    addFolder(app, "--all", o.all,
              "diagnose every diagnosis.yaml in the folders of this folder; one table over all; an interrupted call "
              "goes on");
    addShard(app, o.shard, "diagnoses of --all");
    addFolder(app, "-o,--output", o.output, "folder for results and simulated drives (default: out)");
    app.add_option("--threads", o.threads, "threads (default: one per core)")->check(CLI::Range(0, 1000));
    app.add_flag("--json", o.json, "print the result as JSON");
}

void addIdentify(CLI::App& app, IdentifyRequest& o) {
    addFile(app, "file", o.file, "diagnosis.yaml, as for tread diagnose: nominal car, recordings, tolerances")
        ->required();
    app.add_option("--fit", o.fit, "paths of the numbers to fit; * matches any characters (default: fit in the file)")
        ->delimiter(',');
    app.add_option("--without", o.without,
                   "recordings to hold out, by name or log: not fitted, but the gap is judged in them");
    addFile(app, "--vehicle", o.vehicle, "nominal car (YAML) instead of the vehicle and vehicle_settings of the file");
    addFolder(app, "--data", o.data, "folder of the logs (default: folder of the file)");
    addFolder(app, "-o,--output", o.output, "folder for calibrated.yaml, identify.json and the report (default: out)");
    app.add_option("--threads", o.threads, "threads (default: one per core)")->check(CLI::Range(0, 1000));
    app.add_flag("--json", o.json, "print the result as JSON");
}

void addDescribe(CLI::App& app, DescribeOptions& o) {
    addName(app, "what", o.what, "whose fields; or a vehicle file, or the name of a shipped one: its data sheet",
            describableNames(false))
        ->required();
    app.add_option("path", o.path, "path of one field, for example phases.0: only this field and what it contains");
    addFile(app, "--report", o.report, "page of the data sheet to write (HTML)");
    addSettings(app, o.settings, "path=value, for example load.mass=200: the car of the data sheet");
    app.add_flag("--json", o.json, "print the result as JSON");
}

void addCheck(CLI::App& app, CheckOptions& o) {
    addFile(app, "files", o.files, "YAML, .tir or CSV files")->required();
    app.add_flag("--strict", o.strict, "treat an implausible number as an error (exit code 2), not a warning");
    app.add_flag("--json", o.json, "print the result as JSON");
}

void addSchema(CLI::App& app, SchemaOptions& o) {
    addName(app, "what", o.what, "kind of file", describableNames(true))->required();
    addFile(app, "-o,--output", o.output, "file to write (default: standard output)");
}

void addFmu(CLI::App& app, FmuOptions& o) {
    addFile(app, "vehicle", o.vehicle, "vehicle file (YAML), or the name of a shipped one: compact")->required();
    addFile(app, "-o,--output", o.output, "FMU to write (default: <vehicle>.fmu in the current folder)");
    app.add_option("--fmi", o.fmi, "version of FMI: 2 or 3 (default: 2)")->check(CLI::IsMember({2, 3}));
    addSettings(app, o.settings, "path=value, for example mass=\"1.4 t\": start value of a parameter");
}

void addBlindMake(CLI::App& app, BlindMakeOptions& o) {
    app.add_option("--cases", o.cases, "number of cases")->required()->check(CLI::Range(1, 999));
    app.add_option("--seed", o.seed, "seed of the random numbers; each seed gives different cases")->required();
    addFolder(app, "-o,--output", o.output, "folder for the cases, must be new or empty")->required();
    addFile(app, "--key", o.key, "file for the sealed key (default: <folder>.key.json)");
    addFile(app, "--vehicle", o.vehicle, "nominal car (default: vehicles/compact.yaml)");
    app.add_option("--kinds", o.kinds, "kinds of cases: one, two, none, outside, mixed, small (default: all)")
        ->delimiter(',');
    app.add_option("--drives", o.drives,
                   "drives used for fitting: all, step_steers (two) or coast_and_accelerate (two) (default: all)");
    app.add_option(
        "--world", o.world,
        "source of model errors, disturbances and noise: own (independent of the diagnosis) or assumed (as the "
        "diagnosis assumes them, for comparison) (default: own)");
    app.add_flag("--frozen", o.frozen,
                 "draw faults outside the catalogue from both families; for a final check of a frozen program");
    app.add_flag("--json", o.json, "print the result as JSON");
}

void addBlindScore(CLI::App& app, BlindScoreOptions& o) {
    addFolder(app, "cases", o.cases, "folder of the cases")->required();
    addFile(app, "key", o.key, "sealed key (JSON), opened after all cases are diagnosed")->required();
    addFolder(app, "-o,--output", o.output,
              "folder for answers, score.json and report.html; an interrupted run is resumed")
        ->required();
    app.add_option("--jobs", o.jobs, "number of cases in parallel (default: one per core)")->check(CLI::Range(1, 256));
    addShard(app, o.shard, "cases");
    app.add_flag("--no-references", o.no_references,
                 "diagnose the cases without their references; results are written to without_references in "
                 "the output folder");
    app.add_flag("--json", o.json, "print the result as JSON");
}

void addCampaign(CLI::App& app, CampaignOptions& o) {
    addFile(app, "file", o.file, "campaign (YAML), or the folder of its results to go on with");
    addFolder(app, "-o,--output", o.output,
              "folder for the results (default: out/<campaign>); a second call goes on where the first stopped");
    addSettings(app, o.settings, "path=value in the campaign's file, for example samples=20");
    app.add_option("--threads", o.threads, "threads (default: one per core)")->check(CLI::Range(0, 1000));
    app.add_flag("--dry-run", o.dry_run, "only tell how many runs, how long and how much disk");
    addShard(app, o.shard, "runs");
    app.add_option("--run", o.run, "this run alone, with its log and page");
    app.add_flag("--json", o.json, "print the result as JSON");
}

void addCampaignMerge(CLI::App& app, CampaignMergeOptions& o) {
    addFolder(app, "folders", o.folders, "folders with parts of one campaign")->required();
    addFolder(app, "-o,--output", o.output, "folder for the result (default: the first of them)");
    app.add_flag("--partial", o.partial, "also when runs are missing: the table then lacks them");
    app.add_flag("--json", o.json, "print the result as JSON");
}

void addCampaignStatus(CLI::App& app, CampaignStatusOptions& o) {
    addFolder(app, "folder", o.folder, "folder of the results")->required();
    app.add_flag("--json", o.json, "print the result as JSON");
}

void addCampaignSlurm(CLI::App& app, CampaignSlurmOptions& o) {
    addFile(app, "file", o.file, "campaign (YAML), or the folder of its results to go on with")->required();
    addFolder(app, "-o,--output", o.output, "folder for the results, on a file system that all nodes share");
    addSettings(app, o.settings, "path=value in the campaign's file");
    app.add_option("--tasks", o.tasks, "tasks of the array (default: so many that each takes some minutes)")
        ->check(CLI::Range(1, 100000));
    app.add_option("--cpus", o.cpus, "cores of a task (default: 1)")->check(CLI::Range(1, 1000));
    app.add_option("--partition", o.partition, "partition (default: that of the cluster)");
    app.add_option("--time", o.time, "time limit of a task, as sbatch reads it (default: that of the cluster)");
    app.add_flag("--submit", o.submit, "submit the jobs; otherwise only their scripts are written");
    app.add_flag("--json", o.json, "print the result as JSON");
}

void addLog(CLI::App& app, LogOptions& o) {
    addFile(app, "log", o.log, "log of a run of a campaign (.tlog), or any log")->required();
    addFile(app, "-o,--output", o.output, "log to write (CSV, or MCAP when named .mcap; default: beside it)");
    app.add_flag("--mcap", o.mcap, "write MCAP, for Foxglove and PlotJuggler");
}

template <class Options>
void addCommand(CLI::App& app, const std::string& name, const std::string& meaning,
                void (*add_options)(CLI::App&, Options&), int (*run_command)(const Options&), int& status) {
    CLI::App* const command = app.add_subcommand(name, meaning);
    const auto options = std::make_shared<Options>();
    add_options(*command, *options);
    command->callback([=, &status] {
        if (command->get_subcommands().empty()) status = run_command(*options);  // else that one has run
    });
    command->fallthrough();  // --quiet may stand behind the command
}

void addGuides(CLI::App& app) {
    CLI::App* const man = app.add_subcommand("man", "the manual, for man: tread man | man -l -");
    man->callback([&app] { print(manPage(app)); });
    CLI::App* const complete = app.add_subcommand("completions", "completions of commands and options for a shell");
    const auto shell = std::make_shared<std::string>();
    complete->add_option("shell", *shell, "bash, zsh or fish")
        ->required()
        ->check(CLI::IsMember({"bash", "zsh", "fish"}));
    complete->callback([&app, shell] { print(completions(app, *shell)); });
}

}  // namespace

void addCommands(CLI::App& app, int& status) {
    app.add_flag_callback("-q,--quiet", beQuiet, "print errors only: no answers, warnings or progress");
    app.add_flag_callback("--wait", waitForFolders, "wait while another call of tread writes into the same folder");
    addCommand(app, "run",
               "drive a manoeuvre and write log, metrics and report; status 1 when a metric is not accepted", addRun,
               run, status);
    addCommand(app, "compare", "compare two logs, or two folders of runs; status 1 when they differ", addCompare,
               compare, status);
    addCommand(app, "metrics", "compute the metrics of the standards from a log", addMetrics, metrics, status);
    addCommand(app, "import", "convert a VBOX, MATLAB, MCAP or text file into a log, or a .tir file into a tyre file",
               addImport, import, status);
    addCommand(app, "tyre", "forces of a tyre at given points, transients, curves", addTyre, tyre, status);
    addCommand(
        app, "diagnose",
        "find where a car and its model differ, which effect causes the gap, and how much of it the effect closes",
        addDiagnose, diagnose, status);
    addCommand(app, "identify",
               "fit numbers of a car to recordings (or to their references, if any) and write the calibrated car",
               addIdentify, identify, status);
    CLI::App* const blind = app.add_subcommand("blind", "test the diagnosis with cars whose faults are sealed");
    blind->require_subcommand(1);
    blind->fallthrough();
    addCommand(*blind, "make", "make cases: logs of cars with sealed faults, and the key", addBlindMake, blindMake,
               status);
    addCommand(*blind, "score", "diagnose the cases, open the key and score the answers", addBlindScore, blindScore,
               status);
    addCommand(app, "campaign",
               "drive thousands of runs on all cores: cars x scenarios x factors, into one table; goes on after any "
               "interruption",
               addCampaign, campaign, status);
    CLI::App* const campaigns = app.get_subcommand("campaign");
    addCommand(*campaigns, "merge", "join the parts of a campaign into one result", addCampaignMerge, campaignMerge,
               status);
    addCommand(*campaigns, "status", "what is done, failed, running and missing; status 1 while runs are missing",
               addCampaignStatus, campaignStatus, status);
    addCommand(*campaigns, "slurm", "write, or submit, a Slurm array of tasks and the job that joins them",
               addCampaignSlurm, campaignSlurm, status);
    addCommand(app, "fmu", "write a car as an FMU for co-simulation, which other simulators import", addFmu, fmu,
               status);
    addCommand(app, "log", "convert the log of a run of a campaign to CSV, or any log to MCAP", addLog, convertLog,
               status);
    addCommand(app, "describe", "all fields with units, meaning, limits and defaults; or the data sheet of a car",
               addDescribe, describe, status);
    addCommand(app, "check",
               "check files: vehicles, tyres, scenarios, mappings, tolerances, logs; status 2 when one has faults",
               addCheck, check, status);
    addCommand(app, "schema", "JSON Schema of a file, for editors", addSchema, schema, status);
    addGuides(app);
}

}  // namespace tread::program
