#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/fields/possible.h"
#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "base/units/units.h"
#include "base/yaml/position.h"
#include "base/yaml/session.h"
#include "base/yaml/write.h"
#include "campaign/correlated.h"
#include "campaign/plan.h"
#include "metrics/channels.h"
#include "scenario/load.h"
#include "store/sha256.h"
#include "tread/problem.h"

namespace tread::campaign {
namespace {

constexpr double kMostRuns = 1e9;
constexpr double kRealTimeFactor = 350;  // of a run with steps of 1 ms on one core, as tests/README.md reports it
constexpr double kPieceSeconds = 60;     // of work at most lost when a machine dies
constexpr double kLeastPieceSeconds = 1;
constexpr double kPiecesWanted = 64;  // so that threads and shards find work until the end

class Builder {
public:
    Builder(Plan& plan, const std::string& file) : plan_(plan), file_(file) {}

    void build(const std::vector<std::vector<MetricDefinition>>& definitions) {
        cells();
        for (std::size_t i = 0; i < campaign().factors.size(); ++i) factor(i);
        for (std::size_t i = 0; i < campaign().correlated.size(); ++i) correlated(i);
        stop();
        assign();
        design();
        stop();
        count();
        columns(definitions);
        stop();
    }

private:
    Plan& plan_;
    const std::string& file_;
    std::vector<Problem> problems_;
    std::size_t dimensions_ = 0;

    const CampaignFile& campaign() const { return plan_.inputs.campaign; }

    void complain(const std::string& path, const std::string& text) {
        const TextPosition position = positionOfValue(file_, path);
        problems_.push_back({file_, position.line, position.column, path, text});
    }
    void stop() {
        if (!problems_.empty()) throwIfAny(std::move(problems_));
    }

    // Each car in each scenario, with what the scenario changes on it.
    void cells() {
        for (std::size_t v = 0; v < plan_.inputs.vehicles.size(); ++v) {
            for (std::size_t s = 0; s < plan_.inputs.scenarios.size(); ++s) {
                const Scenario& scenario = plan_.inputs.scenarios[s].scenario;
                Cell cell;
                cell.vehicle = v;
                cell.scenario = s;
                cell.nominal = {plan_.inputs.vehicles[v].vehicle, scenario};
                setFields(cell.nominal.vehicle, scenario.car_settings,
                          plan_.inputs.scenarios[s].name + ": car_settings");
                plan_.cells.push_back(std::move(cell));
            }
        }
    }

    void checkNames(const std::vector<std::string>& names, const std::string& path, bool vehicles) {
        std::vector<std::string_view> known;
        if (vehicles) {
            for (const NamedVehicle& one : plan_.inputs.vehicles) known.push_back(one.name);
        } else {
            for (const NamedScenario& one : plan_.inputs.scenarios) known.push_back(one.name);
        }
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (std::find(known.begin(), known.end(), names[i]) != known.end()) continue;
            complain(path + "." + std::to_string(i),
                     "found " + quote(names[i]) + ", expected " + listed(known) + didYouMean(names[i], known));
        }
    }

    bool applies(const When& when, const Cell& cell) const {
        const auto has = [](const std::vector<std::string>& names, const std::string& name) {
            return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
        };
        return has(when.vehicles, plan_.vehicleOf(cell)) && has(when.scenarios, plan_.scenarioOf(cell));
    }

    // A value with its unit; a faulty one is not a number.
    double number(const Variable& variable, const std::string& text, const std::string& path) {
        std::string fault;
        const auto value = toSi(text, variable.unit, fault);
        if (!value) complain(path, fault);
        return value.value_or(kUndefined);
    }

