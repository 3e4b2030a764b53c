#include "fmu/object/fmi3.h"

#include <string>

#include "fmu/object/fmi3_component.h"
#include "fmu/object/master.h"
#include "host/failure.h"

using tread::fmu::Fmi3Component;
using tread::fmu::Instance;
using tread::fmu::on;

const char* fmi3GetVersion() {
    return "3.0";
}

fmi3Instance fmi3InstantiateCoSimulation(fmi3String, fmi3String token, fmi3String resources, fmi3Boolean, fmi3Boolean,
                                         fmi3Boolean, fmi3Boolean, const fmi3ValueReference[], std::size_t,
                                         fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
                                         fmi3IntermediateUpdateCallback) {
    Fmi3Component* made = nullptr;
    const Fmi3Component fallback{environment, log, nullptr};
    tread::fmu::guarded(
        fmi3OK, fmi3Error, [&](const char* text) { fallback.say(text); },
        [&] {
            if (!token || !resources) tread::host::refuse("found no token or no place of the resources");
            made = new Fmi3Component{
                environment, log,
                std::make_unique<Instance>(tread::fmu::pathOf(resources), token, std::string_view("3.0"))};
        });
    return made;
}

void fmi3FreeInstance(fmi3Instance c) {
    delete static_cast<Fmi3Component*>(c);
}
fmi3Status fmi3SetDebugLogging(fmi3Instance c, fmi3Boolean, std::size_t, const fmi3String[]) {
    return c ? fmi3OK : fmi3Error;
}

fmi3Status fmi3EnterInitializationMode(fmi3Instance c, fmi3Boolean, fmi3Float64, fmi3Float64 start, fmi3Boolean,
                                       fmi3Float64) {
    return on(c, [&](Instance& i) {
        i.setStartTime(start);
        i.enterInitialisation();
    });
}
fmi3Status fmi3ExitInitializationMode(fmi3Instance c) {
    return on(c, [](Instance& i) { i.exitInitialisation(); });
}
fmi3Status fmi3DoStep(fmi3Instance c, fmi3Float64 time, fmi3Float64 duration, fmi3Boolean, fmi3Boolean* event,
                      fmi3Boolean* terminate, fmi3Boolean* early_return, fmi3Float64* last_time) {
    for (fmi3Boolean* flag : {event, terminate, early_return})
        if (flag) *flag = false;
    return on(c, [&](Instance& i) {
        if (last_time) *last_time = i.time();
        i.step(time, duration);
        if (last_time) *last_time = i.time();
    });
}
fmi3Status fmi3Terminate(fmi3Instance c) {
    return on(c, [](Instance& i) { i.terminate(); });
}
fmi3Status fmi3Reset(fmi3Instance c) {
    return on(c, [](Instance& i) { i.reset(); });
}

namespace {

// One value for each reference: no variable is an array.
void demandOneEach(std::size_t references, std::size_t values) {
    if (references != values) tread::host::refuse("found another number of values than of value references");
}

}  // namespace

fmi3Status fmi3GetFloat64(fmi3Instance c, const fmi3ValueReference vr[], std::size_t n, fmi3Float64 values[],
                          std::size_t m) {
    return on(c, [&](Instance& i) {
        demandOneEach(n, m);
        tread::fmu::getValues(i, vr, n, values, false);
    });
}
fmi3Status fmi3SetFloat64(fmi3Instance c, const fmi3ValueReference vr[], std::size_t n, const fmi3Float64 values[],
                          std::size_t m) {
    return on(c, [&](Instance& i) {
        demandOneEach(n, m);
        tread::fmu::setValues(i, vr, n, values, false);
    });
}
fmi3Status fmi3GetBoolean(fmi3Instance c, const fmi3ValueReference vr[], std::size_t n, fmi3Boolean values[],
                          std::size_t m) {
    return on(c, [&](Instance& i) {
        demandOneEach(n, m);
        tread::fmu::getValues(i, vr, n, values, true);
    });
}
fmi3Status fmi3SetBoolean(fmi3Instance c, const fmi3ValueReference vr[], std::size_t n, const fmi3Boolean values[],
                          std::size_t m) {
    return on(c, [&](Instance& i) {
        demandOneEach(n, m);
        tread::fmu::setValues(i, vr, n, values, true);
    });
}

fmi3Status fmi3GetFMUState(fmi3Instance c, fmi3FMUState* state) {
    return on(c, [&](Instance& i) { tread::fmu::keep(*state, i.save()); });
}
fmi3Status fmi3SetFMUState(fmi3Instance c, fmi3FMUState state) {
    return on(c, [&](Instance& i) {
        if (!state) tread::host::refuse("found no state, expected one of this FMU");
        i.restore(*static_cast<const Instance::Saved*>(state));
    });
}
fmi3Status fmi3FreeFMUState(fmi3Instance c, fmi3FMUState* state) {
    return on(c, [&](Instance&) {
        if (!state) return;
        delete static_cast<Instance::Saved*>(*state);
        *state = nullptr;
    });
}
fmi3Status fmi3SerializedFMUStateSize(fmi3Instance c, fmi3FMUState, std::size_t* size) {
    return on(c, [&](Instance& i) { *size = i.serialisedSize(); });
}
fmi3Status fmi3SerializeFMUState(fmi3Instance c, fmi3FMUState state, fmi3Byte bytes[], std::size_t size) {
    return on(c, [&](Instance& i) { tread::fmu::writeBytes(i, state, bytes, size); });
}
fmi3Status fmi3DeserializeFMUState(fmi3Instance c, const fmi3Byte bytes[], std::size_t size, fmi3FMUState* state) {
    return on(c, [&](Instance& i) { tread::fmu::readBytes(i, bytes, size, *state); });
}
