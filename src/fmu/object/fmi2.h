// The functions of a co-simulation FMU of FMI 2.0.4 (fmi-standard.org), as tread declares them: names, numbers and
// signatures are those of the standard.
#pragma once

#include <cstddef>

#define TREAD_FMI extern "C" __attribute__((visibility("default")))

using fmi2Component = void*;
using fmi2ComponentEnvironment = void*;
using fmi2FMUstate = void*;
using fmi2ValueReference = unsigned int;
using fmi2Real = double;
using fmi2Integer = int;
using fmi2Boolean = int;
using fmi2String = const char*;
using fmi2Byte = char;

enum fmi2Status : int { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending };
enum fmi2Type : int { fmi2ModelExchange, fmi2CoSimulation };
enum fmi2StatusKind : int { fmi2DoStepStatus, fmi2PendingStatus, fmi2LastSuccessfulTime, fmi2Terminated };

struct fmi2CallbackFunctions {
    void (*logger)(fmi2ComponentEnvironment, fmi2String instance, fmi2Status, fmi2String category, fmi2String message,
                   ...);
    void* (*allocateMemory)(std::size_t, std::size_t);
    void (*freeMemory)(void*);
    void (*stepFinished)(fmi2ComponentEnvironment, fmi2Status);
    fmi2ComponentEnvironment environment;
};

// ---- Creation ----
TREAD_FMI const char* fmi2GetTypesPlatform();
TREAD_FMI const char* fmi2GetVersion();
TREAD_FMI fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                                        const fmi2CallbackFunctions* callbacks, fmi2Boolean visible,
                                        fmi2Boolean logging);
TREAD_FMI void fmi2FreeInstance(fmi2Component c);
TREAD_FMI fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, std::size_t count,
                                         const fmi2String categories[]);

// ---- Initialisation and end ----
TREAD_FMI fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean tolerance_defined, fmi2Real tolerance,
                                         fmi2Real start, fmi2Boolean stop_defined, fmi2Real stop);
TREAD_FMI fmi2Status fmi2EnterInitializationMode(fmi2Component c);
TREAD_FMI fmi2Status fmi2ExitInitializationMode(fmi2Component c);
TREAD_FMI fmi2Status fmi2Terminate(fmi2Component c);
TREAD_FMI fmi2Status fmi2Reset(fmi2Component c);

// ---- Values ----
TREAD_FMI fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference vr[], std::size_t n, fmi2Real values[]);
TREAD_FMI fmi2Status fmi2GetInteger(fmi2Component c, const fmi2ValueReference vr[], std::size_t n,
                                    fmi2Integer values[]);
TREAD_FMI fmi2Status fmi2GetBoolean(fmi2Component c, const fmi2ValueReference vr[], std::size_t n,
                                    fmi2Boolean values[]);
TREAD_FMI fmi2Status fmi2GetString(fmi2Component c, const fmi2ValueReference vr[], std::size_t n, fmi2String values[]);
TREAD_FMI fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference vr[], std::size_t n,
                                 const fmi2Real values[]);
TREAD_FMI fmi2Status fmi2SetInteger(fmi2Component c, const fmi2ValueReference vr[], std::size_t n,
                                    const fmi2Integer values[]);
TREAD_FMI fmi2Status fmi2SetBoolean(fmi2Component c, const fmi2ValueReference vr[], std::size_t n,
                                    const fmi2Boolean values[]);
TREAD_FMI fmi2Status fmi2SetString(fmi2Component c, const fmi2ValueReference vr[], std::size_t n,
                                   const fmi2String values[]);

// ---- State ----
TREAD_FMI fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate* state);
TREAD_FMI fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state);
TREAD_FMI fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate* state);
TREAD_FMI fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate state, std::size_t* size);
TREAD_FMI fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], std::size_t size);
TREAD_FMI fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte bytes[], std::size_t size,
                                             fmi2FMUstate* state);

// ---- Derivatives, which this FMU does not offer ----
TREAD_FMI fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference unknowns[], std::size_t n,
                                                  const fmi2ValueReference knowns[], std::size_t m,
                                                  const fmi2Real change[], fmi2Real result[]);
TREAD_FMI fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference vr[], std::size_t n,
                                                 const fmi2Integer order[], const fmi2Real values[]);
TREAD_FMI fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference vr[], std::size_t n,
                                                  const fmi2Integer order[], fmi2Real values[]);

// ---- Step ----
TREAD_FMI fmi2Status fmi2DoStep(fmi2Component c, fmi2Real time, fmi2Real duration, fmi2Boolean no_way_back);
TREAD_FMI fmi2Status fmi2CancelStep(fmi2Component c);
TREAD_FMI fmi2Status fmi2GetStatus(fmi2Component c, fmi2StatusKind kind, fmi2Status* value);
TREAD_FMI fmi2Status fmi2GetRealStatus(fmi2Component c, fmi2StatusKind kind, fmi2Real* value);
TREAD_FMI fmi2Status fmi2GetIntegerStatus(fmi2Component c, fmi2StatusKind kind, fmi2Integer* value);
TREAD_FMI fmi2Status fmi2GetBooleanStatus(fmi2Component c, fmi2StatusKind kind, fmi2Boolean* value);
TREAD_FMI fmi2Status fmi2GetStringStatus(fmi2Component c, fmi2StatusKind kind, fmi2String* value);
