#include "shipped_file.h"

#include <dlfcn.h>

namespace tread::program {
namespace {

// The file that holds this function: the program, or a library that was loaded.
Path ownFile() {
    std::error_code none;
    Dl_info found{};
    if (dladdr(reinterpret_cast<const void*>(&shippedFolder), &found) != 0 && found.dli_fname) {
        const Path file = std::filesystem::canonical(found.dli_fname, none);
        if (file.extension() == ".so") return file;
    }
    return std::filesystem::read_symlink("/proc/self/exe", none);
}

}  // namespace

Path shippedFolder(const std::string& name) {
    // Both folders are told from others of the same name by a file that is always there.
    const Path known = name == "vehicles" ? "compact.yaml" : "step_steer_80.yaml";
    if (std::filesystem::exists(Path(name) / known)) return name;
    Path folder = ownFile().parent_path();
    while (!folder.empty() && folder != folder.root_path()) {
        for (const Path& here : {folder / name, folder / "share/tread" / name})
            if (std::filesystem::exists(here / known)) return here;
        folder = folder.parent_path();
    }
    return {};
}

std::optional<Path> shippedFileNamed(const std::string& name, const std::string& folder) {
    const Path within = folder, top = *within.begin();
    const Path there = shippedFolder(top.string());
    const Path file = there / within.lexically_relative(top) / (name + ".yaml");
    if (there.empty() || !std::filesystem::exists(file)) return std::nullopt;
    return file;
}

std::string shippedFile(const std::string& given, const std::string& folder) {
    const Path path = given;
    if (given.empty() || path.has_parent_path() || path.has_extension() || std::filesystem::exists(path)) return given;
    const std::optional<Path> shipped = shippedFileNamed(given, folder);
    return shipped ? shipped->string() : given;
}

}  // namespace tread::program
