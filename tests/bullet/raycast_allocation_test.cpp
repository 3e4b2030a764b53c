// A step of the vehicle takes no memory from the heap and writes nothing.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>

#include "benchmark/game_scene.h"
#include "stock_vs_tread/scene.h"

namespace {

std::atomic<long> allocations{0};

}  // namespace

// For the whole program: counts, and allocates as usual. Both kinds, since one operator delete frees what either gave.
__attribute__((noinline)) void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    ++allocations;
    return std::malloc(size);
}
__attribute__((noinline)) void* operator new(std::size_t size) {
    if (void* memory = operator new(size, std::nothrow)) return memory;
    throw std::bad_alloc();
}
__attribute__((noinline)) void operator delete(void* memory) noexcept {
    std::free(memory);
}
__attribute__((noinline)) void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace tread::raycast_allocation_test {
namespace {

using namespace scene;

TEST(RaycastVehicleAllocation, StepsNeitherAllocateNorWrite) {
    for (const game::Ground ground : {game::Ground::plane, game::Ground::height_field, game::Ground::mesh}) {
        World world;
        game::Hills hills;
        hills.add(world, ground);
        Car<RaycastVehicle> car(world, {.height = 0.56, .speed = 15});
        const auto drive = [&](int frames) {
            for (int i = 0; i < frames; ++i) {
                car.steer(0.2 * std::sin(0.05 * i));
                car.push(i % 120 < 80 ? 3000 : 0);
                car.brake(i % 120 < 80 ? 0 : 60);
                run(world, 1.0 / 60, 60);
            }
        };
        testing::internal::CaptureStderr();
        drive(600);
        const long before = allocations;
        drive(600);
        const long after = allocations;
        EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
        EXPECT_EQ(after - before, 0);
    }
}

}  // namespace
}  // namespace tread::raycast_allocation_test
