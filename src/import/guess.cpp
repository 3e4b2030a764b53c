// A mapping from the names that people give to the channels of a car. What is guessed is written out in full, so that a
// person can correct it.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>

#include "base/math/median.h"
#include "base/units/units.h"
#include "base/yaml/write.h"
#include "import/channel_names.h"
#include "import/columns.h"
#include "import/formats/unit_spelling.h"
#include "import/import.h"
#include "import/relations.h"
#include "import/vehicle_reach.h"
#include "log/log_columns.h"
#include "tread/wheels.h"

namespace tread {
namespace {

struct Alias {
    std::string_view channel;
    std::vector<std::string_view> names;  // small letters and digits only; the first that the file has is taken
    std::string_view unit = "";           // of a channel that is no column of tread's own logs
};

// As VBOX, CAN descriptions, ROS messages and textbooks call them.
const std::vector<Alias>& aliases() {
    static const std::vector<Alias> list = {
        {"time",
         {"time", "t", "times", "timestamp", "timestamps", "timesec", "elapsedtime", "elapsed", "zeit", "rectime",
          "tout", "utctime", "logtime", "headerstamp", "stamp"}},
        {"driver.steering_wheel_angle",
         {"steeringwheelangle",
          "steeringwheel",
          "steeringangle",
          "steerangle",
          "steerang",
          "steeringang",
          "strang",
          "strangle",
          "handwheelangle",
          "handwheel",
          "swa",
          "swangle",
          "stwa",
          "stwangle",
          "steerwheelangle",
          "steeringwheelang",
          "steeringwheelpos",
          "steeringwheelposition",
          "steering",
          "steer",
          "strgwhlang",
          "strwhlang",
          "strwhlangle",
          "sas",
          "sasangle",
          "lws",
          "lwsangle",
          "deltah",
          "deltasw",
          "deltaswa",
          "lenkradwinkel",
          "lenkwinkel",
          "steeringtireangle",
          "delta"}},
        {"driver.throttle",
         {"throttle",
          "throttlepedal",
          "throttlepos",
          "throttleposition",
          "acceleratorpedal",
          "accelpedal",
          "accelpedalpos",
          "accelpos",
          "acceleratorposition",
          "acceleratorpedalposition",
          "accpedal",
          "accrpedl",
          "accrpedln",
          "pedalposition",
          "pedalpos",
          "tps",
          "apps",
          "gas",
          "gaspedal",
          "fahrpedal"}},
        {"driver.brake",
         {"brake", "brakepedal", "brakeposition", "brakepos", "brakepedalposition", "brakepedalpos", "brkpedl",
          "brakecmd", "bremspedal"}},
        {"driver.clutch", {"clutch", "clutchpedal", "clutchposition", "clutchpos"}},
        {"brakes.pressure",
         {"brakepressure", "brakepress", "brkpress", "brkpressure", "pbrake", "pbrk", "brakep",
          "mastercylinderpressure", "mcpressure", "pmc", "brakefluidpressure", "brakepressurefront",
          "frontbrakepressure", "bremsdruck"},
         "Pa"},
        {"chassis.vx",
         {"vx",
          "vxcg",
          "longitudinalvelocity",
          "longitudinalspeed",
          "longvel",
          "lngvel",
          "velx",
          "velocityx",
          "linearx",
          "xvelocity",
          "u",
          "vehspdlgt",
          "vehiclespeed",
          "vehspeed",
          "velocity",
          "velocitykmh",
          "groundspeed",
          "gpsspeed",
          "speed",
          "vehspd",
          "vveh",
          "vcar",
          "vego",
          "vel",
          "geschwindigkeit",
          "v"}},
        {"chassis.vy",
         {"vy", "vycg", "lateralvelocity", "lateralspeed", "latvel", "vely", "velocityy", "lineary", "yvelocity"}},
        {"chassis.yaw_rate",
         {"yawrate",  "yawvelocity", "yawvel", "yawratez", "yawr",     "yr",       "psidot",  "psip",
          "dpsi",     "gyroz",       "gyrz",   "wz",       "omegaz",   "ratez",    "zrate",   "angularvelocityz",
          "angularz", "angvelz",     "omega",  "r",        "yawrate1", "yawspeed", "gierrate"}},
        {"chassis.roll_rate",
         {"rollrate", "rollvelocity", "rollvel", "gyrox", "gyrx", "wx", "omegax", "ratex", "xrate", "angularvelocityx",
          "angularx", "phidot", "p", "rollrate1"}},
        {"chassis.pitch_rate",
         {"pitchrate", "pitchvelocity", "pitchvel", "gyroy", "gyry", "wy", "omegay", "ratey", "yrate",
          "angularvelocityy", "angulary", "thetadot", "q"}},
        {"chassis.ax",
         {"ax",
          "axcg",
          "accx",
          "accelx",
          "accelerationx",
          "xaccel",
          "xacc",
          "imuax",
          "longitudinalacceleration",
          "longitudinalaccel",
          "longaccel",
          "longacc",
          "lngacc",
          "lngaccel",
          "accelerationlongitudinal",
          "linearaccelerationx",
          "glong",
          "longg",
          "longaccelg",
          "algt",
          "algt1"}},
        {"chassis.ay",
         {"ay",
          "aycg",
          "accy",
          "accely",
          "accelerationy",
          "yaccel",
          "yacc",
          "imuay",
          "lateralacceleration",
          "lateralaccel",
          "lataccel",
          "latacc",
          "accelerationlateral",
          "linearaccelerationy",
          "glat",
          "latg",
          "lataccelg",
          "alat",
          "alat1",
          "querbeschleunigung"}},
        {"chassis.az",
         {"az", "azcg", "verticalacceleration", "vertacc", "vertaccel", "accz", "accelz", "accelerationz", "zaccel",
          "zacc", "linearaccelerationz"}},
        {"chassis.roll", {"roll", "rollangle", "rollang", "rollimu", "phi"}},
        {"chassis.pitch", {"pitch", "pitchangle", "pitchang", "pitchimu"}},
        {"chassis.yaw", {"yaw", "yawangle", "psi", "heading", "headingangle", "trueheading", "truehead", "course"}},
        {"chassis.sideslip",
         {"sideslip", "sideslipangle", "bodyslip", "bodyslipangle", "beta", "betacg", "slipcog", "slipangle"}},
        {"command.acceleration", {"driveacceleration"}},  // of Ackermann messages
        {"position.x", {"posepositionx"}},
        {"position.y", {"posepositiony"}},
        {"driveline.engine_speed",
         {"enginespeed", "enginerpm", "engspd", "engn", "rpm", "nmot", "neng", "motorspeed", "motordrehzahl"}},
        {"driveline.gear", {"gear", "ptgearact", "gearnumber", "currentgear", "gearposition", "gang"}}};
    return list;
}

// Known, but nothing that a log of tread has a place for.
constexpr std::string_view kPositions[] = {"lat", "latitude", "long", "lon", "lng", "longitude"};

struct WheelCode {
    std::string_view wheel;
    std::vector<std::string_view> codes;
};
const std::vector<WheelCode>& wheelCodes() {
    static const std::vector<WheelCode> list = {{"front_left", {"fl", "lf", "frontleft", "leftfront", "vl"}},
                                                {"front_right", {"fr", "rf", "frontright", "rightfront", "vr"}},
                                                {"rear_left", {"rl", "lr", "rearleft", "leftrear", "hl"}},
                                                {"rear_right", {"rr", "rearright", "rightrear", "hr"}}};
    return list;
}
constexpr std::string_view kSpinNames[] = {
    "omega",         "wheelspeed", "whlspd", "wheelspin", "spin",   "wspd",   "wheelspd", "wheel",
    "wheelvelocity", "wheelvel",   "whl",    "wheelrpm",  "whlvel", "vwheel", "vwhl",     "nwheel",
    "speed",         "spd",        "vel",    "rpm",       "ws",     "w",      "v",        "n"};

std::string lettersAndDigits(std::string_view name) {
    std::string out;
    for (const char c : name) {
        if (std::isalnum(static_cast<unsigned char>(c))) {
            out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        }
    }
    return out;
}

// Which instrument a channel comes from and where it sits says nothing of what it is.
constexpr std::string_view kSideWords[] = {"imu",     "vbox", "can",  "gps",      "gnss",   "ins",    "cg",
                                           "cog",     "com",  "meas", "measured", "actual", "sensor", "sensors",
                                           "encoder", "data", "msg",  "value",    "signal", "veh",    "vehicle"};

// Small letters and digits of the words of a name that say what it is: "acc x (IMU)" is accx.
std::string withoutSideWords(std::string_view name) {
    std::string out, word;
    const auto take = [&] {
        if (std::find(std::begin(kSideWords), std::end(kSideWords), word) == std::end(kSideWords)) out += word;
        word.clear();
    };
    for (const char c : name) {
        if (std::isalnum(static_cast<unsigned char>(c))) {
            word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        } else {
            take();
        }
    }
    take();
    return out;
}

// A column by how it is called: the name as a whole, without its unit, every tail of a path (twist.linear.x,
// imu/yaw_rate), and at last without the words for its instrument.
class Names {
public:
    explicit Names(const ForeignTable& table) {
        for (const ForeignColumn& column : table.columns) {
            const std::string_view name = column.name;
            for (std::size_t begin = 0; begin != std::string_view::npos;) {
                const std::string_view part = name.substr(begin);
                columns_.emplace(lettersAndDigits(part), &column);
                columns_.emplace(lettersAndDigits(nameWithoutUnit(part)), &column);
                loose_.emplace(withoutSideWords(nameWithoutUnit(part)), &column);
                begin = name.find_first_of("./", begin);
                if (begin != std::string_view::npos) ++begin;
            }
        }
    }
    const ForeignColumn* find(const std::string& name) const {
        for (const auto* columns : {&columns_, &loose_}) {
            const auto found = columns->find(name);
            if (found != columns->end()) return found->second;
        }
        return nullptr;
    }

private:
    std::map<std::string, const ForeignColumn*> columns_, loose_;
};

bool measures(std::string_view unit, std::string_view like) {
    std::string fault;
    const auto a = parseUnit(unit, fault), b = parseUnit(like, fault);
    return a && b && a->dimension == b->dimension;
}

class Guesser {
public:
    explicit Guesser(const ForeignTable& table) : table_(table), names_(table) {}

