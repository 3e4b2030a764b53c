// An FMU as the zip file that masters open.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fmu/package/model_description.h"

namespace tread::fmu {

struct ArchivedFile {
    std::string name;  // within the archive
    std::string content;
};

// The bytes of a zip file: the same files give the same bytes. Throws std::runtime_error when the library cannot.
std::string zipped(const std::vector<ArchivedFile>& files);

// The FMU of a car; `object` is the content of the shared object.
std::string packed(const VehicleParams& car, std::string object, FmiVersion version);

}  // namespace tread::fmu
