// A mapping from the names that people give to the channels of a car. What is guessed is written out in full, so that a
// person can correct it.
#include <algorithm>
#include <cctype>
#include <map>

#include "base/units.h"
#include "base/write_yaml.h"
#include "import/import.h"
#include "import/unit_spelling.h"
#include "log/log_columns.h"
#include "tread/wheels.h"

namespace tread {
namespace {

struct Alias {
    std::string_view channel;
    std::vector<std::string_view> names;  // small letters and digits only; the first that the file has is taken
};

const std::vector<Alias>& aliases() {
    static const std::vector<Alias> list = {
        {"time", {"time", "t", "times", "timestamp", "timesec", "elapsedtime", "zeit", "rectime", "tout"}},
        {"driver.steering_wheel_angle",
         {"steeringwheelangle", "steeringwheel", "steeringangle", "steerangle", "handwheelangle", "handwheel", "swa",
          "steerwheelangle", "steering", "strgwhlang", "sas", "deltah", "lenkradwinkel"}},
        {"driver.throttle",
         {"throttle", "throttlepedal", "acceleratorpedal", "accelpedal", "accpedal", "accrpedl", "accrpedln",
          "throttleposition", "tps", "gas", "gaspedal"}},
        {"driver.brake", {"brake", "brakepedal", "brakeposition"}},
        {"driver.clutch", {"clutch", "clutchpedal"}},
        {"chassis.vx",
         {"vx", "longitudinalvelocity", "longvel", "lngvel", "velx", "velocityx", "vehspdlgt", "vehiclespeed",
          "velocity", "speed", "vehspd", "v"}},
        {"chassis.vy", {"vy", "lateralvelocity", "latvel", "vely", "velocityy"}},
        {"chassis.yaw_rate",
         {"yawrate", "yawvelocity", "yawvel", "psidot", "gyroz", "wz", "omegaz", "r", "yawrate1", "gierrate"}},
        {"chassis.roll_rate", {"rollrate", "rollvelocity", "gyrox", "wx", "omegax", "p", "rollrate1"}},
        {"chassis.pitch_rate", {"pitchrate", "pitchvelocity", "gyroy", "wy", "omegay", "q"}},
        {"chassis.ax",
         {"ax", "accx", "accelx", "xaccel", "xacc", "longitudinalacceleration", "longaccel", "longacc", "algt1"}},
        {"chassis.ay",
         {"ay", "accy", "accely", "yaccel", "yacc", "lateralacceleration", "lataccel", "latacc", "alat1", "glat"}},
        {"chassis.az", {"az", "verticalacceleration", "vertacc", "accz", "accelz", "zaccel", "zacc"}},
        {"chassis.roll", {"roll", "rollangle", "rollimu", "phi"}},
        {"chassis.pitch", {"pitch", "pitchangle", "pitchang", "pitchimu"}},
        {"chassis.yaw", {"yaw", "yawangle", "psi"}},
        {"chassis.sideslip", {"sideslip", "sideslipangle", "beta", "slipcog", "slipangle"}},
        {"driveline.engine_speed", {"enginespeed", "enginerpm", "engn", "rpm", "nmot"}},
        {"driveline.gear", {"gear", "ptgearact", "gearnumber"}}};
    return list;
}

struct WheelCode {
    std::string_view wheel;
    std::vector<std::string_view> codes;
};
const std::vector<WheelCode>& wheelCodes() {
    static const std::vector<WheelCode> list = {{"front_left", {"fl", "lf", "frontleft"}},
                                                {"front_right", {"fr", "rf", "frontright"}},
                                                {"rear_left", {"rl", "lr", "rearleft"}},
                                                {"rear_right", {"rr", "rearright"}}};
    return list;
}
constexpr std::string_view kSpinNames[] = {"omega", "wheelspeed", "whlspd", "wheelspin", "spin", "wspd", "ws", "w"};

std::string lettersAndDigits(std::string_view name) {
    std::string out;
    for (const char c : name) {
        if (std::isalnum(static_cast<unsigned char>(c))) {
            out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        }
    }
    return out;
}

// A column by how it is called: the name as a whole, without its unit, and the last part of a struct's field.
class Names {
public:
    explicit Names(const ForeignTable& table) {
        for (const ForeignColumn& column : table.columns) {
            const std::string_view name = column.name;
            for (const std::string_view part : {name, name.substr(name.rfind('.') + 1)}) {
                columns_.emplace(lettersAndDigits(part), &column);
                columns_.emplace(lettersAndDigits(nameWithoutUnit(part)), &column);
            }
        }
    }
    const ForeignColumn* find(const std::string& name) const {
        const auto found = columns_.find(name);
        return found == columns_.end() ? nullptr : found->second;
    }

private:
    std::map<std::string, const ForeignColumn*> columns_;
};

// The unit that the file or the name says; otherwise `expected`, which then is a guess.
std::string unitOf(const ForeignColumn& column, std::string_view expected, std::vector<std::string>& guesses) {
    std::string unit = spelledUnit(column.unit);
    if (unit.empty()) unit = unitInName(column.name);
    if (!unit.empty()) return unit;
    guesses.push_back("column " + column.name + " says no unit that tread knows: taken to be in " +
                      std::string(expected));
    return std::string(expected);
}

bool measures(std::string_view unit, std::string_view like) {
    std::string fault;
    const auto a = parseUnit(unit, fault), b = parseUnit(like, fault);
    return a && b && a->dimension == b->dimension;
}

ImportChannel channelOf(std::string channel, const ForeignColumn& column, std::string unit) {
    ImportChannel made;
    made.channel = std::move(channel);
    made.from = column.name;
    made.unit = std::move(unit);
    return made;
}

void guessTime(const ForeignTable& table, const ForeignColumn* column, ImportMap& map,
               std::vector<std::string>& guesses) {
    if (!column) {
        map.time.rate = 100;
        guesses.push_back("no column looks like a time: counted at 100 Hz");
        return;
    }
    map.time.from = column->name;
    if (table.kind == "VBOX file") {
        map.time.format = TimeFormat::hhmmss;
    } else {
        map.time.unit = unitOf(*column, "s", guesses);
    }
}

void guessWheels(const Names& names, ImportMap& map, std::vector<std::string>& guesses) {
    for (const auto& [wheel, codes] : wheelCodes()) {
        const ForeignColumn* column = nullptr;
        for (const std::string_view stem : kSpinNames) {
            for (const std::string_view code : codes) {
                const std::string s(stem), c(code);
                if (!column) column = names.find(s + c);
                if (!column) column = names.find(c + s);
            }
        }
        if (!column) continue;
        const std::string unit = unitOf(*column, "rad/s", guesses), name = "wheel." + std::string(wheel);
        if (measures(unit, "m/s")) {
            map.map.push_back(channelOf(name + ".speed", *column, unit));
            guesses.push_back("column " + column->name + " is a speed: with rolling_radius it would become " + name +
                              ".spin");
        } else if (measures(unit, "rad/s")) {
            map.map.push_back(channelOf(name + ".spin", *column, unit));
        }
    }
}

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

}  // namespace

ImportMap guessMap(const ForeignTable& table, std::vector<std::string>& guesses) {
    ImportMap map;
    map.source = "guessed from the names of a " + table.kind;
    const Names names(table);
    for (const auto& [channel, known] : aliases()) {
        const ForeignColumn* column = nullptr;
        for (const std::string_view name : known) {
            if (!column) column = names.find(std::string(name));
        }
        if (channel == "time") {
            guessTime(table, column, map, guesses);
            continue;
        }
        if (!column) continue;
        const std::string_view expected = *logUnit(std::string(channel));
        const std::string unit = unitOf(*column, expected, guesses);
        if (measures(unit, expected)) {
            map.map.push_back(channelOf(std::string(channel), *column, unit));
        } else {
            guesses.push_back("column " + column->name + " could be " + std::string(channel) + ", but is in " + unit +
                              ": left out");
        }
    }
    guessWheels(names, map, guesses);
    return map;
}

std::string mappingText(const ImportMap& map) {
    const YamlItem plain_channel = detail::mapOf("", ImportChannel{});
    YamlItem root = detail::mapOf("", map);
    leaveOutDefaults(root, detail::mapOf("", ImportMap{}));
    for (YamlItem& item : root.children) {
        if (item.name != "map") continue;
        for (YamlItem& channel : item.children) leaveOutDefaults(channel, plain_channel);
    }
    return yamlText(root);
}

}  // namespace tread