    // Every car and scenario to which the variable applies must have its fields. False when one has not.
    bool look(Variable& variable, const std::string& path_of_names) {
        checkNames(variable.when.vehicles, variable.at + ".when.vehicles", true);
        checkNames(variable.when.scenarios, variable.at + ".when.scenarios", false);
        bool found_any = false, all_numbers = true;
        for (Cell& cell : plan_.cells) {
            if (!applies(variable.when, cell)) continue;
            for (const std::string& path : variable.paths) {
                Subject copy = cell.nominal;
                const FieldFound found = fieldAt(copy, path);
                if (!found.exists) {
                    complain(path_of_names,
                             unknownPath(path) + fmt::format(" (asked of {} in {}; `when` restricts a factor to some)",
                                                             plan_.vehicleOf(cell), plan_.scenarioOf(cell)));
                    return false;
                }
                all_numbers = all_numbers && found.is_number;
                if (found_any && found.is_number && found.about.unit != variable.unit && !variable.relative) {
                    complain(path_of_names, fmt::format("found fields in {} and in {}, expected fields of one unit",
                                                        variable.unit, found.about.unit));
                    return false;
                }
                if (!found_any) {
                    variable.unit = variable.relative ? "-" : found.about.unit;
                    variable.meaning = found.about.meaning;
                }
                if (variable.relative && (!found.is_number || std::isnan(found.value))) {
                    complain(path_of_names, quote(path) + " has no number that could be multiplied in " +
                                                plan_.vehicleOf(cell) + ", expected one for relative: true");
                    return false;
                }
                found_any = true;
            }
        }
        if (!found_any && problems_.empty())
            complain(variable.at + ".when",
                     "found no vehicle and scenario to which this applies, expected at least one");
        variable.words = !all_numbers;
        return found_any;
    }

    // Limits of the fields, for a value that is known to occur.
    void checkLimits(const Variable& variable, double value, const std::string& path) {
        if (std::isnan(value)) return;
        for (const Cell& cell : plan_.cells) {
            if (!applies(variable.when, cell)) continue;
            for (const std::string& name : variable.paths) {
                Subject copy = cell.nominal;
                const FieldFound found = fieldAt(copy, name);
                const double actual = variable.relative ? value * found.value : value;
                if (!found.about.limits.allow(actual))
                    return complain(path, fmt::format("{} becomes {}, expected a value {}", name, numberText(actual),
                                                      limitsText(found.about.limits)));
                if (!isPossible(found.about.usual, actual))
                    return complain(path,
                                    name + ": " + impossibleText(actual, "", found.about.unit, found.about.usual));
            }
        }
    }

    void factor(std::size_t index) {
        const Factor& asked = campaign().factors[index];
        Variable variable;
        variable.at = "factors." + std::to_string(index);
        variable.path = asked.path;
        variable.paths = {asked.path};
        variable.paths.insert(variable.paths.end(), asked.also.begin(), asked.also.end());
        variable.relative = asked.relative;
        variable.when = asked.when;
        if (!look(variable, variable.at + ".path")) return;
        const std::string at = variable.at;
        if (variable.words && asked.list.empty()) {
            return complain(at + ".path", "found " + quote(asked.path) +
                                              ", which is no number, expected list: [...] with the values to try");
        }
        const auto limited = [&](const std::string& text, const std::string& path) {
            const double value = number(variable, text, at + path);
            checkLimits(variable, value, at + path);
            return value;
        };
        if (variable.words) {
            variable.texts = asked.list;
            for (std::size_t i = 0; i < asked.list.size(); ++i) word(variable, i);
        } else if (!asked.list.empty()) {
            for (std::size_t i = 0; i < asked.list.size(); ++i)
                variable.numbers.push_back(limited(asked.list[i], ".list." + std::to_string(i)));
        } else if (asked.grid) {
            const double from = limited(asked.grid->from, ".grid.from"), to = limited(asked.grid->to, ".grid.to");
            const int last = asked.grid->count - 1;
            for (int i = 0; i < last; ++i) variable.numbers.push_back(from + (to - from) * i / last);
            variable.numbers.push_back(to);
        } else if (asked.uniform) {
            variable.drawn = true;
            variable.from = limited(asked.uniform->from, ".uniform.from");
            variable.to = limited(asked.uniform->to, ".uniform.to");
            if (variable.to <= variable.from)
                complain(at + ".uniform.to", "found no value above `from`, expected from < to");
        } else {
            normal(variable, *asked.normal);
        }
        if (variable.drawn) variable.dimension = dimensions_++;
        plan_.variables.push_back(std::move(variable));
    }

