// The commands on campaigns.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "commands.h"

namespace tread::program {

struct CampaignOptions {
    std::string file;                   // campaign, or folder of its results
    std::string output;                 // folder; empty: out/<campaign>
    std::vector<std::string> settings;  // path=value, of the campaign's file
    int threads = 0;                    // 0: one per core
    std::string shard;                  // "i/N"; empty: all
    std::optional<std::uint64_t> run;   // this run alone, with log and page
    bool dry_run = false;
    bool json = false;
};
int campaign(const CampaignOptions& options);

struct CampaignMergeOptions {
    std::vector<std::string> folders;
    std::string output;  // folder; empty: the first of them
    bool partial = false;
    bool json = false;
};
int campaignMerge(const CampaignMergeOptions& options);

struct CampaignStatusOptions {
    std::string folder;
    bool json = false;
};
int campaignStatus(const CampaignStatusOptions& options);

struct CampaignSlurmOptions {
    std::string file;
    std::string output;
    std::vector<std::string> settings;
    int tasks = 0;          // 0: so that each takes some minutes
    int cpus = 1;           // of a task
    std::string partition;  // empty: the cluster's default
    std::string time;       // limit of a task; empty: the cluster's default
    bool submit = false;
    bool json = false;
};
int campaignSlurm(const CampaignSlurmOptions& options);

struct LogOptions {
    std::string log;
    std::string output;  // CSV, or MCAP by its name; empty: beside the log
    bool mcap = false;
};
int convertLog(const LogOptions& options);

}  // namespace tread::program
