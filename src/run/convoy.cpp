#include "run/convoy.h"

#include <cxxabi.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TREAD_FIBERS 0  // sanitizers know one stack per thread
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define TREAD_FIBERS 0
#endif
#endif
#ifndef TREAD_FIBERS
#define TREAD_FIBERS 1
#endif

#include <boost/context/fiber.hpp>
#include <boost/context/protected_fixedsize_stack.hpp>

namespace tread {
namespace {

using Fiber = boost::context::fiber;

constexpr std::size_t kMostLanes = 8;
constexpr std::size_t kSeatsPerLane = 2;  // of two kinds of steps, one always fills the lanes
constexpr std::size_t kStack = 8 << 20;   // bytes, as a thread has; only what is used takes memory
constexpr std::array<double, 3> kGravity_W{0, 0, -kStandardGravity};

thread_local Convoy* convoy_of_thread = nullptr;

const LaneKind* lanesOfProcessor() {
    static const LaneKind* const kind = TREAD_FIBERS ? laneKind(kMostLanes) : nullptr;
    return kind;
}

}  // namespace

struct Convoy::Seat {
    // Exceptions that are being handled: the runtime keeps them per thread, a fiber has its own. The C++ ABI lays them
    // down so: those that are caught, and how many are not yet.
    struct Handling {
        void* caught = nullptr;
        unsigned int uncaught = 0;

        void swapWithThread() { std::swap(*reinterpret_cast<Handling*>(abi::__cxa_get_globals()), *this); }
    };

    Fiber fiber;   // where it waits
    Fiber driver;  // while it runs: whoever resumed it
    Handling handling;
    Rider* rider = nullptr;
    std::optional<StepInputs> inputs{};  // of a step that it waits for
    double dt = 0;

