#include "diagnose/model/sensitivity_cache.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <span>
#include <string>
#include <vector>

#include "base/text/byte_limit.h"
#include "base/text/text_file.h"
#include "base/yaml/write.h"
#include "store/sha256.h"
#include "store/whole_file.h"

namespace tread::diagnose::model {
namespace {

using Path = std::filesystem::path;

std::string bytesOf(const Path& file) {
    std::string fault;
    return readWholeFile(file, fault).value_or("");
}

// Builds of the same version may compute different values, so the program itself is hashed. Empty when it cannot be
// read.
const std::string& programHash() {
    static const std::string hash = [] {
        const std::string bytes = bytesOf("/proc/self/exe");
        return bytes.empty() ? bytes : sha256(bytes);
    }();
    return hash;
}

void add(std::string& text, std::span<const double> values) {
    text.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
    text += ';';
}

void add(std::string& text, const std::string& word) {
    text += std::to_string(word.size()) + ":" + word;
}

std::string recordingText(const RecordedDrive& drive) {
    const recording::Recording& told = *drive.recording;
    std::string text;
    add(text, writeYaml(told.road));
    add(text, writeYaml(told.wind));
    text += enumNames(told.speed)[static_cast<std::size_t>(told.speed)];
    add(text, std::span(&told.followed_for, 1));
    for (const Channel& channel : drive.log.channels) {
        add(text, channel.name);
        add(text, channel.values);
    }
    for (const recording::ObservedChannel& channel : drive.channels) add(text, channel.name);
    return text;
}

// A file holds the values of the column, then the number of its simulations.
DrivenColumn read(const Path& file, Eigen::Index rows) {
    const std::string bytes = bytesOf(file);
    Eigen::VectorXd all(rows + 1);
    const std::span<double> values(all.data(), all.size());
    if (bytes.size() != values.size_bytes() || rows == 0) return {};
    std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(values.data()));
    if (!all.allFinite()) return {};
    std::error_code ignored;
    std::filesystem::last_write_time(file, std::filesystem::file_time_type::clock::now(), ignored);
    return {all.head(rows), static_cast<int>(all(rows))};
}

// A disk without room costs simulations, not the answer.
void write(const Path& file, const DrivenColumn& column) {
    Eigen::VectorXd all(column.values->size() + 1);
    all << *column.values, static_cast<double>(column.simulations);
    const std::span<const double> values(all.data(), all.size());
    std::error_code ignored;
    std::filesystem::create_directories(file.parent_path(), ignored);
    try {
        writeFile(file, {reinterpret_cast<const char*>(values.data()), values.size_bytes()});
    } catch (const FileError&) {
        return;
    }
    static std::atomic<std::uintmax_t> added{0};
    const std::uintmax_t most = largestCache(), sum = added += values.size_bytes();
    if (sum < most / 8) return;
    added = 0;
    trimCache(file.parent_path().parent_path(), most);
}

}  // namespace

Path columnFolder(const Replays& replays, const RecordedDrive& drive, const Subject& subject) {
    if (replays.cache.empty() || programHash().empty()) return {};
    std::string text;
    add(text, programHash());
    add(text, writeYaml(replays.nominal()));
    add(text, writeYaml(subject));
    add(text, std::span<const double>(&replays.replayer.step, 1));
    add(text, recordingText(drive));
    return replays.cache / sha256(text);
}

DrivenColumn keptColumn(const Path& folder, const Parameter& parameter, double by, Eigen::Index rows,
                        const std::function<DrivenColumn()>& make) {
    if (folder.empty() || parameter.instruments_only) return make();
    std::string text;
    for (const Parameter::Move& move : parameter.moves) {
        add(text, move.path);
        add(text, std::array{move.nominal, move.by});
    }
    add(text, std::array{by});
    const Path file = folder / sha256(text);
    DrivenColumn column = read(file, rows);
    if (column.values) return column;
    column = make();
    if (column.values) write(file, column);
    return column;
}

std::uintmax_t largestCache() {
    return byteLimit("TREAD_LARGEST_CACHE", std::size_t{1} << 30);
}

void trimCache(const Path& cache, std::uintmax_t most) {
    struct Kept {
        std::filesystem::file_time_type used;
        std::uintmax_t bytes;
        Path file;
    };
    std::vector<Kept> all;
    std::uintmax_t sum = 0;
    std::error_code error, ignored;
    std::filesystem::recursive_directory_iterator entry(cache, error);
    for (; !error && entry != std::filesystem::recursive_directory_iterator(); entry.increment(error)) {
        if (!entry->is_regular_file(ignored)) continue;
        const std::uintmax_t bytes = entry->file_size(ignored);
        if (ignored) continue;
        all.push_back({entry->last_write_time(ignored), bytes, entry->path()});
        sum += bytes;
    }
    std::sort(all.begin(), all.end(), [](const Kept& a, const Kept& b) { return a.used < b.used; });
    for (const Kept& kept : all) {
        if (sum <= most) break;
        if (std::filesystem::remove(kept.file, ignored)) sum -= kept.bytes;
    }
}

}  // namespace tread::diagnose::model
