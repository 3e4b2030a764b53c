// The functions of FMI 3.0 (fmi-standard.org), as tread declares them: names, numbers and signatures are those of the
// standard. Those for other kinds of FMUs must be there, too; they answer with an error.
#pragma once

#include <cstddef>
#include <cstdint>

#define TREAD_FMI extern "C" __attribute__((visibility("default")))

using fmi3Instance = void*;
using fmi3InstanceEnvironment = void*;
using fmi3FMUState = void*;
using fmi3ValueReference = std::uint32_t;
using fmi3Float32 = float;
using fmi3Float64 = double;
using fmi3Boolean = bool;
using fmi3String = const char*;
using fmi3Byte = std::uint8_t;
using fmi3Binary = const fmi3Byte*;
using fmi3Clock = bool;

enum fmi3Status : int { fmi3OK, fmi3Warning, fmi3Discard, fmi3Error, fmi3Fatal };
enum fmi3DependencyKind : int { fmi3Independent, fmi3Constant, fmi3Fixed, fmi3Tunable, fmi3Discrete, fmi3Dependent };
enum fmi3IntervalQualifier : int { fmi3IntervalNotYetKnown, fmi3IntervalUnchanged, fmi3IntervalChanged };

using fmi3LogMessageCallback = void (*)(fmi3InstanceEnvironment, fmi3Status, fmi3String category, fmi3String message);
using fmi3IntermediateUpdateCallback = void (*)(fmi3InstanceEnvironment, fmi3Float64 time, fmi3Boolean set_requested,
                                                fmi3Boolean get_allowed, fmi3Boolean step_finished,
                                                fmi3Boolean return_possible, fmi3Boolean* return_requested,
                                                fmi3Float64* return_time);
using fmi3ClockUpdateCallback = void (*)(fmi3InstanceEnvironment);
using fmi3LockPreemptionCallback = void (*)();
using fmi3UnlockPreemptionCallback = void (*)();

// ---- Creation ----
TREAD_FMI const char* fmi3GetVersion();
TREAD_FMI fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources,
                                                   fmi3Boolean visible, fmi3Boolean logging, fmi3Boolean events,
                                                   fmi3Boolean early_return, const fmi3ValueReference intermediate[],
                                                   std::size_t n, fmi3InstanceEnvironment environment,
                                                   fmi3LogMessageCallback log, fmi3IntermediateUpdateCallback update);
TREAD_FMI fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resources,
                                                    fmi3Boolean visible, fmi3Boolean logging,
                                                    fmi3InstanceEnvironment environment, fmi3LogMessageCallback log);
TREAD_FMI fmi3Instance fmi3InstantiateScheduledExecution(fmi3String name, fmi3String token, fmi3String resources,
                                                         fmi3Boolean visible, fmi3Boolean logging,
                                                         fmi3InstanceEnvironment environment,
                                                         fmi3LogMessageCallback log, fmi3ClockUpdateCallback update,
                                                         fmi3LockPreemptionCallback lock,
                                                         fmi3UnlockPreemptionCallback unlock);
TREAD_FMI void fmi3FreeInstance(fmi3Instance c);
TREAD_FMI fmi3Status fmi3SetDebugLogging(fmi3Instance c, fmi3Boolean on, std::size_t n, const fmi3String categories[]);

// ---- Initialisation, step, end ----
TREAD_FMI fmi3Status fmi3EnterInitializationMode(fmi3Instance c, fmi3Boolean tolerance_defined, fmi3Float64 tolerance,
                                                 fmi3Float64 start, fmi3Boolean stop_defined, fmi3Float64 stop);
TREAD_FMI fmi3Status fmi3ExitInitializationMode(fmi3Instance c);
TREAD_FMI fmi3Status fmi3DoStep(fmi3Instance c, fmi3Float64 time, fmi3Float64 duration, fmi3Boolean no_way_back,
                                fmi3Boolean* event, fmi3Boolean* terminate, fmi3Boolean* early_return,
                                fmi3Float64* last_time);
TREAD_FMI fmi3Status fmi3Terminate(fmi3Instance c);
TREAD_FMI fmi3Status fmi3Reset(fmi3Instance c);

// ---- Values ----
TREAD_FMI fmi3Status fmi3GetFloat64(fmi3Instance c, const fmi3ValueReference vr[], std::size_t n, fmi3Float64 values[],
                                    std::size_t m);
TREAD_FMI fmi3Status fmi3SetFloat64(fmi3Instance c, const fmi3ValueReference vr[], std::size_t n,
                                    const fmi3Float64 values[], std::size_t m);
TREAD_FMI fmi3Status fmi3GetBoolean(fmi3Instance c, const fmi3ValueReference vr[], std::size_t n, fmi3Boolean values[],
                                    std::size_t m);
TREAD_FMI fmi3Status fmi3SetBoolean(fmi3Instance c, const fmi3ValueReference vr[], std::size_t n,
                                    const fmi3Boolean values[], std::size_t m);

// ---- State ----
TREAD_FMI fmi3Status fmi3GetFMUState(fmi3Instance c, fmi3FMUState* state);
TREAD_FMI fmi3Status fmi3SetFMUState(fmi3Instance c, fmi3FMUState state);
TREAD_FMI fmi3Status fmi3FreeFMUState(fmi3Instance c, fmi3FMUState* state);
TREAD_FMI fmi3Status fmi3SerializedFMUStateSize(fmi3Instance c, fmi3FMUState state, std::size_t* size);
TREAD_FMI fmi3Status fmi3SerializeFMUState(fmi3Instance c, fmi3FMUState state, fmi3Byte bytes[], std::size_t size);
TREAD_FMI fmi3Status fmi3DeserializeFMUState(fmi3Instance c, const fmi3Byte bytes[], std::size_t size,
                                             fmi3FMUState* state);