    double step() const { return dt / inputs->steps(); }
};

Convoy* Convoy::ofThread() {
    return convoy_of_thread;
}

std::size_t Convoy::most() {
    return lanesOfProcessor() ? kSeatsPerLane * lanesOfProcessor()->lanes : 1;
}

Convoy::Convoy(std::size_t seats)
    : kind_(lanesOfProcessor()),
      block_(memoryFor(*kind_)),
      loaded_(kind_->lanes),
      spare_(kind_->lanes),
      begin_(kind_->lanes),
      end_(kind_->lanes) {
    for (std::size_t i = 0; i < seats; ++i) seats_.push_back(std::make_unique<Seat>());
}

Convoy::~Convoy() = default;

void Convoy::drive(std::size_t most, const std::function<bool()>& doNext) {
    const std::size_t seats = std::min(most, Convoy::most());
    if (seats < kLanesPay) {
        while (doNext()) {
        }
        return;
    }
    Convoy convoy(seats);
    const struct OnThread {
        explicit OnThread(Convoy* inner) : outer(std::exchange(convoy_of_thread, inner)) {}
        ~OnThread() { convoy_of_thread = outer; }
        Convoy* outer;
    } on_thread(&convoy);
    convoy.run(doNext);
}

void Convoy::run(const std::function<bool()>& doNext) {
    for (std::size_t i = 0; i < seats_.size(); ++i) {
        seats_[i]->fiber = Fiber(std::allocator_arg, boost::context::protected_fixedsize_stack(kStack),
                                 [this, &doNext, i](Fiber&& driver) {
                                     seats_[i]->driver = std::move(driver);
                                     while (doNext()) {
                                     }
                                     return std::move(seats_[i]->driver);
                                 });
    }
    for (driven_ = seats_.size(); driven_ > 0;) {
        for (std::size_t i = 0; i < seats_.size(); ++i) {
            if (seats_[i]->fiber && !seats_[i]->inputs) resume(i);
        }
        stepSome();
        const Clock::time_point now = Clock::now();
        if (driven_ > 0) share_ += std::chrono::duration<double>(now - looked_).count() / static_cast<double>(driven_);
        looked_ = now;
    }
}

void Convoy::resume(std::size_t seat) {
    Seat& here = *seats_[seat];
    driving_ = seat;
    here.handling.swapWithThread();
    here.fiber = std::move(here.fiber).resume();
    here.handling.swapWithThread();
    if (!here.fiber) --driven_;
}

void Convoy::wait() {
    Seat& here = *seats_[driving_];
    here.driver = std::move(here.driver).resume();
}

double Convoy::share() const {
    return share_ + std::chrono::duration<double>(Clock::now() - looked_).count() / static_cast<double>(driven_);
}

void Convoy::seat(Rider& rider) {
    if (seats_[driving_]->rider) return;  // a car beside the car of this run moves alone
    seats_[driving_]->rider = &rider;
    rider.convoy_ = this;
    rider.seat_ = driving_;
    rider.lane_ = {.vehicle = &rider.vehicle_,
                   .numbers = rider.numbers_.data(),
                   .state = &rider.state_,
                   .motion = {},
                   .road = &rider.road_,
                   .wind_W = {},
                   .tyres_shifted = rider.vehicle_.tyres_shifted,
                   .warmth_felt = rider.vehicle_.warmth_felt,
                   .plane = rider.plane_ ? &*rider.plane_ : nullptr};
}

void Convoy::leave(Rider& rider) {
    seats_[rider.seat_]->rider = nullptr;
    std::replace(loaded_.begin(), loaded_.end(), &rider, static_cast<Rider*>(nullptr));
}

void Convoy::move(Rider& rider) {
    rider.lane_.motion = numbersOf(rider.motion_);
    kind_->move(block_.get(), rider.place_, rider.lane_);
    rider.moved_ = false;
}

void Convoy::step(Rider& rider, const StepInputs& inputs, double dt) {
    Seat& here = *seats_[rider.seat_];
    here.inputs = inputs;
    here.dt = dt;
    wait();
}

void Convoy::fetch(Rider& rider) {
    if (rider.in_lane_ && rider.moved_) move(rider);
    if (!rider.whole_) kind_->store(block_.get(), rider.place_, rider.lane_);
    rider.whole_ = true;
}

// Out of its lane, for another car or to move alone.
void Convoy::putOut(Rider& rider) {
    fetch(rider);
    if (rider.in_lane_) loaded_[rider.place_] = nullptr;
    rider.in_lane_ = false;
}

bool Convoy::isIn(const Rider& rider, std::size_t lane) const {
    return rider.in_lane_ && rider.place_ == lane;
}

// `rider` is in no lane yet, or is repeated in a further one.
void Convoy::fillLane(std::size_t lane, Rider& rider) {
    LaneCar car = rider.lane_;
    fetch(rider);
    if (rider.in_lane_) {
        spare_[lane] = rider.state_;
        car.state = &spare_[lane];
    }
    const Vector3& w = rider.wind_W_;
    car.wind_W = {w.x(), w.y(), w.z()};
    car.motion = numbersOf(rider.motion_);
    kind_->prepare(block_.get(), lane, car);
    kind_->load(block_.get(), lane, car);
    loaded_[lane] = &rider;
    if (!rider.in_lane_) rider.place_ = lane, rider.in_lane_ = true, rider.moved_ = rider.blown_ = false;
}

// Puts these cars into lanes and all others out; what lanes are left repeat one of them.
void Convoy::giveLanes(const std::vector<std::size_t>& together) {
    const auto goes = [&](const Rider& rider) {
        return std::find(together.begin(), together.end(), rider.seat_) != together.end();
    };
    for (std::size_t lane = 0; lane < kind_->lanes; ++lane) {
        if (loaded_[lane] && isIn(*loaded_[lane], lane) && !goes(*loaded_[lane])) putOut(*loaded_[lane]);
    }
    std::size_t lane = 0;
    for (const std::size_t i : together) {
        Rider& rider = *seats_[i]->rider;
        if (!rider.in_lane_) {
            while (loaded_[lane] && isIn(*loaded_[lane], lane)) ++lane;
            fillLane(lane, rider);
        }
        if (rider.moved_) move(rider);
        const Vector3& w = rider.wind_W_;
        if (rider.blown_) kind_->blow(block_.get(), rider.place_, {w.x(), w.y(), w.z()});
        rider.blown_ = false;
    }
    for (lane = 0; lane < kind_->lanes; ++lane) {
        if (!loaded_[lane] || !goes(*loaded_[lane])) fillLane(lane, *seats_[together.front()]->rider);
    }
}

void Convoy::stepTogether(const std::vector<std::size_t>& together) {
    giveLanes(together);
    const Seat& first = *seats_[together.front()];
    const int steps = first.inputs->steps();
    for (int k = 0; k < steps; ++k) {
        std::fill(begin_.begin(), begin_.end(), first.inputs->after(k));
        std::fill(end_.begin(), end_.end(), first.inputs->after(k + 1));
        for (const std::size_t i : together) {
            begin_[seats_[i]->rider->place_] = seats_[i]->inputs->after(k);
            end_[seats_[i]->rider->place_] = seats_[i]->inputs->after(k + 1);
        }
        kind_->step(block_.get(), begin_.data(), end_.data(), kGravity_W, first.dt / steps);
    }
    for (const std::size_t i : together) {
        Rider& rider = *seats_[i]->rider;
        kind_->glance(block_.get(), rider.place_, rider.lane_);
        rider.motion_ = motionOf(rider.lane_.motion);
        rider.whole_ = false;
    }
}

void Convoy::stepAlone(std::size_t seat) {
    Seat& here = *seats_[seat];
    putOut(*here.rider);
    here.rider->moveAlone(*here.inputs, here.dt);
}

// Of those that wait with steps alike: if some fill the lanes, these, and rather those of the last time, who are in
// lanes; else those with the shortest steps, who settle, so that the others have more company when they go on.
std::vector<std::size_t> Convoy::nextSeats() const {
    struct Group {
        const Seat* first;
        std::size_t count;
    };
    const auto alike = [](const Seat& a, const Seat& b) {
        return a.dt == b.dt && a.inputs->steps() == b.inputs->steps();
    };
    std::array<Group, kSeatsPerLane * kMostLanes> groups;
    std::size_t known = 0;
    for (const auto& seat : seats_) {
        if (!seat->inputs) continue;
        const auto end = groups.begin() + static_cast<std::ptrdiff_t>(known);
        const auto same = std::find_if(groups.begin(), end, [&](const Group& one) { return alike(*one.first, *seat); });
        if (same != end) ++same->count;
        else groups[known++] = {seat.get(), 1};
    }
    const Group* best = nullptr;
    for (const Group& one : std::span(groups).first(known)) {
        const bool full = one.count >= kind_->lanes, filled = best && best->count >= kind_->lanes;
        const bool shorter = best && one.first->step() < best->first->step();
        if (!best || (full && (!filled || one.first->step() == stepped_)) || (!full && !filled && shorter)) best = &one;
    }
    std::vector<std::size_t> next;
    if (!best) return next;
    next.reserve(kind_->lanes);
    for (const bool in_lane : {true, false}) {
        for (std::size_t i = 0; i < seats_.size() && next.size() < kind_->lanes; ++i) {
            const Seat& seat = *seats_[i];
            if (seat.inputs && seat.rider->in_lane_ == in_lane && alike(seat, *best->first)) next.push_back(i);
        }
    }
    return next;
}

void Convoy::stepSome() {
    const std::vector<std::size_t> next = nextSeats();
    if (next.empty()) return;
    stepped_ = seats_[next.front()]->step();
    if (next.size() >= kLanesPay) stepTogether(next);
    else
        for (const std::size_t i : next) stepAlone(i);
    for (const std::size_t i : next) seats_[i]->inputs.reset();
}

}  // namespace tread
