// The task of a diagnosis: diagnosis.yaml.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "log/log.h"
#include "recording/instruments.h"
#include "recording/subject.h"
#include "scenario/wind.h"
#include "store/named_file.h"
#include "tread/describe.h"
#include "tread/road_params.h"

namespace tread::recording {

// One measured channel: its name in the log and its noise.
struct MeasuredChannel {
    std::string channel;
    std::string column = {};
    std::string unit = {};
    double noise = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(channel), About{"", "channel name in tread, e.g. chassis.yaw_rate"});
        field(TREAD_FIELD(column), About{"", "column name in the log; empty: same as the channel"});
        field(TREAD_FIELD(unit),
              About{"", "unit of the column if the log header has none; empty: unit from the header"});
        field(TREAD_FIELD(noise),
              About{"-", "standard deviation of one sample, SI; 0: estimated from the log", kNonNegative});
    }
};
static_assert(describesEveryMember<MeasuredChannel>());

// How the speed is controlled in the replay.
enum class SpeedReplay { pedals, followed, command };
constexpr auto enumNames(SpeedReplay) {
    return std::array<std::string_view, 3>{"pedals", "followed", "command"};
}

struct Recording {
    std::string log;
    std::string name = {};
    SpeedReplay speed = SpeedReplay::pedals;
    double followed_for = 0;
    double from = 0;
    double to = kInfinity;
    std::string repeat_group = {};
    std::string reference = {};
    double reference_later = 0;
    bool hold_out = false;
    RoadParams road = {};
    WindParams wind = {};

    // s, time until which the replay follows the measured speed: infinity if it does so throughout.
    double followedUntil() const { return speed == SpeedReplay::followed ? kInfinity : followed_for; }

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(log), About{"", "log of the real car (CSV, VBO or MAT), relative to this file"});
        field(TREAD_FIELD(name), About{"", "name in the report; empty: file name of the log"});
        field(TREAD_FIELD(speed),
              About{"",
                    "pedals: replay throttle and brake; followed: a force at the wheels makes the car follow the "
                    "measured speed; command: replay command.force or command.acceleration"});
        field(TREAD_FIELD(followed_for),
              About{"s",
                    "time from the start of the window over which the measured speed is followed before pedals or "
                    "command act; speed and longitudinal acceleration are compared after it",
                    kNonNegative});
        field(TREAD_FIELD(from), About{"s", "start of the window that is used"});
        field(TREAD_FIELD(to), About{"s", "end of the window that is used"});
        field(TREAD_FIELD(repeat_group), About{"", "common name of repeated recordings of one manoeuvre"});
        field(TREAD_FIELD(reference),
              About{"",
                    "log of the same drive before the car was changed, if there is one; the gap "
                    "between model and reference is subtracted"});
        field(TREAD_FIELD(reference_later),
              About{"s", "delay of the reference: time by which it lags the log of the same drive"});
        field(TREAD_FIELD(hold_out), About{"", "used only to judge how far the gap shrinks, not to find the cause"});
        field(TREAD_FIELD(road), About{"", "known properties of the road"});
        field(TREAD_FIELD(wind), About{"", "known wind"});
    }

    static void check(const auto& self, auto&& complain) {
        if (self.log.empty()) complain("log", "found no log, expected the file name of a log");
        if (!(self.from < self.to))
            complain("to", "found a window that does not end after its start, expected from < to");
        if (self.reference.empty() && self.reference_later != 0)
            complain("reference_later", "found a time without a reference, expected the log of the reference");
    }
};
static_assert(describesEveryMember<Recording>());

// How well a number is known, in place of the tolerance in its description.
struct KnownWithin {
    std::string path;
    double relative = 0;
    double absolute = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(path), About{"", "path of a number; * matches any characters, e.g. front.tyre.lambda.*"});
        field(TREAD_FIELD(relative), About{"-", "known to within this fraction of its value", kNonNegative});
        field(TREAD_FIELD(absolute), About{"-", "known to within this amount, in its SI unit", kNonNegative});
    }

    static void check(const auto& self, auto&& complain) {
        if (self.path.empty()) complain("path", "found no path, expected the path of a number, e.g. mass");
    }
};
static_assert(describesEveryMember<KnownWithin>());

