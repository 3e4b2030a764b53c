#include "base/parallel.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace tread::parallel_test
