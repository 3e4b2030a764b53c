// One value per axle or per wheel: named for files and logs, indexed for loops.
#pragma once

#include <cstddef>

#include "tread/describe.h"

namespace tread {

inline constexpr std::size_t kAxles = 2;
inline constexpr std::size_t kWheels = 4;

// Wheels in the order front left, front right, rear left, rear right.
constexpr std::size_t axleOf(std::size_t wheel) {
    return wheel / 2;
}
constexpr bool isLeft(std::size_t wheel) {
    return wheel % 2 == 0;
}
// +1 on the left (y > 0 in ISO 8855), -1 on the right.
constexpr double sideSign(std::size_t wheel) {
    return isLeft(wheel) ? 1.0 : -1.0;
}

template <class T>
struct PerAxle {
    T front{};
    T rear{};

    constexpr T& operator[](std::size_t axle) { return axle == 0 ? front : rear; }
    constexpr const T& operator[](std::size_t axle) const { return axle == 0 ? front : rear; }

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(front), About{"", "front axle"});
        field(TREAD_FIELD(rear), About{"", "rear axle"});
    }
};

template <class T>
struct PerWheel {
    T front_left{};
    T front_right{};
    T rear_left{};
    T rear_right{};

    constexpr T& operator[](std::size_t wheel) { return select(*this, wheel); }
    constexpr const T& operator[](std::size_t wheel) const { return select(*this, wheel); }

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(front_left), About{"", "front left wheel"});
        field(TREAD_FIELD(front_right), About{"", "front right wheel"});
        field(TREAD_FIELD(rear_left), About{"", "rear left wheel"});
        field(TREAD_FIELD(rear_right), About{"", "rear right wheel"});
    }

private:
    static constexpr auto& select(auto& self, std::size_t wheel) {
        switch (wheel) {
            case 0:
                return self.front_left;
            case 1:
                return self.front_right;
            case 2:
                return self.rear_left;
            default:
                return self.rear_right;
        }
    }
};

}  // namespace tread