// Treatment of a channel that cannot belong to the same rigid body as the others.
enum class Contradictions { leave_out, keep };
constexpr auto enumNames(Contradictions) {
    return std::array<std::string_view, 2>{"leave_out", "keep"};
}

struct DiagnosisFile {
    std::string vehicle;
    std::vector<std::string> vehicle_settings = {};
    std::string import = {};
    std::vector<MeasuredChannel> channels = {};
    std::vector<Recording> recordings;
    std::vector<Recording> before = {};
    std::vector<KnownWithin> tolerances = {};
    Instruments instruments;
    std::vector<std::string> effects = {};
    std::string own_effects;
    std::vector<std::string> fit = {};
    double step = 0.004;
    Contradictions contradictions = Contradictions::leave_out;
    double windows = 6;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(vehicle),
              About{"", "file of the nominal car, relative to this file, or the name of a shipped one"});
        field(TREAD_FIELD(vehicle_settings), About{"", "changes to the nominal car, each path=value"});
        field(
            TREAD_FIELD(import),
            About{"", "mapping for foreign logs (see tread import), relative to this file; none: guessed from names"});
        field(TREAD_FIELD(channels), About{"", "measured channels; none: all channels of the logs that tread knows"});
        field(TREAD_FIELD(recordings), About{"", "drives of the real car"});
        field(TREAD_FIELD(before),
              About{"",
                    "drives of the car before it was changed, to which the nominal car is fitted first; unlike a "
                    "reference, they may be other drives than the recordings, and nothing is subtracted"});
        field(TREAD_FIELD(tolerances), About{"", "how accurately numbers of the car are known"});
        field(TREAD_FIELD(instruments), About{"", "known properties of the instruments"});
        field(TREAD_FIELD(effects), About{"", "effects to consider; * matches any characters; none: all effects"});
        field(TREAD_FIELD(own_effects), About{"", "file with additional effects, relative to this file"});
        field(TREAD_FIELD(fit),
              About{"", "numbers that `tread identify` fits; * matches any characters, e.g. front.tyre.lambda.Ky"});
        field(TREAD_FIELD(step), About{"s", "time step of the replay", {1e-4, 0.01}});
        field(TREAD_FIELD(contradictions),
              About{"", "leave_out: channels that contradict the others as motion of one rigid body are not used"});
        field(TREAD_FIELD(windows), About{"-",
                                          "number of 20 s windows that are used from a recording of more than 180 s: "
                                          "those with the largest accelerations; 0: the whole recording",
                                          {0, 1000}});
    }

    static void check(const auto& self, auto&& complain) {
        if (self.vehicle.empty()) complain("vehicle", "found no vehicle, expected the file of the nominal car");
        if (self.recordings.empty())
            complain("recordings", "found no recording, expected the log of at least one drive of the real car");
    }
};
static_assert(describesEveryMember<DiagnosisFile>());

// Throws LoadError. File names are resolved relative to the file's folder, those of logs relative to `data` if given,
// that of a shipped car if told how.
DiagnosisFile loadDiagnosis(const std::filesystem::path& file, const std::filesystem::path& data = {},
                            const ShippedFiles& shipped = {});

// The same without checking that the logs exist.
DiagnosisFile checkedDiagnosis(const std::filesystem::path& file, const ShippedFiles& shipped = {});

// ---- Files that it names. Each function throws LoadError that lists every fault. ----

// The nominal car with its settings, and the instruments of the file.
Subject nominalSubject(const DiagnosisFile& file);

// The recordings in the order of the file: channels under tread's names in SI units, cut to the window, time from 0.
// `notes`: what was changed or guessed, one sentence each.
struct Recorded {
    std::vector<Log> logs;
    std::vector<Log> references = {};  // as many as logs, or none; an empty log where a recording has no reference
    std::vector<Log> before = {};      // as many as the file names
    std::vector<std::string> notes = {};
};
Recorded readRecordings(const DiagnosisFile& file);

}  // namespace tread::recording
