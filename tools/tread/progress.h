// A progress bar on standard error, when that is a terminal and the work takes more than two seconds.
#pragma once

#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace tread::program {

class Progress {
public:
    // `total` in the unit in which progress is told; 0: not known.
    Progress(double total, const char* unit) : total_(total), unit_(unit) {}
    ~Progress() {
        if (shown_) std::fprintf(stderr, "\r\033[K");
    }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void at(double done) {
        const auto now = std::chrono::steady_clock::now();
        if (!terminal_ || now < next_) return;
        next_ = now + std::chrono::milliseconds(100);
        shown_ = true;
        constexpr int kWidth = 40;
        const int filled = total_ > 0 ? static_cast<int>(kWidth * (done < total_ ? done / total_ : 1.0)) : 0;
        std::fprintf(stderr, "\r%.1f %s [%.*s%*s]", done, unit_, filled, "########################################",
                     kWidth - filled, "");
    }

private:
    double total_;
    const char* unit_;
    bool terminal_ = isatty(STDERR_FILENO) != 0;
    bool shown_ = false;
    std::chrono::steady_clock::time_point next_ = std::chrono::steady_clock::now() + std::chrono::seconds(2);
};

}  // namespace tread::program
