#include "campaign/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/did_you_mean.h"
#include "base/field_path.h"
#include "base/number_text.h"
#include "base/setting.h"
#include "base/units.h"
#include "base/write_yaml.h"
#include "base/yaml_position.h"
#include "campaign/correlated.h"
#include "scenario/load.h"
#include "store/sha256.h"
#include "tread/problem.h"

namespace tread::campaign {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kMostRuns = 1e9;
constexpr double kRealTimeFactor = 350;  // of a run with steps of 1 ms on one core, as tests/README.md reports it
constexpr double kPieceSeconds = 60;     // of work at most lost when a machine dies
constexpr double kLeastPieceSeconds = 1;
constexpr double kPiecesWanted = 64;  // so that threads and shards find work until the end

std::string listing(std::string_view path) {
    if (path.starts_with("scenario")) return "`tread describe scenario` lists all paths behind \"scenario.\"";
    return "`tread describe vehicle` lists all paths";
}

// ---- Fields by path ----

struct Found {
    bool exists = false;
    bool is_number = false;
    double value = kNan;
    About about{"", ""};
};

template <class Field>
constexpr bool holdsNumber() {
    return std::is_same_v<Field, double> || std::is_same_v<Field, std::optional<double>>;
}

// Changes the number when `set` is given. An optional part that is absent is made on the way, and then kept when set.
Found at(Subject& subject, const std::string& path, const double* set = nullptr) {
    Found found;
    const auto visit = [&](auto& field, const About& about, const std::string&) {
        found.exists = true;
        found.about = about;
        if constexpr (holdsNumber<std::remove_reference_t<decltype(field)>>()) {
            found.is_number = true;
            if (set) field = *set;
            if constexpr (requires { *field; }) found.value = field ? *field : kNan;
            else found.value = field;
        }
    };
    detail::visitField(subject, path, About{"", ""}, visit);
    return found;
}

// ---- Seeds, which differ between repetitions ----

template <class T, class Visit>
void visitSeeds(T& value, const Visit& visit) {
    if constexpr (Described<T>) {
        T::describe(value, [&](std::string_view name, auto& field, const About&) {
            using Field = std::remove_reference_t<decltype(field)>;
            if constexpr (std::is_same_v<Field, int> || std::is_same_v<Field, double>) {
                if (name == "seed") visit(field);
            } else {
                visitSeeds(field, visit);
            }
        });
    } else if constexpr (detail::IsVector<T>::value) {
        for (auto& element : value) visitSeeds(element, visit);
    } else if constexpr (detail::IsVariant<T>::value) {
        std::visit([&](auto& alternative) { visitSeeds(alternative, visit); }, value);
    } else if constexpr (detail::IsOptional<T>::value) {
        if (value) visitSeeds(*value, visit);
    }
}

// ---- Building of a plan ----

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
                applySettings(cell.nominal.vehicle, scenario.car_settings,
                              plan_.inputs.scenarios[s].name + ": car_settings", listing);
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
        return value.value_or(kNan);
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
                const Found found = at(copy, path);
                if (!found.exists) {
                    complain(path_of_names, detail::unknownPathText(path, referenceTable<Subject>(), listing) +
                                                fmt::format(" (asked of {} in {}; `when` restricts a factor to some)",
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
                const Found found = at(copy, name);
                const double actual = variable.relative ? value * found.value : value;
                if (found.about.limits.allow(actual)) continue;
                return complain(path, fmt::format("{} becomes {}, expected a value {}", name, numberText(actual),
                                                  limitsText(found.about.limits)));
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
            if (last < 1) return complain(at + ".grid.count", "found no number of values, expected at least 2");
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
                    applySettings(copy, std::span(&assignment, 1), file_, listing);
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
            Scenario copy = one.scenario;
            int seeds = 0;
            visitSeeds(copy, [&](auto&) { ++seeds; });
            if (file.repetitions > 1 && seeds == 0) {
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

// Row of the design for a dimension: with Sobol indices, rows come in blocks of A, B, and A with one column of B.
double drawn(const Plan& plan, const Cell& cell, std::uint64_t sample, std::size_t dimension) {
    const Draws& draws = plan.draws.front();
    if (plan.inputs.campaign.sampling != Sampling::sobol_indices)
        return draws.at(static_cast<std::size_t>(sample), dimension);
    const std::uint64_t block = cell.drawn.size() + 2;
    const std::uint64_t row = sample % block;
    const bool of_b = row == 1 || (row >= 2 && plan.variables[cell.drawn[row - 2]].dimension == dimension);
    return draws.at(static_cast<std::size_t>(sample / block), dimension + (of_b ? plan.dimensions : 0));
}

double meanOf(const Cell& cell, const Group& group, const Variable& variable) {
    if (!group.mean.empty()) return group.mean[variable.row];
    Subject copy = cell.nominal;
    return at(copy, variable.path).value;
}

double drawnValue(const Plan& plan, const Cell& cell, const Variable& variable, std::uint64_t sample) {
    if (variable.group == Variable::kNoGroup)
        return valueOfShare(plan, cell, variable, drawn(plan, cell, sample, variable.dimension));
    const Group& group = plan.groups[variable.group];
    double value = meanOf(cell, group, variable);
    for (std::size_t j = 0; j < group.dimensions.size(); ++j)
        value += group.root[variable.row][j] * normalQuantile(drawn(plan, cell, sample, group.dimensions[j]));
    return value;
}

}  // namespace

std::uint64_t Plan::countOf(std::uint64_t piece) const {
    return std::min(runs_per_piece, runs - firstOf(piece));
}

Plan planOf(CampaignInputs inputs, const std::vector<std::vector<MetricDefinition>>& definitions,
            const std::string& file) {
    Plan plan;
    plan.inputs = std::move(inputs);
    Builder(plan, file).build(definitions);
    plan.identity = writeYaml(plan.inputs);
    plan.hash = sha256(plan.identity);
    return plan;
}

PlannedRun plannedRun(const Plan& plan, RunNumber number) {
    const auto after = std::upper_bound(plan.cells.begin(), plan.cells.end(), number,
                                        [](RunNumber n, const Cell& cell) { return n < cell.first; });
    PlannedRun run;
    run.number = number;
    run.cell = static_cast<std::size_t>(after - plan.cells.begin()) - 1;
    const Cell& cell = plan.cells[run.cell];
    std::uint64_t rest = number - cell.first;
    const auto take = [&](std::uint64_t radix) {
        const std::uint64_t digit = rest % radix;
        rest /= radix;
        return digit;
    };
    run.repetition = take(static_cast<std::uint64_t>(plan.inputs.campaign.repetitions));
    run.sample = take(cell.samples);
    run.point = rest;
    run.values.assign(plan.variables.size(), kNan);
    for (std::size_t i = cell.listed.size(); i-- > 0;) {
        const Variable& variable = plan.variables[cell.listed[i]];
        run.values[cell.listed[i]] = variable.numbers[take(variable.numbers.size())];
    }
    for (const std::size_t i : cell.drawn) run.values[i] = drawnValue(plan, cell, plan.variables[i], run.sample);
    return run;
}

Subject subjectOf(const Plan& plan, const PlannedRun& run) {
    const Cell& cell = plan.cells[run.cell];
    Subject subject = cell.nominal;
    const std::string where = fmt::format("run {}", run.number);
    std::vector<std::string> words;
    for (std::size_t i = 0; i < plan.variables.size(); ++i) {
        const Variable& variable = plan.variables[i];
        if (std::isnan(run.values[i])) continue;
        for (const std::string& path : variable.paths) {
            if (variable.words) {
                words.push_back(path + "=" + variable.texts[static_cast<std::size_t>(run.values[i])]);
                continue;
            }
            const double value = variable.relative ? at(subject, path).value * run.values[i] : run.values[i];
            at(subject, path, &value);
        }
    }
    if (!words.empty()) applySettings(subject, words, where, listing);
    YamlSession session;  // limits, and rules across fields
    detail::readNothing(session, where, "", subject);
    throwIfAny(std::move(session.problems));
    if (run.repetition > 0) {
        std::uint64_t which = 0;
        visitSeeds(subject.scenario, [&](auto& seed) {
            const std::uint64_t hash = hashOf(static_cast<std::uint64_t>(plan.inputs.campaign.seed) + ++which,
                                              run.repetition, static_cast<std::uint64_t>(seed));
            seed = static_cast<std::remove_reference_t<decltype(seed)>>(hash % 1'000'000'007);
        });
    }
    return subject;
}

double valueOfShare(const Plan& plan, const Cell& cell, const Variable& variable, double share) {
    if (variable.group != Variable::kNoGroup) {
        const Group& group = plan.groups[variable.group];
        double variance = 0;
        for (const double part : group.root[variable.row]) variance += part * part;
        return meanOf(cell, group, variable) + std::sqrt(variance) * normalQuantile(share);
    }
    if (!variable.normal) return variable.from + (variable.to - variable.from) * share;
    const double left = variable.lowest_share + (variable.highest_share - variable.lowest_share) * share;
    return variable.mean + variable.sd * normalQuantile(left);
}

std::string valueText(const Variable& variable, double value) {
    if (std::isnan(value)) return {};
    return variable.words ? variable.texts[static_cast<std::size_t>(value)] : numberText(value);
}

}  // namespace tread::campaign
