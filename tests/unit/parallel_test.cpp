#include "base/threads/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <barrier>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
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

// Calls within a piece use its thread and those that have none: as many pieces as threads leave one each, a single
// piece has all of them.
TEST(InParallel, PiecesShareTheThreads) {
    struct Case {
        std::size_t pieces;
        int threads;
        std::size_t most;
    };
    for (const Case& c : {Case{1, 4, 4}, Case{2, 4, 3}, Case{3, 4, 2}, Case{4, 4, 1}, Case{8, 4, 1}}) {
        const std::size_t first = std::min<std::size_t>(c.pieces, 4);  // as many as begin at once
        std::barrier begin(static_cast<std::ptrdiff_t>(first)), end(static_cast<std::ptrdiff_t>(first));
        std::vector<std::size_t> seen(c.pieces), deeper(c.pieces);
        inParallel(c.pieces, c.threads, [&](std::size_t i) {
            if (i < first) begin.arrive_and_wait();
            seen[i] = threadCount(c.threads);
            inParallel(1, c.threads, [&](std::size_t) { deeper[i] = threadCount(0); });
            if (i < first) end.arrive_and_wait();
        });
        for (std::size_t i = 0; i < c.pieces; ++i) {
            EXPECT_GE(seen[i], i < first ? c.most : 1u) << c.pieces;
            EXPECT_LE(seen[i], i < first ? c.most : 4u) << c.pieces;
            EXPECT_LE(deeper[i], i < first ? c.most : 4u) << c.pieces;
        }
    }
    EXPECT_EQ(threadCount(5), 5u);  // outside again
}

// A piece that takes long gets the threads for which no other is left.
TEST(InParallel, ThreadsWithoutAPieceHelpTheOthers) {
    std::mutex guard;
    std::set<std::thread::id> helped;
    inParallel(2, 2, [&](std::size_t piece) {
        if (piece == 1) return;
        while (threadCount(2) < 2) std::this_thread::yield();
        std::barrier both(2);
        inParallel(2, 2, [&](std::size_t) {
            both.arrive_and_wait();
            const std::scoped_lock lock(guard);
            helped.insert(std::this_thread::get_id());
        });
    });
    EXPECT_EQ(helped.size(), 2u);
    EXPECT_EQ(threadCount(5), 5u);
}

}  // namespace
}  // namespace tread::parallel_test
