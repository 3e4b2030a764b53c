#include "fmu/package/archive.h"

#include <zip.h>

#include <memory>
#include <stdexcept>

#include "base/text/concat.h"
#include "fmu/variables.h"
#include "tread/load.h"

namespace tread::fmu {
namespace {

// The first moment that a zip file knows: 1 January 1980, 00:00.
constexpr zip_uint16_t kDate = (1 << 5) | 1, kTime = 0;
// Of zlib, 1 to 9: its usual one; the library's, 9, takes three times as long for 1 % less.
constexpr zip_uint32_t kLevel = 6;

struct Fault {
    Fault() { zip_error_init(&error); }
    ~Fault() { zip_error_fini(&error); }
    Fault(const Fault&) = delete;
    Fault& operator=(const Fault&) = delete;

    [[noreturn]] void raise() { raise(&error); }
    [[noreturn]] static void raise(zip_error_t* of) {
        throw std::runtime_error(concat({"cannot write a zip file: ", zip_error_strerror(of)}));
    }

    zip_error_t error;
};

void add(zip_t* archive, const ArchivedFile& file) {
    zip_source_t* source = zip_source_buffer(archive, file.content.data(), file.content.size(), 0);
    const zip_int64_t index = source ? zip_file_add(archive, file.name.c_str(), source, ZIP_FL_ENC_UTF_8) : -1;
    if (index < 0) {
        zip_source_free(source);
        Fault::raise(zip_get_error(archive));
    }
    const auto entry = static_cast<zip_uint64_t>(index);
    if (zip_file_set_dostime(archive, entry, kTime, kDate, 0) < 0 ||
        zip_set_file_compression(archive, entry, ZIP_CM_DEFLATE, kLevel) < 0)
        Fault::raise(zip_get_error(archive));
}

std::string contentOf(zip_source_t* source) {
    zip_stat_t about;
    zip_stat_init(&about);
    if (zip_source_stat(source, &about) < 0 || zip_source_open(source) < 0) Fault::raise(zip_source_error(source));
    std::string bytes(about.size, '\0');
    const zip_int64_t got = zip_source_read(source, bytes.data(), bytes.size());
    zip_source_close(source);
    if (got != static_cast<zip_int64_t>(bytes.size())) Fault::raise(zip_source_error(source));
    return bytes;
}

}  // namespace

std::string zipped(const std::vector<ArchivedFile>& files) {
    Fault fault;
    const std::unique_ptr<zip_source_t, decltype(&zip_source_free)> target(
        zip_source_buffer_create(nullptr, 0, 0, &fault.error), zip_source_free);
    if (!target) fault.raise();
    zip_source_keep(target.get());  // the archive takes one of both owners
    zip_t* archive = zip_open_from_source(target.get(), ZIP_CREATE | ZIP_TRUNCATE, &fault.error);
    if (!archive) {
        zip_source_free(target.get());
        fault.raise();
    }
    try {
        for (const ArchivedFile& file : files) add(archive, file);
        if (zip_close(archive) < 0) Fault::raise(zip_get_error(archive));
    } catch (...) {
        zip_discard(archive);
        throw;
    }
    return contentOf(target.get());
}

std::string packed(const VehicleParams& car, std::string object, FmiVersion version) {
    const std::string text = vehicleYaml(car);
    const std::string_view platform = version == FmiVersion::fmi2 ? "linux64" : "x86_64-linux";
    return zipped({{"modelDescription.xml", modelDescription(car, text, version)},
                   {concat({"resources/", kCarFile}), text},
                   {concat({"binaries/", platform, "/", kModelIdentifier, ".so"}), std::move(object)}});
}

}  // namespace tread::fmu
