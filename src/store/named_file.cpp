#include "store/named_file.h"

namespace tread {

std::string namedFile(const std::filesystem::path& beside, const std::string& name, const ShippedFiles& shipped,
                      const std::string& folder) {
    if (name.empty()) return name;
    const std::filesystem::path given = name, file = (beside / given).lexically_normal();
    const bool plain = !given.has_parent_path() && !given.has_extension();
    if (shipped && plain && (!std::filesystem::exists(file) || std::filesystem::is_directory(file))) {
        if (const std::optional<std::filesystem::path> found = shipped(name, folder)) return found->string();
    }
    return file.string();
}

}  // namespace tread
