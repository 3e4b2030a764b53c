// Functions of FMI 3.0 for variables and kinds of FMUs that this one does not have. Signatures are those of the
// standard.
#include "fmu/object/fmi3_component.h"
#include "host/failure.h"

using tread::fmu::Instance;
using tread::fmu::on;

namespace {

using References = const fmi3ValueReference*;

// There are no variables of this type.
fmi3Status none(fmi3Instance c, std::size_t n) {
    return on(c, [&](Instance&) {
        if (n > 0) tread::host::refuse("this FMU has variables of the types Float64 and Boolean only");
    });
}

fmi3Status unsupported(fmi3Instance c) {
    return on(c, [](Instance&) { tread::host::refuse("this FMU does not offer that function"); });
}

fmi3Instance coSimulationOnly(fmi3InstanceEnvironment environment, fmi3LogMessageCallback log) {
    const tread::fmu::Fmi3Component nobody{environment, log, nullptr};
    nobody.say("this FMU is for co-simulation only");
    return nullptr;
}

}  // namespace

fmi3Instance fmi3InstantiateModelExchange(fmi3String, fmi3String, fmi3String, fmi3Boolean, fmi3Boolean,
                                          fmi3InstanceEnvironment environment, fmi3LogMessageCallback log) {
    return coSimulationOnly(environment, log);
}
fmi3Instance fmi3InstantiateScheduledExecution(fmi3String, fmi3String, fmi3String, fmi3Boolean, fmi3Boolean,
                                               fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
                                               fmi3ClockUpdateCallback, fmi3LockPreemptionCallback,
                                               fmi3UnlockPreemptionCallback) {
    return coSimulationOnly(environment, log);
}

// ---- Variables of other types ----

TREAD_FMI fmi3Status fmi3GetFloat32(fmi3Instance c, References, std::size_t n, fmi3Float32*, std::size_t) {
    return none(c, n);
}
TREAD_FMI fmi3Status fmi3SetFloat32(fmi3Instance c, References, std::size_t n, const fmi3Float32*, std::size_t) {
    return none(c, n);
}
TREAD_FMI fmi3Status fmi3GetInt8(fmi3Instance c, References, std::size_t n, std::int8_t*, std::size_t) {
    return none(c, n);
}
TREAD_FMI fmi3Status fmi3SetInt8(fmi3Instance c, References, std::size_t n, const std::int8_t*, std::size_t) {
    return none(c, n);
}
TREAD_FMI fmi3Status fmi3GetUInt8(fmi3Instance c, References, std::size_t n, std::uint8_t*, std::size_t) {
    return none(c, n);
}
TREAD_FMI fmi3Status fmi3SetUInt8(fmi3Instance c, References, std::size_t n, const std::uint8_t*, std::size_t) {
    return none(c, n);
}
TREAD_FMI fmi3Status fmi3GetInt16(fmi3Instance c, References, std::size_t n, std::int16_t*, std::size_t) {
    return none(c, n);
}
TREAD_FMI fmi3Status fmi3SetInt16(fmi3Instance c, References, std::size_t n, const std::int16_t*, std::size_t) {
    return none(c, n);
}
TREAD_FMI fmi3Status fmi3GetUInt16(fmi3Instance c, References, std::size_t n, std::uint16_t*, std::size_t) {
    return none(c, n);
}
TREAD_FMI fmi3Status fmi3SetUInt16(fmi3Instance c, References, std::size_t n, const std::uint16_t*, std::size_t) {
    return none(c, n);
}
TREAD_FMI fmi3Status fmi3GetInt32(fmi3Instance c, References, std::size_t n, std::int32_t*, std::size_t) {
    return none(c, n);
}
TREAD_FMI fmi3Status fmi3SetInt32(fmi3Instance c, References, std::size_t n, const std::int32_t*, std::size_t) {
    return none(c, n);
}
TREAD_FMI fmi3Status fmi3GetUInt32(fmi3Instance c, References, std::size_t n, std::uint32_t*, std::size_t) {
    return none(c, n);
}
TREAD_FMI fmi3Status fmi3SetUInt32(fmi3Instance c, References, std::size_t n, const std::uint32_t*, std::size_t) {
    return none(c, n);
}
TREAD_FMI fmi3Status fmi3GetInt64(fmi3Instance c, References, std::size_t n, std::int64_t*, std::size_t) {
    return none(c, n);
}
TREAD_FMI fmi3Status fmi3SetInt64(fmi3Instance c, References, std::size_t n, const std::int64_t*, std::size_t) {
    return none(c, n);
}
TREAD_FMI fmi3Status fmi3GetUInt64(fmi3Instance c, References, std::size_t n, std::uint64_t*, std::size_t) {
    return none(c, n);
}
TREAD_FMI fmi3Status fmi3SetUInt64(fmi3Instance c, References, std::size_t n, const std::uint64_t*, std::size_t) {
    return none(c, n);
}
TREAD_FMI fmi3Status fmi3GetString(fmi3Instance c, References, std::size_t n, fmi3String*, std::size_t) {
    return none(c, n);
}
TREAD_FMI fmi3Status fmi3SetString(fmi3Instance c, References, std::size_t n, const fmi3String*, std::size_t) {
    return none(c, n);
}
TREAD_FMI fmi3Status fmi3GetBinary(fmi3Instance c, References, std::size_t n, std::size_t*, fmi3Binary*, std::size_t) {
    return none(c, n);
}
TREAD_FMI fmi3Status fmi3SetBinary(fmi3Instance c, References, std::size_t n, const std::size_t*, const fmi3Binary*,
                                   std::size_t) {
    return none(c, n);
}
TREAD_FMI fmi3Status fmi3GetClock(fmi3Instance c, References, std::size_t n, fmi3Clock*) {
    return none(c, n);
}
TREAD_FMI fmi3Status fmi3SetClock(fmi3Instance c, References, std::size_t n, const fmi3Clock*) {
    return none(c, n);
}