    GuessedMap guess() {
        result_.map.source =
            (table_.kind.starts_with("MCAP") ? "guessed from the names of an " : "guessed from the names of a ") +
            table_.kind;
        if (table_.kind == kOwnMcap) return ownChannels();
        for (const Alias& alias : aliases()) {
            const ForeignColumn* const column = find(alias.names);
            if (alias.channel == "time") {
                if (!hasOwnTimes()) guessTime(column);
            } else if (column) {
                guessChannel(alias, *column);
            }
        }
        guessWheels();
        if (hasOwnTimes()) chooseTime();
        guessPositions();
        alignSiblings();
        correctUnits();
        correctSigns();
        return std::move(result_);
    }

private:
    const ForeignColumn* find(const std::vector<std::string_view>& known) const {
        for (const std::string_view name : known) {
            if (const ForeignColumn* const column = names_.find(std::string(name))) return column;
        }
        return nullptr;
    }

    void note(std::string_view channel, std::string field, std::string text, std::string comment = {}) {
        if (comment.empty()) comment = text;
        result_.guesses.push_back({std::string(channel), std::move(field), std::move(text), std::move(comment)});
    }

    ImportChannel* channel(std::string_view name) {
        for (ImportChannel& one : result_.map.map) {
            if (one.channel == name) return &one;
        }
        return nullptr;
    }

