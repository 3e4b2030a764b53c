// Which program this is: a hash of what it was built from, so that a blind check can tell whether the program that made
// the cases, the one that answered and the one that scores are the same.
#pragma once

#include <string>

#include "tread/describe.h"

namespace tread {

// SHA-256 of what `sha256sum` prints of the sources, in the order of their paths (program_hash.cmake says which):
// contents only, so that another compiler, machine or folder changes nothing.
struct Program {
    std::string diagnosis;
    std::string scoring;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(diagnosis), About{"", "hash of all that decides a case or an answer, settings included"});
        field(TREAD_FIELD(scoring), About{"", "hash of the rest: what counts answers and shows results"});
    }
    bool operator==(const Program&) const = default;
};
static_assert(describesEveryMember<Program>());

// Of this program.
const Program& programHash();

}  // namespace tread
