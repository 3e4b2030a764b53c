// The task of a campaign: which cars, in which scenarios, with which numbers varied and how.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenario/accept.h"
#include "store/named_file.h"
#include "tread/describe.h"

namespace tread::campaign {

// How the samples of the drawn factors are placed.
enum class Sampling { random, latin_hypercube, sobol, sobol_indices };
constexpr auto enumNames(Sampling) {
    return std::array<std::string_view, 4>{"random", "latin_hypercube", "sobol", "sobol_indices"};
}

// Restricts a factor to some of the cars or scenarios; elsewhere it is not touched.
struct When {
    std::vector<std::string> vehicles = {};
    std::vector<std::string> scenarios = {};

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(vehicles), About{"", "names of the vehicles' files without .yaml; none: all"});
        field(TREAD_FIELD(scenarios), About{"", "names of the scenarios' files without .yaml; none: all"});
    }
};
static_assert(describesEveryMember<When>());

struct Grid {
    std::string from;
    std::string to;
    int count = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(from), About{"", "first value, with its unit"});
        field(TREAD_FIELD(to), About{"", "last value, with its unit"});
        field(TREAD_FIELD(count), About{"", "number of values, in equal steps", {2, 1'000'000}});
    }

    static void check(const auto& self, auto&& complain) {
        if (self.count == 0) complain("count", "found no number of values, expected at least 2");
    }
};
static_assert(describesEveryMember<Grid>());

struct Uniform {
    std::string from;
    std::string to;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(from), About{"", "least value, with its unit"});
        field(TREAD_FIELD(to), About{"", "largest value, with its unit"});
    }
};
static_assert(describesEveryMember<Uniform>());

struct Normal {
    std::string mean;
    std::string sd;
    std::string lowest = {};
    std::string highest = {};

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(mean), About{"", "mean, with its unit"});
        field(TREAD_FIELD(sd), About{"", "standard deviation, with its unit"});
        field(TREAD_FIELD(lowest), About{"", "the distribution is cut off below this; empty: it is not"});
        field(TREAD_FIELD(highest), About{"", "the distribution is cut off above this; empty: it is not"});
    }
};
static_assert(describesEveryMember<Normal>());

// A field of car or scenario that differs from run to run.
struct Factor {
    std::string path;
    std::vector<std::string> also = {};
    bool relative = false;
    std::vector<std::string> list = {};
    std::optional<Grid> grid = {};
    std::optional<Uniform> uniform = {};
    std::optional<Normal> normal = {};
    When when = {};

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(path),
              About{"", "path of a field, as for --set: load.mass, front.tyre.lambda.mux, scenario.start.speed"});
        field(TREAD_FIELD(also), About{"", "further fields that get the same value"});
        field(TREAD_FIELD(relative), About{"", "true: the values are multiples of what car and scenario say"});
        field(TREAD_FIELD(list), About{"", "values, each combined with all others; numbers, words or true and false"});
        field(TREAD_FIELD(grid), About{"", "values in equal steps, each combined with all others"});
        field(TREAD_FIELD(uniform), About{"", "drawn, evenly distributed"});
        field(TREAD_FIELD(normal), About{"", "drawn, normally distributed"});
        field(TREAD_FIELD(when), About{"", "only for these vehicles and scenarios"});
    }
    static void check(const auto& self, auto&& complain) {
        if (self.path.empty()) complain("path", "found no path, expected the path of a field, such as load.mass");
        const int given =
            !self.list.empty() + self.grid.has_value() + self.uniform.has_value() + self.normal.has_value();
        if (given != 1) {
            complain("path", given == 0 ? "found no values, expected one of list (with at least one value), grid, "
                                          "uniform, normal"
                                        : "found several kinds of values, expected one of list, grid, uniform, normal");
        }
    }
};
static_assert(describesEveryMember<Factor>());