    void add(std::string_view name, const ForeignColumn& column, std::string unit) {
        ImportChannel made;
        made.channel = name;
        made.from = column.name;
        made.unit = std::move(unit);
        result_.map.map.push_back(std::move(made));
    }

    // The unit that the file or the name says; otherwise the one that makes the values plausible, which is a guess.
    std::string unitOf(std::string_view name, const ForeignColumn& column, std::string_view si) {
        std::string unit = spelledUnit(column.unit);
        if (unit.empty()) unit = unitInName(column.name);
        if (!unit.empty()) {
            const std::string why = implausible(name, unit, column.values);
            if (!why.empty()) {
                note(name, "unit",
                     "column " + column.name + " says " + unit + ", but its " + why + ": confirm the unit",
                     "the file says so, but its " + why);
            }
            return unit;
        }
        const PlausibleUnit guessed = plausibleUnit(name, si, column.values);
        if (!guessed.why.empty()) noteUnit(name, column, guessed.unit, guessed.why);
        return guessed.unit;
    }

    void noteUnit(std::string_view name, const ForeignColumn& column, const std::string& unit, const std::string& why) {
        note(name, "unit",
             "column " + column.name + " has no unit that tread knows: assumed to be in " + unit + " (" + why + ")",
             "guess: " + why);
        guessed_units_.emplace(name);
    }

