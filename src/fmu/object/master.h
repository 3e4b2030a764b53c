// What both versions of FMI have in common: calls of a master, whose faults become a status and a text for its log.
#pragma once

#include <exception>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fmu/object/instance.h"

namespace tread::fmu {

// The path of a folder that a master names as a URI ("file:///tmp/a%20b") or as a path.
std::filesystem::path pathOf(std::string_view uri);

// Reads or writes `n` variables.
template <class Number, class Reference>
void getValues(Instance& instance, const Reference* references, std::size_t n, Number* values, bool flags) {
    for (std::size_t i = 0; i < n; ++i) values[i] = static_cast<Number>(instance.get(references[i], flags));
}
template <class Number, class Reference>
void setValues(Instance& instance, const Reference* references, std::size_t n, const Number* values, bool flags) {
    for (std::size_t i = 0; i < n; ++i) instance.set(references[i], static_cast<double>(values[i]), flags);
}

// Runs `action`; what it throws is said and gives `error`.
template <class Status, class Say, class Action>
Status guarded(Status ok, Status error, const Say& say, const Action& action) noexcept {
    try {
        try {
            action();
            return ok;
        } catch (const std::exception& fault) {
            say(fault.what());
        }
    } catch (...) {
    }
    return error;
}

// A saved state as a master's handle, in place of the one that it had, if any.
inline void keep(void*& handle, Instance::Saved state) {
    if (handle) *static_cast<Instance::Saved*>(handle) = std::move(state);
    else handle = new Instance::Saved(std::move(state));
}

// The bytes of a state, into exactly their room.
void writeBytes(const Instance& instance, const void* handle, void* bytes, std::size_t size);

// A handle from bytes.
void readBytes(const Instance& instance, const void* bytes, std::size_t size, void*& handle);

}  // namespace tread::fmu
