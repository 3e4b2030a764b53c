// Which run has which car, scenario and numbers: a pure function of the campaign and the number of the run. Any run can
// be made again, and shards need no state.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "campaign/draws.h"
#include "campaign/inputs.h"
#include "campaign/subject.h"
#include "metrics/metric.h"

namespace tread::campaign {

using RunNumber = std::uint64_t;  // from 0

// A field that differs from run to run.
struct Variable {
    std::string path;                // of the first field
    std::vector<std::string> paths;  // of all fields that get the value
    std::string unit;                // SI; of a relative one "-"
    std::string meaning;
    bool relative = false;
    bool drawn = false;                   // otherwise each of its values is combined with those of the others
    bool words = false;                   // values are words, not numbers
    std::vector<double> numbers = {};     // of one that is not drawn: values in SI units, or the index of the word
    std::vector<std::string> texts = {};  // of words
    std::size_t dimension = 0;            // of one that is drawn: in the unit cube
    double from = 0, to = 0;              // evenly distributed between these
    bool normal = false;
    double mean = 0, sd = 0;                     // of a normal one
    double lowest_share = 0, highest_share = 1;  // of the distribution that is not cut off
    std::size_t group = kNoGroup;                // of a correlated one: its group, and which row there
    std::size_t row = 0;
    std::string at;  // path in the campaign's file, for messages
    When when = {};

    static constexpr std::size_t kNoGroup = static_cast<std::size_t>(-1);
    std::string column() const {
        return path + (relative ? " [of nominal]" : " [" + (unit.empty() ? "-" : unit) + "]");
    }
};

// Numbers that are drawn together: value = mean + root times a standard normal vector.
struct Group {
    std::vector<double> mean;
    std::vector<std::vector<double>> root;
    std::vector<std::size_t> dimensions;
};

// One car in one scenario.
struct Cell {
    std::size_t vehicle = 0, scenario = 0;
    Subject nominal;                  // with what the scenario changes on the car
    std::vector<std::size_t> listed;  // variables that are not drawn, the last one changes fastest
    std::vector<std::size_t> drawn;
    std::uint64_t points = 1;   // combinations of the listed values
    std::uint64_t samples = 1;  // rows of the design at each of them
    RunNumber first = 0;
    std::uint64_t runs = 0;
};

struct PlannedRun {
    RunNumber number = 0;
    std::size_t cell = 0;
    std::uint64_t point = 0, sample = 0, repetition = 0;
    std::vector<double> values;  // by variable: in SI units, or the index of the word; NaN where it does not apply
};

struct Plan {
    CampaignInputs inputs;
    std::string identity;  // text of the inputs, which the result folder keeps
    std::string hash;      // SHA-256 of it
    std::vector<Variable> variables;
    std::vector<Group> groups;
    std::vector<Cell> cells;
    std::vector<MetricDefinition> metrics;  // columns: those of all manoeuvres, each name and unit once
    std::vector<std::vector<std::size_t>> metrics_of_scenario;  // which of them a scenario has
    std::uint64_t runs = 0;
    std::uint64_t runs_per_piece = 1;
    std::size_t dimensions = 0;  // of the drawn variables
    std::vector<Draws> draws;    // one

    std::uint64_t pieces() const { return (runs + runs_per_piece - 1) / runs_per_piece; }
    RunNumber firstOf(std::uint64_t piece) const { return piece * runs_per_piece; }
    std::uint64_t countOf(std::uint64_t piece) const;
    const std::string& vehicleOf(const Cell& cell) const { return inputs.vehicles[cell.vehicle].name; }
    const std::string& scenarioOf(const Cell& cell) const { return inputs.scenarios[cell.scenario].name; }
};

// `definitions`: the metrics that each scenario has. `file`: the campaign's, for messages. Throws LoadError with every
// fault.
Plan planOf(CampaignInputs inputs, const std::vector<std::vector<MetricDefinition>>& definitions,
            const std::string& file);

PlannedRun plannedRun(const Plan& plan, RunNumber number);

// Car and scenario of a run. Throws LoadError when a number is beyond its limits or contradicts another.
Subject subjectOf(const Plan& plan, const PlannedRun& run);

// Value of a drawn variable at a share of its own distribution, above 0 and below 1.
double valueOfShare(const Plan& plan, const Cell& cell, const Variable& variable, double share);

// A value as a table shows it: the number in SI units, or the word; empty where the variable does not apply.
std::string valueText(const Variable& variable, double value);

}  // namespace tread::campaign