    void guessTime(const ForeignColumn* column) {
        ImportTime& time = result_.map.time;
        if (!column) {
            time.rate = 100;
            note("time", "rate", "no column looks like a time: 100 Hz assumed", "guess: no column looks like a time");
            return;
        }
        time.from = column->name;
        if (table_.kind == "VBOX file") {
            time.format = TimeFormat::hhmmss;
            return;
        }
        time.unit = spelledUnit(column->unit);
        if (time.unit.empty()) time.unit = unitInName(column->name);
        if (!time.unit.empty()) return;
        const double step = usualStep(column->values);
        const bool fine = column->values.size() > 20;  // nobody logs a drive of many samples at 1 Hz
        const bool micro = step >= 1e3 && step < 1e5, milli = step < 1e3 && (step > 1 || (step == 1 && fine));
        time.unit = micro ? "us" : milli ? "ms" : "s";
        const std::string why = fmt::format("its usual step is {:.3g}", step);
        note("time", "unit",
             "column " + column->name + " has no unit that tread knows: assumed to be in " + time.unit + " (" + why +
                 ")",
             "guess: " + why);
    }

    // What tread has written is taken as it is: names, units and values.
    GuessedMap ownChannels() {
        result_.map.source = "the channels of an " + table_.kind;
        result_.by_names = false;
        result_.map.repairs.spikes = false;
        result_.map.repairs.fill_gaps = false;
        for (const ForeignColumn& column : table_.columns) {
            if (column.name == column.time) continue;
            if (isChannelName(column.name) && misspelling(column.name).empty()) add(column.name, column, "");
        }
        chooseTime();
        return std::move(result_);
    }

    bool hasOwnTimes() const {
        return std::any_of(table_.columns.begin(), table_.columns.end(),
                           [](const ForeignColumn& column) { return !column.time.empty(); });
    }

    // The time of the channels with the most samples; the others are interpolated onto it.
    void chooseTime() {
        std::set<std::string> times;
        const ForeignColumn* densest = nullptr;
        const auto consider = [&](const ForeignColumn& column) {
            times.insert(column.time);
            if (!densest || column.values.size() > densest->values.size()) densest = &column;
        };
        for (const ImportChannel& one : result_.map.map) consider(*table_.find(one.from));
        if (!densest) {
            for (const ForeignColumn& column : table_.columns) consider(column);
        }
        result_.map.time.from = densest->time;
        result_.map.time.unit = "s";
        if (times.size() > 1)
            note("time", "from",
                 fmt::format("the channels have {} different times: those of {} were taken, with the most samples, and "
                             "the others interpolated onto them",
                             times.size(), densest->time),
                 "guess: the most samples; the other channels are interpolated onto them");
    }

    static double usualStep(const std::vector<double>& values) {
        std::vector<double> steps;
        for (std::size_t i = 1; i < values.size(); ++i) {
            if (values[i] > values[i - 1]) steps.push_back(values[i] - values[i - 1]);
        }
        return steps.empty() ? 0 : median(std::move(steps));
    }

