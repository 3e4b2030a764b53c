#include "import/formats/unit_spelling.h"

#include <algorithm>
#include <cctype>

#include "base/units/units.h"
#include "import/formats/foreign_text.h"

namespace tread {
namespace {

struct Spelling {
    std::string_view foreign;  // lower case, without blanks
    std::string_view unit;
    bool in_names = false;  // also understood behind a name: "vx_mps"
};

constexpr Spelling kSpellings[] = {
    {"mps", "m/s", true},
    {"m/sec", "m/s"},
    {"m/s/s", "m/s2"},
    {"mps2", "m/s2", true},
    {"mpss", "m/s2", true},
    {"mps^2", "m/s2"},
    {"m/sec2", "m/s2"},
    {"m/sec^2", "m/s2"},
    {"kmh", "km/h", true},
    {"kmph", "km/h", true},
    {"kph", "km/h", true},
    {"km/hr", "km/h"},
    {"mph", "mph", true},
    {"g", "g", true},
    {"gee", "g"},
    {"g's", "g"},
    {"radps", "rad/s", true},
    {"rads", "rad/s", true},
    {"rad/sec", "rad/s"},
    {"radian", "rad"},
    {"radians", "rad"},
    {"rad", "rad", true},
    {"deg", "deg", true},
    {"degree", "deg"},
    {"degrees", "deg"},
    {"degs", "deg/s", true},
    {"degps", "deg/s", true},
    {"dps", "deg/s", true},
    {"deg/sec", "deg/s"},
    {"degree/s", "deg/s"},
    {"degrees/s", "deg/s"},
    {"degps2", "deg/s2", true},
    {"rpm", "rpm", true},
    {"1/min", "rpm"},
    {"u/min", "rpm"},
    {"r/min", "rpm"},
    {"rev/min", "rpm"},
    {"newtonmet", "N m"},
    {"newtonmeter", "N m"},
    {"newtonmetre", "N m"},
    {"nm", "N m", true},
    {"n*m", "N m"},
    {"newton", "N"},
    {"newtons", "N"},
    {"n", "N", true},
    {"kn", "kN", true},
    {"pct", "%", true},
    {"percent", "%"},
    {"sec", "s", true},
    {"secs", "s"},
    {"second", "s"},
    {"seconds", "s"},
    {"s", "s", true},
    {"msec", "ms"},
    {"millisecond", "ms"},
    {"milliseconds", "ms"},
    {"m", "m", true},
    {"meter", "m"},
    {"metre", "m"},
    {"meters", "m"},
    {"metres", "m"},
    {"mm", "mm", true},
    {"hz", "Hz", true},
    {"celsius", "degC"},
    {"degc", "degC", true},
    {"volt", "V"},
    {"volts", "V"},
    {"ampere", "A"},
    {"unitless", "-"},
    {"none", "-"},
    {"n/a", "-"},
    {"-", "-"},
    {"1", "-"},
    {"bar", "bar", true},
    {"kpa", "kPa", true},
};

// What the channels of a log are in.
constexpr std::string_view kSiUnits[] = {"-",      "m", "m/s", "m/s2", "m/s3", "rad", "rad/s",
                                         "rad/s2", "s", "N",   "N m",  "W",    "Pa",  "K",
                                         "kg",     "A", "V",   "Hz",   "1/m",  "m2",  "m2/s2"};

std::string lowerWithoutBlanks(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c != ' ') out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return out;
}

// Where the last word of a name begins, behind "_" or a blank; npos when it has only one.
std::size_t lastWord(std::string_view name) {
    const std::size_t before = name.find_last_of("_ ");
    return before == std::string_view::npos || before == 0 ? std::string_view::npos : before + 1;
}

// A quotient at the end of a name, in two words: "yaw_rate_deg_s", "speed km h".
constexpr std::string_view kQuotients[] = {"m/s", "km/h", "m/s2", "rad/s", "deg/s"};

struct UnitAtEnd {
    std::string unit;   // empty: none
    std::size_t begin;  // of its first word
};

UnitAtEnd unitAtEnd(std::string_view name) {
    const std::size_t last = lastWord(name);
    if (last == std::string_view::npos) return {{}, name.size()};
    const std::size_t before = lastWord(name.substr(0, last - 1));
    if (before != std::string_view::npos) {
        const std::string two =
            lowerWithoutBlanks(name.substr(before, last - 1 - before)) + "/" + lowerWithoutBlanks(name.substr(last));
        for (const std::string_view quotient : kQuotients) {
            if (quotient == two) return {two, before};
        }
    }
    const std::string word = lowerWithoutBlanks(name.substr(last));
    for (const Spelling& spelling : kSpellings) {
        if (spelling.in_names && spelling.foreign == word) return {std::string(spelling.unit), last};
    }
    return {{}, name.size()};
}

}  // namespace

std::string spelledUnit(std::string_view foreign) {
    foreign = trimmedText(foreign);
    if (foreign.empty()) return {};
    const std::string word = lowerWithoutBlanks(foreign);
    for (const Spelling& spelling : kSpellings) {
        if (spelling.foreign == word) return std::string(spelling.unit);
    }
    std::string fault;
    if (parseUnit(foreign, fault)) return std::string(foreign);
    if (parseUnit(word, fault)) return word;  // "KM/H"
    return {};
}

std::string unitInName(std::string_view name) {
    return unitAtEnd(name).unit;
}

std::string_view nameWithoutUnit(std::string_view name) {
    const UnitAtEnd end = unitAtEnd(name);
    return end.unit.empty() ? name : name.substr(0, end.begin - 1);
}

std::string siUnitOf(std::string_view unit) {
    std::string fault;
    const auto foreign = parseUnit(unit, fault);
    if (!foreign) return std::string(unit);
    for (const std::string_view si : kSiUnits) {
        if (parseUnit(si, fault)->dimension == foreign->dimension) return std::string(si);
    }
    return std::string(unit);
}

}  // namespace tread
