#include "diagnose/model/problem.h"

#include <fmt/format.h>

#include <memory>
#include <numeric>
#include <stdexcept>

#include "diagnose/model/sensitivity_cache.h"
#include "diagnose/settings.h"
#include "recording/reference.h"
#include "run/variants.h"

namespace tread::diagnose::model {
namespace {

int comparedCount(Drives drives) {
    int count = 0;
    for (const RecordedDrive& drive : drives) count += drive.compared() ? 1 : 0;
    return count;
}

// Simulates the nominal car and variants of it.
recording::Simulate simulatorOf(const Subject& nominal, const Options& options) {
    recording::Simulate simulate = options.simulate;
    if (!simulate) {
        simulate = [variants = std::make_shared<Variants>(nominal.vehicle)](const auto&... all) {
            variants->simulate(all...);
        };
    }
    return [simulate, before_each = options.before_each](const auto&... all) {
        before_each();
        simulate(all...);
    };
}

}  // namespace

std::vector<std::string> Problem::namesOf(const std::vector<std::size_t>& some) const {
    std::vector<std::string> names;
    for (const std::size_t e : some) names.push_back(effects[e].name);
    return names;
}

std::vector<Eigen::Index> Problem::allKnobs() const {
    std::vector<Eigen::Index> all;
    for (const auto& of_effect : knobs) all.insert(all.end(), of_effect.begin(), of_effect.end());
    return all;
}

std::vector<Eigen::Index> Problem::knobsOf(const std::vector<std::size_t>& some) const {
    std::vector<Eigen::Index> all;
    for (const std::size_t e : some) all.insert(all.end(), knobs[e].begin(), knobs[e].end());
    return all;
}

Deviation Problem::withOnly(const std::vector<std::size_t>& some, Deviation point) const {
    const std::vector<Eigen::Index> kept = knobsOf(some);
    const Eigen::VectorXd values = point(kept);
    point(allKnobs()).setZero();
    point(kept) = values;
    return point;
}

Problem problemOf(const Subject& nominal, const recording::DiagnosisFile& file, const recording::Recorded& recorded,
                  const std::function<Differences(Drives)>& differences, const Options& options) {
    Problem problem;
    problem.replays.replayer = {nominal, file.step, simulatorOf(nominal, options)};
    problem.replays.threads = options.threads;
    problem.replays.cache = options.cache;
    if (!options.cache.empty()) largestCache();  // what is wrong with it is told before the work
    const recording::Replayer& replayer = problem.replays.replayer;
    problem.drives = recording::recordedDrives(file, recorded, false, replayer, options.threads);
    problem.held_out = recording::recordedDrives(file, recorded, true, replayer, options.threads);
    if (problem.drives.empty())
        throw std::invalid_argument("found hold_out: true for every recording, expected at least one recording to fit");
    problem.replays.simulations.add(comparedCount(problem.drives) + comparedCount(problem.held_out));
    Differences found = differences(problem.drives);
    problem.replays.parameters = std::move(found.parameters);
    problem.effects = std::move(found.effects);
    problem.knobs = std::move(found.knobs);
    problem.nuisances = std::move(found.nuisances);
    problem.of_both = std::move(found.of_both);
    problem.imperfections = std::move(found.imperfections);
    return problem;
}

Problem problemOf(const Subject& nominal, const recording::DiagnosisFile& file, const recording::Recorded& recorded,
                  const std::vector<Effect>& effects, const Options& options,
                  const std::vector<KnownWithin>& left_open) {
    const auto differences = [&](Drives drives) {
        const bool same_car = recording::compared(drives);
        Differences all;
        all.parameters = nuisances(nominal, file.tolerances, same_car ? kSettings.between_days : 1);
        if (same_car || !file.before.empty())
            if (auto one = temperatureOfTheTyres(nominal, file.tolerances)) all.parameters.push_back(*std::move(one));
        for (Parameter& one : nuisancesOfTheWind(nominal, file.tolerances, drives))
            all.parameters.push_back(std::move(one));
        all.nuisances.resize(all.parameters.size());
        std::iota(all.nuisances.begin(), all.nuisances.end(), 0);
        for (Parameter& one : nuisancesOfBoth(nominal, left_open)) {
            all.of_both.push_back(std::ssize(all.parameters));
            all.parameters.push_back(std::move(one));
        }
        for (const Effect& effect : effects) {
            std::vector<Eigen::Index> knobs;
            for (Parameter& parameter : knobsOf(effect, nominal)) {
                knobs.push_back(std::ssize(all.parameters));
                all.parameters.push_back(std::move(parameter));
            }
            if (knobs.empty()) continue;
            all.effects.push_back(effect);
            all.knobs.push_back(std::move(knobs));
        }
        for (const auto& knobs : all.knobs) {
            for (const Eigen::Index knob : knobs) {
                all.imperfections.push_back(std::ssize(all.parameters));
                Parameter small;
                small.imperfection_of = knob;
                all.parameters.push_back(std::move(small));
            }
        }
        return all;
    };
    return problemOf(nominal, file, recorded, differences, options);
}

NominalCar nominalCar(const Problem& problem, const Progress& progress, Resolution resolution) {
    const Deviation origin = problem.replays.origin();
    Sensitivities about = sensitivities(problem.replays, problem.drives, origin, {.parameters = problem.nuisances},
                                        [&](double share) { progress(share, "sensitivities to tolerances"); });
    expectDriven(problem.drives, about);
    NominalCar car;
    for (const Eigen::MatrixXd& columns : about.columns)
        car.allowed.emplace_back(columns(Eigen::all, problem.nuisances).rowwise().norm());
    car.uncertainty = uncertaintyAt(problem.replays, problem.drives, origin, about.rows, endsOf(problem.drives),
                                    nullptr, {}, resolution);
    const std::vector<Eigen::Index> relevant =
        relevantNuisances(problem.nuisances, about, car.uncertainty, problem.replays.threads);
    car.about = linearisation(std::move(about), relevant, {}, car.uncertainty, problem.replays.threads);
    return car;
}

void expectDriven(Drives drives, const Sensitivities& about) {
    for (std::size_t d = 0; d < about.rows.size(); ++d) {
        if (about.rows[d].size() == 0)
            throw std::invalid_argument(
                fmt::format("recording {}: the simulation of the nominal car in this drive fails, expected it to "
                            "complete; check the vehicle file and the recorded inputs",
                            drives[d].name));
    }
}

}  // namespace tread::diagnose::model