    void guessChannel(const Alias& alias, const ForeignColumn& column) {
        const std::string name(alias.channel);
        const std::string expected(alias.unit.empty() ? *logUnit(name) : alias.unit);
        const std::size_t before = result_.guesses.size();
        const std::string unit = unitOf(name, column, expected);
        if (!measures(unit, expected)) {
            result_.guesses.resize(before);
            note(name, "", "column " + column.name + " could be " + name + ", but is in " + unit + ": left out");
            return;
        }
        add(name, column, unit);
        if (lettersAndDigits(column.name).find("head") != std::string::npos ||
            lettersAndDigits(nameWithoutUnit(column.name)) == "course") {
            result_.map.map.back().sign = -1;
            note(name, "sign",
                 "column " + column.name + " is a heading, which counts clockwise from north: sign reversed",
                 "guess: a heading counts clockwise from north");
        }
        if (name == "driver.steering_wheel_angle" && isRoadWheelAngle(column.name)) {
            note(name, "from",
                 "column " + column.name + " may be the angle of the road wheels: then scale is the steering ratio",
                 "guess by the name; if it is the angle of the road wheels, add scale: the steering ratio");
        }
    }

    // By the letters of textbooks, and of the messages of Ackermann vehicles.
    static bool isRoadWheelAngle(std::string_view name) {
        const std::string letters = lettersAndDigits(nameWithoutUnit(name));
        return letters == "delta" || letters.ends_with("steeringtireangle") ||
               letters.ends_with("drivesteeringangle") || letters.find("ackermann") != std::string::npos;
    }

    void guessWheels() {
        for (const auto& [wheel, codes] : wheelCodes()) {
            const ForeignColumn* column = nullptr;
            for (const std::string_view stem : kSpinNames) {
                for (const std::string_view code : codes) {
                    const std::string s(stem), c(code);
                    if (!column) column = names_.find(s + c);
                    if (!column) column = names_.find(c + s);
                }
            }
            if (column) guessWheel("wheel." + std::string(wheel), *column);
        }
    }

    void guessWheel(const std::string& wheel, const ForeignColumn& column) {
        std::string unit = spelledUnit(column.unit);
        if (unit.empty()) unit = unitInName(column.name);
        const bool said = !unit.empty();
        std::string why;
        if (!said) unit = wheelUnit(column, why);
        const bool speed = measures(unit, "m/s");
        if (!speed && !measures(unit, "rad/s")) return;
        const std::string name = wheel + (speed ? ".speed" : ".spin");
        add(name, column, unit);
        if (!said) noteUnit(name, column, unit, why);
        if (speed) {
            note(name, "channel",
                 "column " + column.name + " is a speed: with rolling_radius it would become " + wheel + ".spin",
                 "a speed; with rolling_radius it would be " + wheel + ".spin");
        }
    }

    // By what the wheel makes of the speed of the car; a wheel has a rolling radius of 0.2 to 0.45 m.
    std::string wheelUnit(const ForeignColumn& column, std::string& why) {
        const ImportChannel* const vx = channel("chassis.vx");
        const ForeignColumn* const speed = vx ? table_.find(vx->from) : nullptr;
        std::vector<double> ratios;
        if (speed && speed->values.size() == column.values.size()) {
            const Scaling si = scalingTo(vx->unit, "m/s", "", *speed);
            for (std::size_t i = 0; i < column.values.size(); ++i) {
                if (si(speed->values[i]) > 3 && column.values[i] > 0)
                    ratios.push_back(column.values[i] / si(speed->values[i]));
            }
        }
        if (ratios.empty()) {
            const PlausibleUnit guessed = plausibleUnit("wheel.front_left.spin", "rad/s", column.values);
            why = guessed.why;
            return guessed.unit;
        }
        const double ratio = median(std::move(ratios));
        why = fmt::format("{:.3g} times the speed of the car in m/s", ratio);
        if (ratio > 0.8 && ratio < 1.25) return "m/s";
        if (std::abs(ratio / 3.6 - 1) < 0.04) return "km/h";
        if (ratio > 20 && ratio < 50) return "rpm";
        if (ratio > 125 && ratio < 290) return "deg/s";
        return "rad/s";
    }

    void guessPositions() {
        for (const std::string_view name : kPositions) {
            if (const ForeignColumn* const column = names_.find(std::string(name))) {
                note("", "",
                     "column " + column->name +
                         " is a latitude or longitude, for which a log has no channel: "
                         "left out");
            }
        }
    }

