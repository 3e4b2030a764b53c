// Identity of the program, as hashes of its sources: a blind check compares the programs that made the cases, that
// diagnosed them and that score them.
#pragma once

#include <string>

#include "tread/describe.h"

namespace tread::blind::key {

// SHA-256 of the output of `sha256sum` for the sources, sorted by path (program_hash.cmake lists them). Independent of
// compiler, machine and folder.
struct Program {
    std::string diagnosis;
    std::string scoring;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(diagnosis),
              About{"", "hash of all sources that decide a case or an answer, settings included"});
        field(TREAD_FIELD(scoring), About{"", "hash of the sources that count answers and present results"});
    }
    bool operator==(const Program&) const = default;
};
static_assert(describesEveryMember<Program>());

// Hashes of this program.
const Program& programHash();

}  // namespace tread::blind::key
