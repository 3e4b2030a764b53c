// Pages in a real browser, where one is installed.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "shared/scratch.h"

namespace tread {

inline bool browserIsThere() {
    return std::system("command -v chromium >/dev/null 2>&1") == 0;
}

// The page as the browser has it once its scripts have run.
inline std::string openedInBrowser(const std::string& page) {
    const Scratch scratch;
    const std::string dom = scratch.path("dom.html");
    const std::string command =
        "timeout 120 chromium --headless --no-sandbox --disable-gpu --virtual-time-budget=3000 --dump-dom 'file://" +
        page + "' >'" + dom + "' 2>/dev/null";
    EXPECT_EQ(std::system(command.c_str()), 0) << page;
    return contentOf(dom);
}

}  // namespace tread