// ---- Clocks ----

TREAD_FMI fmi3Status fmi3GetIntervalDecimal(fmi3Instance c, References, std::size_t, fmi3Float64*,
                                            fmi3IntervalQualifier*) {
    return unsupported(c);
}
TREAD_FMI fmi3Status fmi3GetIntervalFraction(fmi3Instance c, References, std::size_t, std::uint64_t*, std::uint64_t*,
                                             fmi3IntervalQualifier*) {
    return unsupported(c);
}
TREAD_FMI fmi3Status fmi3GetShiftDecimal(fmi3Instance c, References, std::size_t, fmi3Float64*) {
    return unsupported(c);
}
TREAD_FMI fmi3Status fmi3GetShiftFraction(fmi3Instance c, References, std::size_t, std::uint64_t*, std::uint64_t*) {
    return unsupported(c);
}
TREAD_FMI fmi3Status fmi3SetIntervalDecimal(fmi3Instance c, References, std::size_t, const fmi3Float64*) {
    return unsupported(c);
}
TREAD_FMI fmi3Status fmi3SetIntervalFraction(fmi3Instance c, References, std::size_t, const std::uint64_t*,
                                             const std::uint64_t*) {
    return unsupported(c);
}
TREAD_FMI fmi3Status fmi3SetShiftDecimal(fmi3Instance c, References, std::size_t, const fmi3Float64*) {
    return unsupported(c);
}
TREAD_FMI fmi3Status fmi3SetShiftFraction(fmi3Instance c, References, std::size_t, const std::uint64_t*,
                                          const std::uint64_t*) {
    return unsupported(c);
}
TREAD_FMI fmi3Status fmi3ActivateModelPartition(fmi3Instance c, fmi3ValueReference, fmi3Float64) {
    return unsupported(c);
}

// ---- Other modes, continuous states ----

TREAD_FMI fmi3Status fmi3EnterConfigurationMode(fmi3Instance c) {
    return unsupported(c);
}
TREAD_FMI fmi3Status fmi3ExitConfigurationMode(fmi3Instance c) {
    return unsupported(c);
}
TREAD_FMI fmi3Status fmi3EnterEventMode(fmi3Instance c) {
    return unsupported(c);
}
TREAD_FMI fmi3Status fmi3EnterStepMode(fmi3Instance c) {
    return unsupported(c);
}
TREAD_FMI fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance c) {
    return unsupported(c);
}
TREAD_FMI fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance c) {
    return unsupported(c);
}
TREAD_FMI fmi3Status fmi3UpdateDiscreteStates(fmi3Instance c, fmi3Boolean*, fmi3Boolean*, fmi3Boolean*, fmi3Boolean*,
                                              fmi3Boolean*, fmi3Float64*) {
    return unsupported(c);
}
TREAD_FMI fmi3Status fmi3CompletedIntegratorStep(fmi3Instance c, fmi3Boolean, fmi3Boolean*, fmi3Boolean*) {
    return unsupported(c);
}
TREAD_FMI fmi3Status fmi3SetTime(fmi3Instance c, fmi3Float64) {
    return unsupported(c);
}
TREAD_FMI fmi3Status fmi3SetContinuousStates(fmi3Instance c, const fmi3Float64*, std::size_t) {
    return unsupported(c);
}
TREAD_FMI fmi3Status fmi3GetContinuousStates(fmi3Instance c, fmi3Float64*, std::size_t) {
    return unsupported(c);
}
TREAD_FMI fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance c, fmi3Float64*, std::size_t) {
    return unsupported(c);
}
TREAD_FMI fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance c, fmi3Float64*, std::size_t) {
    return unsupported(c);
}
TREAD_FMI fmi3Status fmi3GetEventIndicators(fmi3Instance c, fmi3Float64*, std::size_t) {
    return unsupported(c);
}
TREAD_FMI fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance c, std::size_t*) {
    return unsupported(c);
}
TREAD_FMI fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance c, std::size_t*) {
    return unsupported(c);
}

// ---- Dependencies and derivatives ----

TREAD_FMI fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance c, fmi3ValueReference, std::size_t*) {
    return unsupported(c);
}
TREAD_FMI fmi3Status fmi3GetVariableDependencies(fmi3Instance c, fmi3ValueReference, std::size_t*, fmi3ValueReference*,
                                                 std::size_t*, fmi3DependencyKind*, std::size_t) {
    return unsupported(c);
}
TREAD_FMI fmi3Status fmi3GetDirectionalDerivative(fmi3Instance c, References, std::size_t, References, std::size_t,
                                                  const fmi3Float64*, std::size_t, fmi3Float64*, std::size_t) {
    return unsupported(c);
}
TREAD_FMI fmi3Status fmi3GetAdjointDerivative(fmi3Instance c, References, std::size_t, References, std::size_t,
                                              const fmi3Float64*, std::size_t, fmi3Float64*, std::size_t) {
    return unsupported(c);
}
TREAD_FMI fmi3Status fmi3GetOutputDerivatives(fmi3Instance c, References, std::size_t, const std::int32_t*,
                                              fmi3Float64*, std::size_t) {
    return unsupported(c);
}
