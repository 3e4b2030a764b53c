// Calls of the program that are killed at random moments.
#pragma once

#include <chrono>
#include <functional>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "cli/program.h"
#include "shared/scratch.h"

namespace tread {

// Makes calls, one after the other, and kills each after at most `longest`, until `kills` have been killed; `look` sees
// what each has left. The words may change from call to call, since some end before they are killed.
inline void killAtRandom(int kills, std::chrono::milliseconds longest,
                         const std::function<std::vector<std::string>()>& words, const std::function<void()>& look) {
    const Scratch scratch;
    std::mt19937 random(7);
    std::uniform_int_distribution<long> delay(0, longest.count());
    while (kills > 0) {
        Running program(words(), scratch.path("stdout"), scratch.path("stderr"));
        std::this_thread::sleep_for(std::chrono::milliseconds(delay(random)));
        program.send(SIGKILL);
        if (program.waitForStatus() < 0) --kills;
        look();
    }
}

}  // namespace tread
