// Cars of several runs on one thread, each step of which is computed at once in lanes (vehicle/fleet/lane_kind.h).
//
// Each run is a fiber: it computes until its car is to move, and waits. When all wait, some whose steps are alike are
// computed together and go on. Cars that settle take other steps than cars that are driven, so there are more fibers
// than lanes: either kind waits until it fills them. A car does the same bit for bit whoever rides with it.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "run/rider.h"

namespace tread {

class Convoy {
public:
    // The convoy that the calling fiber belongs to; nullptr: none.
    static Convoy* ofThread();

    // Up to `most` fibers call doNext() until it returns false; returns when all have ended. It does not throw.
    static void drive(std::size_t most, const std::function<bool()>& doNext);

    // How many fibers a thread can use; 1: the processor has no lanes.
    static std::size_t most();

    // s, of the thread's time: what falls to each fiber by and by.
    double share() const;

    void seat(Rider& rider);
    void leave(Rider& rider);
    void step(Rider& rider, const StepInputs& inputs, double dt);
    void fetch(Rider& rider);  // its whole state, from its lane

    ~Convoy();

private:
    struct Seat;
    explicit Convoy(std::size_t seats);

    void run(const std::function<bool()>& doNext);
    void resume(std::size_t seat);
    void wait();
    void stepSome();
    std::vector<std::size_t> nextSeats() const;
    void stepAlone(std::size_t seat);
    void stepTogether(const std::vector<std::size_t>& together);
    void giveLanes(const std::vector<std::size_t>& together);
    void fillLane(std::size_t lane, Rider& rider);
    void load(std::size_t lane, Rider& rider);
    void move(Rider& rider);
    void putOut(Rider& rider);
    bool isIn(const Rider& rider, std::size_t lane) const;

    using Clock = std::chrono::steady_clock;

    const LaneKind* kind_;
    std::shared_ptr<void> block_;
    std::vector<std::unique_ptr<Seat>> seats_;
    std::size_t driving_ = 0;          // whose fiber runs
    std::size_t driven_ = 0;           // fibers that have not ended
    double stepped_ = 0;               // s, length of the last steps
    std::vector<Rider*> loaded_;       // whose car is in each lane; nullptr: none, or one that is gone
    std::vector<VehicleState> spare_;  // of cars that repeat another's
    std::vector<VehicleInput> begin_, end_;
    Clock::time_point looked_ = Clock::now();
    double share_ = 0;
};

}  // namespace tread
