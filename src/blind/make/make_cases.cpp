#include "blind/make/make_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "blind/detectability/case_detectability.h"
#include "blind/detectability/detectable_effects.h"
#include "blind/key/program_hash.h"
#include "blind/world/draws.h"
#include "blind/world/instruments.h"
#include "diagnose/catalogue/effect.h"
#include "log/csv.h"
#include "run/simulate.h"
#include "store/result_folder.h"
#include "tread/load.h"

namespace tread::blind::make {
namespace {

using detectability::detectabilities;
using detectability::detectableEffects;
using detectability::examination;
using diagnose::catalogue::Effect;
using drives::caseDrives;
using drives::Drive;
using drives::measure;
using faults::drawCase;
using faults::Drawing;
using faults::DrawnCase;
using key::CaseKind;
using key::Detectability;
using key::programHash;
using key::SealedKey;
using world::InstrumentSheet;
using world::instrumentSheets;
using world::OpenNumber;
using world::openNumbers;
using world::seedOf;
using world::World;

// World::assumed: 8 one, 4 two, 3 none, 3 outside, 2 small of 20.
constexpr std::array kAssumedProportions{
    CaseKind::one,  CaseKind::two, CaseKind::none, CaseKind::outside, CaseKind::one,     CaseKind::small, CaseKind::two,
    CaseKind::one,  CaseKind::one, CaseKind::none, CaseKind::outside, CaseKind::one,     CaseKind::two,   CaseKind::one,
    CaseKind::none, CaseKind::one, CaseKind::two,  CaseKind::one,     CaseKind::outside, CaseKind::small};
// World::own: 7 one, 3 two, 3 none, 3 outside, 2 mixed, 2 small of 20.
constexpr std::array kOwnProportions{CaseKind::one, CaseKind::two,   CaseKind::none,    CaseKind::outside,
                                     CaseKind::one, CaseKind::small, CaseKind::mixed,   CaseKind::one,
                                     CaseKind::one, CaseKind::none,  CaseKind::outside, CaseKind::one,
                                     CaseKind::two, CaseKind::mixed, CaseKind::none,    CaseKind::one,
                                     CaseKind::two, CaseKind::one,   CaseKind::outside, CaseKind::small};
constexpr int kMostDraws = 20;  // cars per case
enum Stream : std::uint64_t { kinds_stream, truth_stream, drives_stream };

std::uint64_t caseSeed(std::uint64_t seed, int index, Stream stream) {
    return seedOf(seedOf(seed, 16 + static_cast<std::uint64_t>(index)), stream);
}

std::string diagnosisYaml(const std::vector<CaseRecording>& recordings, bool compared) {
    std::string text = "vehicle: vehicle.yaml\nchannels:\n";
    for (const InstrumentSheet& sheet : instrumentSheets())
        text += fmt::format("  - {{channel: {}, noise: {}}}\n", sheet.channel, sheet.noise);
    text += "recordings:\n";
    for (const CaseRecording& one : recordings) {
        text += fmt::format("  - {{log: {}.csv, name: {}", one.name, one.name);
        if (compared) text += fmt::format(", reference: reference/{}.csv", one.name);
        if (one.drive->repeats > 1) text += ", repeat_group: " + one.drive->name;
        text += one.drive->hold_out ? ", hold_out: true}\n" : "}\n";
    }
    return text;
}

}  // namespace

std::vector<CaseKind> kindsOf(const Order& order) {
    const auto& proportions = order.drawing.world == World::own ? kOwnProportions : kAssumedProportions;
    std::vector<CaseKind> kinds;
    for (int i = 0; i < order.cases; ++i) {
        const auto at = static_cast<std::size_t>(i);
        kinds.push_back(order.kinds.empty() ? proportions[at % proportions.size()]
                                            : order.kinds[at % order.kinds.size()]);
    }
    // Fisher-Yates shuffle: the order tells nothing.
    Random random(seedOf(order.seed, kinds_stream));
    for (std::size_t i = kinds.size(); i > 1; --i)
        std::swap(kinds[i - 1], kinds[static_cast<std::size_t>(random.uniform() * static_cast<double>(i))]);
    return kinds;
}

void writeCase(const std::filesystem::path& place, const VehicleParams& nominal,
               const std::vector<CaseRecording>& recordings, const Driven& driven, const Driven& before) {
    makeFolder(before ? place / "reference" : place);
    for (const CaseRecording& one : recordings) {
        writeLog(place / (one.name + ".csv"), driven(one));
        if (before) writeLog(place / "reference" / (one.name + ".csv"), before(one));
    }
    writeFile(place / "vehicle.yaml", vehicleYaml(nominal));
    writeFile(place / "diagnosis.yaml", diagnosisYaml(recordings, before != nullptr));
}

std::vector<CaseRecording> recordingsOf(const std::vector<Drive>& drives, std::uint64_t seed, int index) {
    std::vector<CaseRecording> recordings;
    for (const Drive& drive : drives) {
        for (int i = 1; i <= drive.repeats; ++i) {
            const std::string name = drive.repeats > 1 ? fmt::format("{}_{}", drive.name, i) : drive.name;
            recordings.push_back({name, &drive, seedOf(caseSeed(seed, index, drives_stream), recordings.size())});
        }
    }
    return recordings;
}

DrawnCase drawnCase(std::uint64_t seed, int index, CaseKind kind, const VehicleParams& nominal,
                    const std::vector<Effect>& effects, int draw, const Drawing& drawing) {
    Random random(seedOf(caseSeed(seed, index, truth_stream), static_cast<std::uint64_t>(draw)));
    DrawnCase drawn = drawCase(nominal, effects, kind, random, drawing);
    drawn.key.name = fmt::format("case_{:03}", index + 1);
    drawn.key.draw = draw;
    return drawn;
}

SealedKey makeCases(const Order& order, const VehicleParams& nominal, const std::vector<Effect>& effects,
                    const std::filesystem::path& folder, const std::function<void(int cases)>& progress) {
    SealedKey key;
    key.tread_version = order.tread_version;
    key.program = programHash();
    key.seed = order.seed;
    key.vehicle = order.vehicle;
    key.drives = order.drives;
    key.world = order.drawing.world;
    key.frozen = order.drawing.frozen;
    const std::vector<Drive> drives = caseDrives(order.drives);
    const std::vector<CaseKind> kinds = kindsOf(order);
    const std::vector<Effect> shown = detectableEffects(nominal, effects, drives);
    const std::vector<OpenNumber> open = openNumbers({.vehicle = nominal, .road = {}, .wind = {}, .instruments = {}});
    const auto examine = [&](const DrawnCase& drawn) {
        if (drawn.without.empty()) return std::map<std::string, Detectability>{};
        return detectabilities(examination(drawn.healthy.car, drives, open, effects), drawn);
    };
    for (int i = 0; i < order.cases; ++i) {
        const CaseKind kind = kinds[static_cast<std::size_t>(i)];
        for (int draw = 0;; ++draw) {
            DrawnCase drawn = drawnCase(order.seed, i, kind, nominal, shown, draw, order.drawing);
            try {
                writeCase(folder / drawn.key.name, nominal, recordingsOf(drives, order.seed, i),
                          [&](const CaseRecording& one) { return measure(drawn.truth, *one.drive, one.seed); });
                drawn.key.shows = examine(drawn);
                key.cases.push_back(drawn.key);
                break;
            } catch (const SimulationError&) {  // undrivable, for instance it spins
                if (draw == kMostDraws) throw;
            }
        }
        progress(i + 1);
    }
    return key;
}

}  // namespace tread::blind::make
