#include "base/threads/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

namespace tread::parallel_test {
namespace {

TEST(InParallel, EveryPieceIsDoneOnceAndTheFirstFailureIsThrown) {
    std::vector<int> done(100, 0);
    inParallel(done.size(), 3, [&](std::size_t i) { ++done[i]; });
    EXPECT_EQ(done, std::vector<int>(100, 1));
    EXPECT_THROW(inParallel(100, 3,
                            [](std::size_t i) {
                                if (i == 7) throw std::runtime_error("seven");
                            }),
                 std::runtime_error);
}

// Calls within a piece share the threads: as many pieces as threads leave one each, a single piece has all of them.
TEST(InParallel, PiecesShareTheThreads) {
    struct Case {
        std::size_t pieces;
        int threads;
        std::size_t each;
    };
    for (const Case& c : {Case{1, 4, 4}, Case{2, 4, 2}, Case{3, 4, 1}, Case{8, 4, 1}}) {
        std::vector<std::size_t> seen(c.pieces), deeper(c.pieces);
        inParallel(c.pieces, c.threads, [&](std::size_t i) {
            seen[i] = threadCount(c.threads);
            inParallel(1, c.threads, [&](std::size_t) { deeper[i] = threadCount(0); });
        });
        EXPECT_EQ(seen, std::vector<std::size_t>(c.pieces, c.each)) << c.pieces;
        EXPECT_TRUE(std::all_of(deeper.begin(), deeper.end(), [&](std::size_t n) { return n <= c.each; }));
    }
    EXPECT_EQ(threadCount(5), 5u);  // outside again
}

}  // namespace
}  // namespace tread::parallel_test
