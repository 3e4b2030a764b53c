#include "campaign/folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <system_error>

#include "base/text/number_text.h"
#include "base/text/trimmed.h"
#include "log/csv.h"
#include "store/result_folder.h"
#include "store/whole_file.h"
#include "tread/problem.h"

namespace tread::campaign {
namespace {

std::vector<std::string_view> linesOf(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size() - 1);
        lines.push_back(text.substr(0, end + (text[end] == '\n' ? 0 : 1)));
        text.remove_prefix(end + 1);
    }
    return lines;
}

// The keys and list elements that enclose a line of a YAML text, by their indentation: "vehicles: vehicle: mass".
std::string placeOf(const std::vector<std::string_view>& lines, std::size_t line) {
    std::string place;
    std::size_t limit = std::string_view::npos;
    for (std::size_t i = line + 1; i-- > 0 && limit != 0;) {
        const std::size_t indent = lines[i].find_first_not_of(" -");
        if (indent == std::string_view::npos || indent >= limit) continue;
        const std::string_view key = trimmed(lines[i].substr(indent));
        const std::size_t colon = key.find(':');
        limit = indent;
        if (i == line || colon == std::string_view::npos) continue;
        place = std::string(key.substr(0, colon)) + (place.empty() ? "" : ".") + place;
    }
    return place;
}

// Calls that begin in one folder look into it one after the other, where its file system knows locks.
class OneAtATime {
public:
    explicit OneAtATime(const Path& folder) : folder_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
        while (folder_ >= 0 && flock(folder_, LOCK_EX) != 0 && errno == EINTR) {
        }
    }
    ~OneAtATime() {
        if (folder_ >= 0) close(folder_);
    }
    OneAtATime(const OneAtATime&) = delete;
    OneAtATime& operator=(const OneAtATime&) = delete;

private:
    int folder_;
};

}  // namespace

Path inputsFile(const Path& folder) {
    return folder / "inputs.yaml";
}

Path pieceFile(const Path& folder, const Plan& plan, std::uint64_t piece) {
    const std::uint64_t first = plan.firstOf(piece);
    return folder / "pieces" / fmt::format("{:09}-{:09}.piece", first, first + plan.countOf(piece) - 1);
}

void openFolder(const Path& folder, const Plan& plan) {
    makeFolder(folder);
    makeFolder(folder / "pieces");
    const OneAtATime only(folder);
    const Path file = inputsFile(folder);
    if (std::filesystem::exists(file)) {
        const std::string before = readBytes(file);
        if (before == plan.identity) return;
        throw LoadError({{file.string(), 0, 0, "",
                          "found the results of another campaign: " + firstDifference(before, plan.identity) +
                              "; choose another folder with -o, or remove this one"}});
    }
    if (std::filesystem::exists(folder / "results.csv")) {
        throw LoadError({{folder.string(), 0, 0, "",
                          "found results without inputs.yaml, expected an empty folder; choose another with -o"}});
    }
    writeFile(file, plan.identity);
}

std::string firstDifference(std::string_view before, std::string_view now) {
    const std::vector<std::string_view> old_lines = linesOf(before), new_lines = linesOf(now);
    for (std::size_t i = 0; i < std::max(old_lines.size(), new_lines.size()); ++i) {
        const std::string_view had = i < old_lines.size() ? old_lines[i] : "";
        const std::string_view has = i < new_lines.size() ? new_lines[i] : "";
        if (had == has) continue;
        const std::string place = i < new_lines.size() ? placeOf(new_lines, i) : placeOf(old_lines, i);
        return fmt::format("{}it has {} in line {}, this one has {}", place.empty() ? "" : "in " + place + " ",
                           had.empty() ? "nothing" : quote(trimmed(had)), i + 1,
                           has.empty() ? "nothing" : quote(trimmed(has)));
    }
    return {};
}

std::vector<bool> piecesPresent(const Path& folder, const Plan& plan) {
    std::vector<bool> present(plan.pieces());
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "pieces", error)) {
        const std::string name = entry.path().filename().string();
        std::uint64_t first = 0;
        std::from_chars(name.data(), name.data() + name.size(), first);
        if (first >= plan.runs || first % plan.runs_per_piece != 0) continue;
        const std::uint64_t piece = first / plan.runs_per_piece;
        if (name == pieceFile(folder, plan, piece).filename()) present[piece] = true;
    }
    if (error && error != std::errc::no_such_file_or_directory)
        throw FileError(fmt::format("cannot read the folder {}: {}", (folder / "pieces").string(), error.message()));
    return present;
}

void removeAllLeftovers(const Path& folder) {
    for (const Path& place : {folder, folder / "pieces", folder / "logs"}) removeLeftovers(place);
}

}  // namespace tread::campaign