// Numbers that are drawn together from one normal distribution.
struct Correlated {
    std::vector<std::string> paths = {};
    std::vector<double> mean = {};
    std::vector<std::vector<double>> covariance = {};
    std::string identified = {};
    When when = {};

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(paths), About{"", "paths of the numbers"});
        field(TREAD_FIELD(mean), About{"", "their means, in SI units; none: what car and scenario say"});
        field(TREAD_FIELD(covariance), About{"", "their covariance, row by row, in SI units"});
        field(TREAD_FIELD(identified),
              About{"",
                    "in place of these: identify.json of `tread identify`, relative to this file; its fitted numbers, "
                    "standard errors and correlation"});
        field(TREAD_FIELD(when), About{"", "only for these vehicles and scenarios"});
    }
    static void check(const auto& self, auto&& complain) {
        if (!self.identified.empty()) {
            if (!self.paths.empty() || !self.mean.empty() || !self.covariance.empty())
                complain("identified", "found paths, mean or covariance beside it, expected one or the other");
            return;
        }
        if (self.paths.empty()) return complain("paths", "found no paths, expected at least one");
        if (!self.mean.empty() && self.mean.size() != self.paths.size())
            complain("mean", "found another number of means than of paths, expected one for each");
        bool square = self.covariance.size() == self.paths.size();
        for (const auto& row : self.covariance) square = square && row.size() == self.paths.size();
        if (!square) complain("covariance", "found another size, expected one row and one column for each path");
    }
};
static_assert(describesEveryMember<Correlated>());

struct CampaignFile {
    std::string title;
    std::string description = {};
    std::vector<std::string> vehicles;
    std::vector<std::string> scenarios;
    std::vector<std::string> settings = {};
    std::vector<Factor> factors = {};
    std::vector<Correlated> correlated = {};
    Sampling sampling = Sampling::latin_hypercube;
    int samples = 1;
    int repetitions = 1;
    int seed = 1;
    Acceptance accept = {};
    bool logs = false;
    int runs_per_piece = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(title), About{"", "what the campaign is, in a few words"});
        field(TREAD_FIELD(description), About{"", "what it is after, and where its numbers come from"});
        field(TREAD_FIELD(vehicles),
              About{"", "vehicle files, relative to this file, or names of shipped ones, such as compact"});
        field(TREAD_FIELD(scenarios),
              About{"", "scenario files, relative to this file, or names of shipped ones; each car drives each"});
        field(TREAD_FIELD(settings), About{"", "changes for all runs, each path=value, as for --set"});
        field(TREAD_FIELD(factors), About{"", "what differs from run to run"});
        field(TREAD_FIELD(correlated), About{"", "numbers that are drawn together"});
        field(TREAD_FIELD(sampling),
              About{"",
                    "how the drawn factors are sampled; sobol_indices: a design for Sobol indices, which takes (number "
                    "of drawn factors + 2) runs for each sample"});
        field(TREAD_FIELD(samples),
              About{"", "samples of the drawn factors, for each combination of the listed ones", {1, 100'000'000}});
        field(TREAD_FIELD(repetitions),
              About{"", "runs of each point, each with other seeds of road, wind and sensors", {1, 1'000'000}});
        field(TREAD_FIELD(seed), About{"", "seed of all that is drawn", {0, 2147483647}});
        field(TREAD_FIELD(accept),
              About{"", "what the metrics must be, beside the conditions of the scenarios; see tread describe accept"});
        field(TREAD_FIELD(logs), About{"", "keep the log of every run: logs/<run>.tlog, which `tread log` converts"});
        field(TREAD_FIELD(runs_per_piece),
              About{"", "runs that are computed and kept together; 0: about a minute of work", {0, 1'000'000}});
    }
    static void check(const auto& self, auto&& complain) {
        if (self.vehicles.empty()) complain("vehicles", "found no vehicle, expected at least one file");
        if (self.scenarios.empty()) complain("scenarios", "found no scenario, expected at least one file");
    }
};
static_assert(describesEveryMember<CampaignFile>());

// Throws LoadError. File names are resolved relative to the folder of the file, those of shipped files if told how.
CampaignFile loadCampaign(const std::filesystem::path& file, const std::vector<std::string>& settings = {},
                          const ShippedFiles& shipped = {});

}  // namespace tread::campaign
