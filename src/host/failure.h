// What a host program asked for and cannot have, in one sentence for its user.
#pragma once

#include <stdexcept>
#include <string>

namespace tread::host {

class Failure : public std::runtime_error {
public:
    // Faulty: what the host gave. Broken: the car, which cannot go on from here.
    enum class Kind { faulty, broken };
    Failure(Kind of, const std::string& text) : std::runtime_error(text), kind(of) {}

    Kind kind;
};

[[noreturn]] inline void refuse(const std::string& text) {
    throw Failure(Failure::Kind::faulty, text);
}

}  // namespace tread::host
