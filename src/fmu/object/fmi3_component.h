// What an instance of FMI 3.0 points to.
#pragma once

#include "fmu/object/fmi3.h"
#include "fmu/object/master.h"

namespace tread::fmu {

struct Fmi3Component {
    fmi3InstanceEnvironment environment;
    fmi3LogMessageCallback log;
    std::unique_ptr<Instance> instance;

    void say(const char* text) const {
        if (log) log(environment, fmi3Error, "logStatusError", text);
    }
};

// Runs `action` on the instance.
template <class Action>
fmi3Status on(fmi3Instance c, const Action& action) {
    auto* component = static_cast<Fmi3Component*>(c);
    if (!component) return fmi3Error;
    return guarded(
        fmi3OK, fmi3Error, [&](const char* text) { component->say(text); }, [&] { action(*component->instance); });
}

}  // namespace tread::fmu
