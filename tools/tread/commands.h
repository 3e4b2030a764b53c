// The commands of the program: options in, exit status out. The answer goes to standard output, its first line in
// words; progress and warnings go to standard error.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tread::program {

using Path = std::filesystem::path;

// Exit status of every command.
inline constexpr int kYes = 0;
inline constexpr int kNo = 1;         // a negative answer: logs differ, a check failed
inline constexpr int kBadInput = 2;   // files or options
inline constexpr int kRunFailed = 3;  // the simulation could not go on

struct RunOptions {
    std::string vehicle;
    std::string scenario;
    std::string all;  // folder of scenarios, in place of one scenario
    std::string log;  // of the drive that the scenario repeats; empty: the scenario names it
    std::string output;
    std::vector<std::string> settings;      // path=value
    std::string settings_source = "--set";  // what messages call them
    std::string accept;                     // file of conditions; empty: those of the scenario alone
    std::string metrics;                    // file of metrics of the user's own; empty: none
    std::string junit;                      // file; empty: none
    bool strict = false;                    // an implausible number is a fault
    bool json = false;
};
int run(const RunOptions& options);

struct CompareOptions {
    std::string reference;             // log, or folder of runs
    std::string candidate;             // the same
    std::string tolerances;            // file; empty: defaults
    std::string report;                // file; empty: none
    std::string envelope;              // iso19364 or file; empty: not judged so
    std::string score;                 // iso18571 or file; empty: not judged so
    std::vector<std::string> repeats;  // further logs: for these two, and in the report
    std::string junit;                 // of folders: file; empty: none
    bool update = false;               // of folders: the candidate becomes the reference
    bool json = false;
};
int compare(const CompareOptions& options);

struct MetricsOptions {
    std::string log;
    std::string manoeuvre;  // empty: detected
    std::string scenario;   // file that was driven; empty: not known
    std::string accept;     // file of conditions; empty: none
    std::string metrics;    // file of metrics of the user's own; empty: none
    std::string vehicle;    // file of the car that was driven; empty: not known
    bool json = false;
};
int metrics(const MetricsOptions& options);

struct ImportOptions {
    std::string file;
    std::string map;     // file; empty: guessed
    std::string init;    // mapping file to write; empty: none
    std::string output;  // log, or tyre file; empty: beside the input, with another extension
    bool json = false;
};
int import(const ImportOptions& options);

struct TyreOptions {
    std::string tyre;
    std::string axes = "iso";
    std::string table;
    std::string transient;
    std::string output;
    std::string plot;
    int substeps = 1;
    std::string interpolate = "hold";
    bool standstill = false;
    std::vector<std::string> settings;
    bool json = false;
};
int tyre(const TyreOptions& options);

struct DiagnoseRequest {
    std::string file;     // diagnosis.yaml
    std::string data;     // folder of its logs; empty: that of the file
    std::string output;   // folder
    std::string init;     // folder of logs for which a first diagnosis.yaml is written; empty: none
    std::string vehicle;  // that it names; without init: nominal car in place of the file's
    std::string all;      // folder of folders with a diagnosis.yaml each; empty: one diagnosis
    std::string shard;    // "i/N": only this part of all; empty: all
    int threads = 0;      // 0: one per core
    bool check = false;   // the data and what they could show, no diagnosis
    bool strict = false;  // an implausible number is a fault
    bool json = false;
};
int diagnose(const DiagnoseRequest& request);

struct IdentifyRequest {
    std::string file;                  // diagnosis.yaml
    std::vector<std::string> fit;      // paths; none: those of the file
    std::vector<std::string> without;  // recordings to hold out, by name or log
    std::string data;                  // folder of its logs; empty: that of the file
    std::string vehicle;               // nominal car in place of the file's; empty: none
    std::string output;                // folder
    int threads = 0;                   // 0: one per core
    bool json = false;
};
int identify(const IdentifyRequest& request);

struct DescribeOptions {
    std::string what;                   // of describables(), or a vehicle file: its data sheet
    std::string path;                   // of one field, in place of all
    std::string report;                 // page of the data sheet to write; empty: none
    std::vector<std::string> settings;  // path=value, of the car
    bool json = false;
};
int describe(const DescribeOptions& options);

struct CheckOptions {
    std::vector<std::string> files;
    bool strict = false;  // an implausible number is a fault
    bool json = false;
};
int check(const CheckOptions& options);

struct SchemaOptions {
    std::string what;    // of describables(), a file
    std::string output;  // file; empty: standard output
};
int schema(const SchemaOptions& options);

struct FmuOptions {
    std::string vehicle;
    std::string output;  // file; empty: name of the vehicle file, in the current folder
    int fmi = 2;
    std::vector<std::string> settings;  // path=value
};
int fmu(const FmuOptions& options);

struct BlindMakeOptions {
    int cases = 0;
    std::uint64_t seed = 0;
    std::string output;
    std::string key;  // file; empty: beside the folder, <folder>.key.json
    std::string vehicle = "vehicles/compact.yaml";
    std::vector<std::string> kinds;  // none: all
    std::string drives = "all";
    std::string world = "own";
    bool frozen = false;
    bool json = false;
};
int blindMake(const BlindMakeOptions& options);

struct BlindScoreOptions {
    std::string cases;  // folder
    std::string key;    // file
    std::string output;
    int jobs = 0;       // cases at a time; 0: one per core
    std::string shard;  // "i/N": only this part of the cases; empty: all
    bool no_references = false;
    bool json = false;
};
int blindScore(const BlindScoreOptions& options);

}  // namespace tread::program
