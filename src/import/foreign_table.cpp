#include "import/foreign_table.h"

#include <algorithm>
#include <cctype>

#include "log/csv.h"

namespace tread {
namespace {

constexpr std::size_t kProbe = 4096;  // where a file says what it is

std::string lowerExtension(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

}  // namespace

ForeignTable readForeignTable(const std::filesystem::path& file) {
    std::string text = readBytes(file);
    const std::string extension = lowerExtension(file);
    const std::string_view beginning = std::string_view(text).substr(0, kProbe);
    if (extension == ".mat" || beginning.starts_with("MATLAB ")) return readMat(file);
    if (extension == ".vbo" || beginning.find("[header]") != std::string_view::npos) {
        return parseVbo(std::move(text), file.string());
    }
    return parseForeignCsv(std::move(text), file.string());
}

}  // namespace tread
