// What the metrics of a run must be: names of metrics against conditions, as a map in a scenario or in a file of its
// own.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/fields/visitors.h"
#include "tread/describe.h"

namespace tread {

struct AcceptLine {
    std::string metric;
    std::string condition;  // as parseCondition() reads it
    int line = 0;           // where the condition stands; 0: in no file
    int column = 0;
};

struct Acceptance {
    std::vector<AcceptLine> lines;

    bool empty() const { return lines.empty(); }
};

// Conditions for the scenario of one file, in place of its own for the same metrics.
struct ScenarioAcceptance {
    std::string scenario;
    Acceptance accept = {};

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(scenario), About{"", "name of the scenario's file, without .yaml"});
        field(TREAD_FIELD(accept), About{"", "conditions of this scenario"});
    }
};
static_assert(describesEveryMember<ScenarioAcceptance>());

// The file that `tread run --accept` reads.
struct AcceptFile {
    Acceptance accept = {};
    std::vector<ScenarioAcceptance> accept_of = {};

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(accept),
              About{"", "what the metrics must be, each `name: condition`; of every scenario that has the metric"});
        field(TREAD_FIELD(accept_of), About{"", "conditions of single scenarios"});
    }
};
static_assert(describesEveryMember<AcceptFile>());

// Both, a condition of `more` in place of that of `base` for the same metric.
Acceptance merged(Acceptance base, const Acceptance& more);

// A map of the user's own names is no described struct.
namespace detail {

template <>
void readValue<Acceptance>(const YamlReader& reader, const YamlPlace& place, Acceptance& value, const About& about);
template <>
YamlItem itemOf<Acceptance>(std::string_view name, const Acceptance& value, const About& about);
template <>
std::string schemaOf<Acceptance>(SchemaBuilder& builder, const std::string& path, const Acceptance& value,
                                 const About& about);
template <>
void addRows<Acceptance>(ReferenceRows& table, const std::string& path, const Acceptance& value, const About& about);

}  // namespace detail
}  // namespace tread
