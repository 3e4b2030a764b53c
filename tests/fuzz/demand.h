// A promise that the code under test makes: the fuzzer and the replay of its corpus stop where it is broken.
#pragma once

#include <cstdlib>

namespace tread::fuzz {

inline void demand(bool condition) {
    if (!condition) std::abort();
}

}  // namespace tread::fuzz
