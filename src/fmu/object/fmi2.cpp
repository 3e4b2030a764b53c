#include "fmu/object/fmi2.h"

#include <string>

#include "fmu/object/master.h"
#include "host/failure.h"

namespace {

using tread::fmu::Instance;

struct Component {
    std::string name;
    fmi2CallbackFunctions callbacks{};
    bool logging = false;
    std::unique_ptr<Instance> instance;

    void say(const char* text) const {
        if (callbacks.logger)
            callbacks.logger(callbacks.environment, name.c_str(), fmi2Error, "logStatusError", "%s", text);
    }
};

template <class Action>
fmi2Status on(fmi2Component c, const Action& action) {
    auto* component = static_cast<Component*>(c);
    if (!component) return fmi2Error;
    return tread::fmu::guarded(
        fmi2OK, fmi2Error, [&](const char* text) { component->say(text); }, [&] { action(*component->instance); });
}

// There are no variables of this type.
fmi2Status none(fmi2Component c, std::size_t n) {
    return on(c, [&](Instance&) {
        if (n > 0) tread::host::refuse("this FMU has real and boolean variables only");
    });
}

fmi2Status unsupported(fmi2Component c) {
    return on(c, [](Instance&) { tread::host::refuse("this FMU does not offer that function"); });
}

}  // namespace

const char* fmi2GetTypesPlatform() {
    return "default";
}

const char* fmi2GetVersion() {
    return "2.0";
}

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions* callbacks, fmi2Boolean, fmi2Boolean logging) {
    Component* made = nullptr;
    Component fallback;
    if (callbacks) fallback.callbacks = *callbacks;
    tread::fmu::guarded(
        fmi2OK, fmi2Error, [&](const char* text) { fallback.say(text); },
        [&] {
            if (name) fallback.name = name;
            if (type != fmi2CoSimulation) tread::host::refuse("this FMU is for co-simulation only");
            if (!guid || !resources) tread::host::refuse("found no GUID or no place of the resources");
            auto component = std::make_unique<Component>();
            component->name = fallback.name;
            component->callbacks = fallback.callbacks;
            component->logging = logging != 0;
            component->instance = std::make_unique<Instance>(tread::fmu::pathOf(resources), guid, "2.0");
            made = component.release();
        });
    return made;
}

void fmi2FreeInstance(fmi2Component c) {
    delete static_cast<Component*>(c);
}

fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, std::size_t, const fmi2String[]) {
    if (!c) return fmi2Error;
    static_cast<Component*>(c)->logging = on != 0;
    return fmi2OK;
}

fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean, fmi2Real, fmi2Real start, fmi2Boolean, fmi2Real) {
    return on(c, [&](Instance& i) { i.setStartTime(start); });
}
fmi2Status fmi2EnterInitializationMode(fmi2Component c) {
    return on(c, [](Instance& i) { i.enterInitialisation(); });
}
fmi2Status fmi2ExitInitializationMode(fmi2Component c) {
    return on(c, [](Instance& i) { i.exitInitialisation(); });
}
fmi2Status fmi2Terminate(fmi2Component c) {
    return on(c, [](Instance& i) { i.terminate(); });
}
fmi2Status fmi2Reset(fmi2Component c) {
    return on(c, [](Instance& i) { i.reset(); });
}

fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference vr[], std::size_t n, fmi2Real values[]) {
    return on(c, [&](Instance& i) { tread::fmu::getValues(i, vr, n, values, false); });
}
fmi2Status fmi2GetInteger(fmi2Component c, const fmi2ValueReference[], std::size_t n, fmi2Integer[]) {
    return none(c, n);
}
fmi2Status fmi2GetBoolean(fmi2Component c, const fmi2ValueReference vr[], std::size_t n, fmi2Boolean values[]) {
    return on(c, [&](Instance& i) { tread::fmu::getValues(i, vr, n, values, true); });
}
fmi2Status fmi2GetString(fmi2Component c, const fmi2ValueReference[], std::size_t n, fmi2String[]) {
    return none(c, n);
}
fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference vr[], std::size_t n, const fmi2Real values[]) {
    return on(c, [&](Instance& i) { tread::fmu::setValues(i, vr, n, values, false); });
}
fmi2Status fmi2SetInteger(fmi2Component c, const fmi2ValueReference[], std::size_t n, const fmi2Integer[]) {
    return none(c, n);
}
fmi2Status fmi2SetBoolean(fmi2Component c, const fmi2ValueReference vr[], std::size_t n, const fmi2Boolean values[]) {
    return on(c, [&](Instance& i) { tread::fmu::setValues(i, vr, n, values, true); });
}
fmi2Status fmi2SetString(fmi2Component c, const fmi2ValueReference[], std::size_t n, const fmi2String[]) {
    return none(c, n);
}

fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate* state) {
    return on(c, [&](Instance& i) { tread::fmu::keep(*state, i.save()); });
}
fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state) {
    return on(c, [&](Instance& i) {
        if (!state) tread::host::refuse("found no state, expected one of this FMU");
        i.restore(*static_cast<const Instance::Saved*>(state));
    });
}
fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate* state) {
    return on(c, [&](Instance&) {
        if (!state) return;
        delete static_cast<Instance::Saved*>(*state);
        *state = nullptr;
    });
}
fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate, std::size_t* size) {
    return on(c, [&](Instance& i) { *size = i.serialisedSize(); });
}
fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], std::size_t size) {
    return on(c, [&](Instance& i) { tread::fmu::writeBytes(i, state, bytes, size); });
}
fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte bytes[], std::size_t size, fmi2FMUstate* state) {
    return on(c, [&](Instance& i) { tread::fmu::readBytes(i, bytes, size, *state); });
}

fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference[], std::size_t,
                                        const fmi2ValueReference[], std::size_t, const fmi2Real[], fmi2Real[]) {
    return unsupported(c);
}
fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference[], std::size_t, const fmi2Integer[],
                                       const fmi2Real[]) {
    return unsupported(c);
}
fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference[], std::size_t, const fmi2Integer[],
                                        fmi2Real[]) {
    return unsupported(c);
}

fmi2Status fmi2DoStep(fmi2Component c, fmi2Real time, fmi2Real duration, fmi2Boolean) {
    return on(c, [&](Instance& i) { i.step(time, duration); });
}
fmi2Status fmi2CancelStep(fmi2Component c) {
    return unsupported(c);
}
fmi2Status fmi2GetStatus(fmi2Component, fmi2StatusKind, fmi2Status*) {
    return fmi2Discard;  // no step is ever pending
}
fmi2Status fmi2GetRealStatus(fmi2Component c, fmi2StatusKind kind, fmi2Real* value) {
    if (kind != fmi2LastSuccessfulTime) return fmi2Discard;
    return on(c, [&](Instance& i) { *value = i.time(); });
}
fmi2Status fmi2GetIntegerStatus(fmi2Component, fmi2StatusKind, fmi2Integer*) {
    return fmi2Discard;
}
fmi2Status fmi2GetBooleanStatus(fmi2Component, fmi2StatusKind kind, fmi2Boolean* value) {
    if (kind != fmi2Terminated) return fmi2Discard;
    *value = 0;
    return fmi2OK;
}
fmi2Status fmi2GetStringStatus(fmi2Component, fmi2StatusKind, fmi2String*) {
    return fmi2Discard;
}
