// One car within an FMU, independent of the version of FMI.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "fmu/variables.h"
#include "host/car.h"

namespace tread::fmu {

class Instance {
public:
    enum class Phase { instantiated, initialising, stepping, terminated };

    // From the folder of the resources. Refuses a token that is not the FMU's own. As everything here, throws
    // host::Failure or LoadError.
    Instance(const std::filesystem::path& resources, std::string_view token, std::string_view fmi_version);
    Instance(const Instance&) = delete;
    Instance& operator=(const Instance&) = delete;

    void setStartTime(double time);
    void enterInitialisation();
    void exitInitialisation();
    void step(double time, double duration);
    void terminate();
    void reset();

    // By value reference; `flag`: a boolean is meant.
    double get(std::size_t reference, bool flag);
    void set(std::size_t reference, double value, bool flag);

    double time() const { return start_time_ + (car_ ? car_->time() : 0); }

    // All that makes the instance what it is.
    struct Saved {
        Phase phase;
        double start_time;
        std::vector<double> values;  // of inputs and parameters
        Found found;
        std::optional<host::Snapshot> car;
    };
    Saved save() const;
    void restore(const Saved& saved);

    std::size_t serialisedSize() const;
    std::vector<std::byte> serialise(const Saved& saved) const;
    Saved deserialise(std::span<const std::byte> bytes) const;

private:
    const Variable& variable(std::size_t reference, bool flag) const;
    std::vector<double> givenValues() const;
    void make();
    void start();
    void setSurroundings();
    Vector3 wheelCentre(std::size_t wheel) const;
    void observe();

    std::string token_;
    Values values_;
    std::vector<Variable> variables_;
    std::vector<double> defaults_;
    double start_time_ = 0;
    Phase phase_ = Phase::instantiated;
    std::unique_ptr<host::Car> car_;
    std::vector<double> made_of_;  // the given values that the car was made of
    bool started_ = false;         // with the values of now
    bool observed_ = false;        // the outputs are those of now
};

}  // namespace tread::fmu