    std::optional<Log> imported() const {
        try {
            return importLog(table_, result_.map).logs.front();
        } catch (const std::exception&) {
            return {};  // the import itself will say why
        }
    }

    // The channels of one instrument are logged in one unit: where values or the file leave no doubt about one of them,
    // the others follow.
    void alignSiblings() {
        static const std::vector<std::vector<std::string_view>> instruments = {
            {"chassis.ax", "chassis.ay", "chassis.az"},
            {"chassis.yaw_rate", "chassis.roll_rate", "chassis.pitch_rate"},
            {"chassis.roll", "chassis.pitch"},
            {"chassis.vx", "chassis.vy"}};
        for (const auto& instrument : instruments) {
            const ImportChannel* sure = nullptr;
            for (const std::string_view name : instrument) {
                const ImportChannel* const one = channel(name);
                if (one && !sure && isSure(*one)) sure = one;
            }
            for (const std::string_view name : instrument) {
                ImportChannel* const one = channel(name);
                if (sure && one && !isSure(*one)) setUnit(*one, sure->unit, "as " + sure->channel + " is");
            }
        }
    }

    bool isSure(const ImportChannel& one) const {
        return !guessed_units_.contains(one.channel) || fitsOnlyOneUnit(one.channel, table_.find(one.from)->values);
    }

    void setUnit(ImportChannel& one, const std::string& unit, const std::string& why) {
        if (one.unit == unit) return;
        one.unit = unit;
        std::erase_if(result_.guesses, [&](const Guess& g) { return g.channel == one.channel && g.field == "unit"; });
        noteUnit(one.channel, *table_.find(one.from), unit, why);
    }

    // A unit that was guessed gives way to one that fits what the other channels say of the car.
    void correctUnits() {
        if (guessed_units_.empty()) return;
        const auto log = imported();
        if (!log || !swappedChannels(*log).empty()) return;
        for (const BodyRelation& relation : bodyRelations(*log)) {
            if (!relation.sized || relation.factor == 0) continue;
            if (relation.channel == "chassis.ax" || relation.channel == "chassis.ay") {
                correct(relation.channel, relation, "m/s2", "g", 9.80665);
            }
            if (relation.other == "chassis.yaw_rate" && relation.channel == "chassis.ay") {
                correct("chassis.yaw_rate", relation, "deg/s", "rad/s", 180 / std::numbers::pi);
            }
            if (relation.channel == "chassis.ax" || relation.channel == "chassis.ay") {
                correct("chassis.vx", relation, "km/h", "m/s", 3.6);
            }
        }
    }

    // `small` and `large` are two units of a channel, the second `times` the first. A relation that is off by just that
    // shows that the other of them was meant.
    void correct(const std::string& name, const BodyRelation& relation, std::string_view small, std::string_view large,
                 double times) {
        ImportChannel* const guessed = channel(name);
        if (!guessed || !guessed_units_.contains(name)) return;
        const auto off = [&](double by) { return std::abs(relation.factor / by - 1) < 0.2; };
        const bool own = relation.channel == name;  // a larger unit of the channel itself makes the factor larger
        std::string_view unit;
        if (guessed->unit == large && off(own ? times : 1 / times)) unit = small;
        if (guessed->unit == small && off(own ? 1 / times : times)) unit = large;
        if (unit.empty()) return;
        setUnit(*guessed, std::string(unit), "then " + relation.says + " agree");
    }

    // Signs by the majority of what the channels of a rigid body say of one another.
    void correctSigns() {
        const auto log = imported();
        if (!log) return;
        for (const Swapped& pair : swappedChannels(*log)) {
            note(pair.one, "from", pair.one + " and " + pair.other + " seem swapped: " + pair.why,
                 "guess by the name, but seems swapped with " + pair.other + ": exchange their columns");
            swapped_ = true;
        }
        if (swapped_) return;
        const std::vector<BodyRelation> relations = bodyRelations(*log);
        const OddOnes odd = oddOnes(relations);
        for (const std::string& name : odd.turned) {
            ImportChannel* const turned = channel(name);
            if (!turned) continue;
            turned->sign = -turned->sign;
            const std::string partners = partnersOf(name, relations);
            note(name, "sign", "column " + turned->from + " has the opposite sign of " + partners + ": reversed",
                 "guess: opposite to " + partners);
        }
        for (const std::string& name : odd.either) {
            if (!channel(name)) continue;
            const std::string partners = partnersOf(name, relations);
            const std::string why = partners.empty() ? "it depends on channels that contradict one another"
                                                     : "it is opposite to " + partners;
            note(name, "from", "sign of " + name + " is undetermined: " + why,
                 "guess by the name; sign undetermined: " + why);
        }
    }

