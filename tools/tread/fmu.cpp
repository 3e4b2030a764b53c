// A car as an FMU for co-simulation.
#include <fmt/format.h>

#include "base/text/text_file.h"
#include "commands.h"
#include "fmu/package/archive.h"
#include "host/parameters.h"
#include "output.h"
#include "plausibility.h"
#include "shipped_file.h"
#include "tread/load.h"

namespace tread::program {
namespace {

constexpr const char* kObject = "tread_fmu.so";

// The shared object of every FMU: installed in lib/tread (or lib/<architecture>/tread), built beside the program.
Path objectFile() {
    std::error_code none;
    const Path program = std::filesystem::read_symlink("/proc/self/exe", none).parent_path();
    std::vector<Path> places{program / kObject, program / ".." / TREAD_LIBRARY_FOLDER / "tread" / kObject};
    for (const Path& place : places)
        if (std::filesystem::exists(place, none)) return place;
    throw LoadError({{"", 0, 0, "",
                      fmt::format("the shared object of FMUs was not found at {}; install tread again, or build the "
                                  "target tread_fmu",
                                  places.back().lexically_normal().string())}});
}

std::string contentOf(const Path& file) {
    std::string fault;
    const auto content = readWholeFile(file, fault);
    if (!content) throw LoadError({{file.string(), 0, 0, "", fault}});
    return *content;
}

}  // namespace

int fmu(const FmuOptions& options) {
    const std::string vehicle = shippedFile(options.vehicle, "vehicles");
    VehicleParams car = loadVehicle(vehicle);
    host::setParameters(car, options.settings, "--set");
    warnOfImplausible(implausibleIn(car, vehicle, {{options.settings, "--set"}}));
    const auto version = options.fmi == 3 ? tread::fmu::FmiVersion::fmi3 : tread::fmu::FmiVersion::fmi2;
    const Path output =
        options.output.empty() ? Path(vehicle).filename().replace_extension(".fmu") : Path(options.output);
    const std::string bytes = tread::fmu::packed(car, contentOf(objectFile()), version);
    writeFile(output.string(), bytes);
    say(fmt::format("Wrote {}: FMI {} for co-simulation, linux x86-64, {:.1f} MB.\n", output.string(),
                    tread::fmu::nameOf(version), static_cast<double>(bytes.size()) / 1e6));
    return kYes;
}

}  // namespace tread::program