    void word(Variable& variable, std::size_t i) {
        variable.numbers.push_back(static_cast<double>(i));
        for (const Cell& cell : plan_.cells) {
            if (!applies(variable.when, cell)) continue;
            try {
                Subject copy = cell.nominal;
                for (const std::string& path : variable.paths) {
                    const std::string assignment = path + "=" + variable.texts[i];
                    setFields(copy, std::span(&assignment, 1), file_);
                }
            } catch (const LoadError& error) {
                return complain(variable.at + ".list." + std::to_string(i), error.problems().front().text);
            }
        }
    }

    void normal(Variable& variable, const Normal& asked) {
        const std::string at = variable.at + ".normal";
        variable.drawn = variable.normal = true;
        variable.mean = number(variable, asked.mean, at + ".mean");
        checkLimits(variable, variable.mean, at + ".mean");
        variable.sd = number(variable, asked.sd, at + ".sd");
        if (variable.sd < 0) complain(at + ".sd", "found a negative standard deviation, expected at least 0");
        const auto share = [&](const std::string& text, const std::string& path, double none) {
            if (text.empty()) return none;
            const double value = number(variable, text, at + path);
            checkLimits(variable, value, at + path);
            return variable.sd > 0 ? normalShare((value - variable.mean) / variable.sd) : none;
        };
        variable.lowest_share = share(asked.lowest, ".lowest", 0);
        variable.highest_share = share(asked.highest, ".highest", 1);
        if (!(variable.lowest_share < variable.highest_share))
            complain(at + ".highest",
                     "found nothing left of the distribution, expected lowest < highest near the mean");
    }

    void correlated(std::size_t index) {
        const Correlated& asked = campaign().correlated[index];
        const std::string at = "correlated." + std::to_string(index);
        const JointNormal joint = jointNormal(asked);
        std::string fault;
        Group group{joint.mean, rootOf(joint.covariance, fault), {}};
        if (!fault.empty()) return complain(at + ".covariance", fault);
        if (campaign().sampling == Sampling::sobol_indices) {
            return complain(at,
                            "found correlated numbers with sampling: sobol_indices, whose indices are defined for "
                            "independent factors only; expected another sampling");
        }
        for (std::size_t i = 0; i < joint.paths.size(); ++i) {
            Variable variable;
            variable.at = at;
            variable.path = joint.paths[i];
            variable.paths = {joint.paths[i]};
            variable.when = asked.when;
            if (!look(variable, at + ".paths." + std::to_string(i))) return;
            if (variable.words) {
                return complain(at + ".paths." + std::to_string(i),
                                "found " + quote(variable.path) + ", which is no number, expected a number");
            }
            variable.drawn = true;
            variable.group = plan_.groups.size();
            variable.row = i;
            variable.dimension = dimensions_++;
            group.dimensions.push_back(variable.dimension);
            plan_.variables.push_back(std::move(variable));
        }
        plan_.groups.push_back(std::move(group));
    }

    // Which variables each cell has; none twice.
    void assign() {
        for (Cell& cell : plan_.cells) {
            std::map<std::string, std::string> taken;  // path: who has it
            for (std::size_t i = 0; i < plan_.variables.size(); ++i) {
                const Variable& variable = plan_.variables[i];
                if (!applies(variable.when, cell)) continue;
                (variable.drawn ? cell.drawn : cell.listed).push_back(i);
                for (const std::string& path : variable.paths) {
                    const auto [other, is_new] = taken.emplace(path, variable.at);
                    if (is_new) continue;
                    const std::string text =
                        fmt::format("found {} here and in {}, expected each path in one factor only (of {} in {})",
                                    quote(path), other->second, plan_.vehicleOf(cell), plan_.scenarioOf(cell));
                    if (std::none_of(problems_.begin(), problems_.end(), [&](const Problem& known) {
                            return known.text.substr(0, known.text.find("(of ")) == text.substr(0, text.find("(of "));
                        }))
                        complain(variable.at, text);
                }
            }
        }
    }