    static std::string partnersOf(const std::string& name, const std::vector<BodyRelation>& relations) {
        std::string out;
        for (const BodyRelation& relation : relations) {
            if (relation.correlation > 0 || (relation.channel != name && relation.other != name)) continue;
            const std::string& partner = relation.channel == name ? relation.other : relation.channel;
            if (out.find(partner) == std::string::npos) out += (out.empty() ? "" : " and ") + partner;
        }
        return out;
    }

    const ForeignTable& table_;
    Names names_;
    GuessedMap result_;
    std::set<std::string> guessed_units_;
    bool swapped_ = false;
};

bool same(const YamlItem& a, const YamlItem& b) {
    const auto alike = [](const YamlItem& x, const YamlItem& y) { return same(x, y); };
    return a.text == b.text && a.children.size() == b.children.size() &&
           std::equal(a.children.begin(), a.children.end(), b.children.begin(), alike);
}

// Both have the fields of one type, in its order, or the remarks that stand for them.
void leaveOutDefaults(YamlItem& item, const YamlItem& plain) {
    std::vector<YamlItem> kept;
    for (std::size_t i = 0; i < item.children.size(); ++i) {
        YamlItem& child = item.children[i];
        const YamlItem& other = plain.children[i];
        if (child.kind == YamlItem::Kind::remark || same(child, other)) continue;
        if (child.kind == YamlItem::Kind::map) leaveOutDefaults(child, other);
        kept.push_back(std::move(child));
    }
    item.children = std::move(kept);
}

void comment(YamlItem& item, std::string_view field, const std::string& text) {
    for (YamlItem& child : item.children) {
        if (child.name == field) child.comment = text;
    }
}

YamlItem mappingItem(const ImportMap& map) {
    const YamlItem plain_channel = detail::FieldsOf<ImportChannel>::write("", {});
    YamlItem root = detail::FieldsOf<ImportMap>::write("", map);
    leaveOutDefaults(root, detail::FieldsOf<ImportMap>::write("", {}));
    for (YamlItem& item : root.children) {
        if (item.name != "map") continue;
        for (YamlItem& channel : item.children) leaveOutDefaults(channel, plain_channel);
    }
    return root;
}

}  // namespace

GuessedMap guessMap(const ForeignTable& table) {
    return Guesser(table).guess();
}

ImportMap guessMap(const ForeignTable& table, std::vector<std::string>& guesses) {
    GuessedMap guessed = guessMap(table);
    for (Guess& guess : guessed.guesses) guesses.push_back(std::move(guess.text));
    return std::move(guessed.map);
}

std::string mappingText(const ImportMap& map) {
    return yamlText(mappingItem(map));
}

std::string mappingText(const GuessedMap& guessed) {
    YamlItem root = mappingItem(guessed.map);
    for (YamlItem& item : root.children) {
        if (item.name == "time" && guessed.by_names) comment(item, "from", "guess by the name");
        for (std::size_t i = 0; item.name == "map" && guessed.by_names && i < item.children.size(); ++i) {
            comment(item.children[i], "from", "guess by the name");
        }
        for (const Guess& guess : guessed.guesses) {
            if (item.name == guess.channel) comment(item, guess.field, guess.comment);
            for (std::size_t i = 0; item.name == "map" && i < item.children.size(); ++i) {
                if (guessed.map.map[i].channel == guess.channel) {
                    comment(item.children[i], guess.field, guess.comment);
                }
            }
        }
    }
    return yamlText(root);
}

}  // namespace tread
