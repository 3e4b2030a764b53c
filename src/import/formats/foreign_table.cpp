#include "import/formats/foreign_table.h"

#include <algorithm>
#include <cctype>

#include "log/csv.h"
#include "log/mcap_format.h"

namespace tread {
namespace {

constexpr std::size_t kProbe = 4096;  // where a file says what it is

std::string lowerExtension(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

// Formats that tread does not read, by how their files begin or are called, and what makes one of them that it reads.
struct Unread {
    std::string_view magic, extension, other_extension, what, instead;
};
constexpr Unread kUnread[] = {
    {"MDF     ", ".mf4", ".mdf", "an ASAM MDF measurement, which tread does not read",
     "make a MATLAB file of it with asammdf, in Python `asammdf.MDF(file).export('mat')`, or a CSV file, and import "
     "that"},
    {"UnFinMF ", ".mf4", ".mdf", "an ASAM MDF measurement that was not finished, which tread does not read",
     "make a MATLAB or CSV file of it with asammdf and import that"},
    {"#ROSBAG V", ".bag", ".bag", "a bag of ROS 1, which tread does not read",
     "make an MCAP file of it with `mcap convert drive.bag drive.mcap` (mcap.dev) and import that"},
    {std::string_view("SQLite format 3\0", 16), ".db3", ".db3", "a bag of ROS 2 in SQLite, which tread does not read",
     "make an MCAP file of it with `ros2 bag convert` (in its options: storage_id: mcap) and import that"},
};

void refuseUnread(std::string_view beginning, const std::string& extension, const std::string& file) {
    for (const Unread& format : kUnread) {
        const bool named = extension == format.extension || extension == format.other_extension;
        if (!beginning.starts_with(format.magic) && !named) continue;
        throw LoadError({{file, 0, 0, "", "found " + std::string(format.what) + "; " + std::string(format.instead)}});
    }
}

}  // namespace

ForeignTable readForeignTable(const std::filesystem::path& file) {
    std::string text = readBytes(file);
    const std::string extension = lowerExtension(file);
    const std::string_view beginning = std::string_view(text).substr(0, kProbe);
    refuseUnread(beginning, extension, file.string());
    if (extension == ".mcap" || beginning.starts_with(mcap::kMagic)) return parseMcap(text, file.string());
    if (extension == ".mat" || beginning.starts_with("MATLAB ")) return readMat(file);
    if (extension == ".vbo" || beginning.find("[header]") != std::string_view::npos) {
        return parseVbo(std::move(text), file.string());
    }
    return parseForeignCsv(std::move(text), file.string());
}

}  // namespace tread