    void design() {
        const CampaignFile& file = campaign();
        const bool indices = file.sampling == Sampling::sobol_indices;
        const bool sobol = indices || file.sampling == Sampling::sobol;
        const std::size_t needed = indices ? 2 * dimensions_ : dimensions_;
        if (sobol && needed > kSobolDimensions) {
            complain("sampling", fmt::format("found {} drawn factors, expected at most {} with this sampling",
                                             dimensions_, indices ? kSobolDimensions / 2 : kSobolDimensions));
        }
        if (dimensions_ == 0 && file.samples > 1) {
            complain("samples", fmt::format("found {} samples, but no factor is drawn, expected 1; `repetitions` "
                                            "repeats runs",
                                            file.samples));
        }
        if (indices && dimensions_ > 0 && file.samples < 2)
            complain("samples", "found 1 sample, expected at least 2 for Sobol indices");
        double total = 0;
        for (Cell& cell : plan_.cells) {
            double points = 1;
            for (const std::size_t i : cell.listed) points *= static_cast<double>(plan_.variables[i].numbers.size());
            const double rows = cell.drawn.empty() ? 1 : indices ? static_cast<double>(cell.drawn.size() + 2) : 1.0;
            const double samples = cell.drawn.empty() ? 1 : rows * file.samples;
            total += points * samples * file.repetitions;
            if (total > kMostRuns) break;
            cell.points = static_cast<std::uint64_t>(points);
            cell.samples = static_cast<std::uint64_t>(samples);
        }
        if (total > kMostRuns) {
            complain("samples", fmt::format("found {:.3g} runs in all, expected at most {:.0e}", total, kMostRuns));
        }
        for (const NamedScenario& one : plan_.inputs.scenarios) {
            if (file.repetitions > 1 && seedsIn(one.scenario) == 0) {
                complain("repetitions", fmt::format("found {} repetitions, but nothing in {} is random, expected 1",
                                                    file.repetitions, one.name));
            }
        }
    }

    void count() {
        double seconds = 0;
        for (Cell& cell : plan_.cells) {
            cell.first = plan_.runs;
            cell.runs = cell.points * cell.samples * static_cast<std::uint64_t>(campaign().repetitions);
            plan_.runs += cell.runs;
            const Scenario& scenario = cell.nominal.scenario;
            seconds += static_cast<double>(cell.runs) * std::min(longestDuration(scenario), scenario.time_limit) /
                       kRealTimeFactor * 0.001 / scenario.step;
        }
        plan_.dimensions = dimensions_;
        plan_.draws.emplace_back(campaign().sampling, static_cast<std::uint64_t>(campaign().seed),
                                 static_cast<std::size_t>(campaign().samples), dimensions_);
        const double runs = static_cast<double>(plan_.runs);
        const double per_run = std::max(1e-6, seconds / runs);
        const double wanted = std::clamp(runs / kPiecesWanted, kLeastPieceSeconds / per_run, kPieceSeconds / per_run);
        plan_.runs_per_piece = campaign().runs_per_piece > 0 ? static_cast<std::uint64_t>(campaign().runs_per_piece)
                                                             : static_cast<std::uint64_t>(std::max(1.0, wanted));
    }

    void columns(const std::vector<std::vector<MetricDefinition>>& definitions) {
        for (std::size_t s = 0; s < plan_.inputs.scenarios.size(); ++s) {
            std::vector<std::size_t> own;
            for (const MetricDefinition& one : definitions[s]) {
                const auto known = std::find_if(
                    plan_.metrics.begin(), plan_.metrics.end(),
                    [&](const MetricDefinition& other) { return other.name == one.name && other.unit == one.unit; });
                own.push_back(static_cast<std::size_t>(known - plan_.metrics.begin()));
                if (known == plan_.metrics.end()) plan_.metrics.push_back(one);
            }
            plan_.metrics_of_scenario.push_back(std::move(own));
        }
        // SQLite's own limit is 2000 columns.
        constexpr std::size_t kMostColumns = 1900;
        if (plan_.metrics.size() + plan_.variables.size() > kMostColumns)
            complain("factors", fmt::format("found {} factors and {} metrics, expected at most {} columns",
                                            plan_.variables.size(), plan_.metrics.size(), kMostColumns));
    }
};

}  // namespace

Plan planOf(CampaignInputs inputs, const std::vector<std::vector<MetricDefinition>>& definitions,
            const std::string& file) {
    Plan plan;
    plan.inputs = std::move(inputs);
    Builder(plan, file).build(definitions);
    plan.identity = writeYaml(plan.inputs);
    plan.hash = sha256(plan.identity);
    return plan;
}

}  // namespace tread::campaign
