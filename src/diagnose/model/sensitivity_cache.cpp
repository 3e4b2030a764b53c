#include "diagnose/model/sensitivity_cache.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <span>

#include "base/write_yaml.h"
#include "store/sha256.h"

namespace tread::diagnose::model {
namespace {

using Path = std::filesystem::path;

std::string bytesOf(const Path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
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

std::optional<Eigen::VectorXd> read(const Path& file, Eigen::Index rows) {
    const std::string bytes = bytesOf(file);
    Eigen::VectorXd column(rows);
    const std::span<double> values(column.data(), rows);
    if (bytes.size() != values.size_bytes() || rows == 0) return std::nullopt;
    std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(values.data()));
    if (!column.allFinite()) return std::nullopt;
    return column;
}

// Written under another name and then renamed, so that an interruption leaves no incomplete column.
void write(const Path& file, const Eigen::VectorXd& column) {
    static std::atomic<std::uint64_t> count{0};
    const Path part = file.string() + "." + std::to_string(getpid()) + "." + std::to_string(count++) + ".part";
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    std::ofstream stream(part, std::ios::binary);
    const auto bytes = std::as_bytes(std::span<const double>(column.data(), column.size()));
    stream.write(reinterpret_cast<const char*>(bytes.data()), std::ssize(bytes));
    stream.close();
    if (stream) std::filesystem::rename(part, file, error);
    if (!stream || error) std::filesystem::remove(part, error);
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

std::optional<Eigen::VectorXd> keptColumn(const Path& folder, const Parameter& parameter, double by, Eigen::Index rows,
                                          const std::function<std::optional<Eigen::VectorXd>()>& make) {
    if (folder.empty() || parameter.instruments_only) return make();
    std::string text;
    for (const Parameter::Move& move : parameter.moves) {
        add(text, move.path);
        add(text, std::array{move.nominal, move.by});
    }
    add(text, std::array{by});
    const Path file = folder / sha256(text);
    if (std::optional<Eigen::VectorXd> column = read(file, rows)) return column;
    const std::optional<Eigen::VectorXd> column = make();
    if (column) write(file, *column);
    return column;
}

}  // namespace tread::diagnose::model
