// What a person at a terminal sees beside the answer: colours, warnings and the progress of long work.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace tread::program {

// --quiet: from now on neither answers in words nor warnings nor progress, only errors and what was asked for as data.
void beQuiet();
bool isQuiet();

// How an answer is meant: its first line is bold, and green or red on a terminal.
enum class Tone { plain, good, bad };

// The text with its first line in the colour of the tone, if the stream is a terminal that shows colours: neither a
// pipe nor TERM=dumb, and without NO_COLOR.
std::string coloured(std::string_view text, Tone tone, std::FILE* stream);

// Columns of a line on standard output: those of the terminal, of the variable COLUMNS, or 100.
std::size_t lineWidth();

// The text broken at spaces into lines of at most `width` columns, all but the first indented; the first begins at that
// column too.
std::string wrapped(std::string_view text, std::size_t indent, std::size_t width);

// A warning on standard error, "warning: <text>", once a command however often it is given.
void warn(std::string_view text);

// A note on standard error, such as where a page was written.
void note(std::string_view text);

// A bar on standard error, when that is a terminal and the work takes more than two seconds: share done and time left.
class Progress {
public:
    // `total` in the unit in which progress is told.
    Progress(double total, const char* unit) : total_(total), unit_(unit) {}
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void at(double done);
    void at(double done, double total);

private:
    using Clock = std::chrono::steady_clock;

    double total_;
    const char* unit_;
    bool shown_ = false;
    Clock::time_point begun_ = Clock::now();
    Clock::time_point next_ = begun_ + std::chrono::seconds(2);
};

// A line of progress after so many seconds of work: "[#####     ]  50 %, 0:12 left (5.0 of 10.0 s)".
std::string progressLine(double done, double total, const char* unit, double elapsed);

}  // namespace tread::program
