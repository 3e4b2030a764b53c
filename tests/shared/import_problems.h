// The faults of a call that must fail, and a shorthand for channels.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "log/log.h"
#include "tread/problem.h"

namespace tread {

// All faults as text; a test failure when there are none.
std::string faultsOf(auto&& call) {
    try {
        call();
    } catch (const LoadError& error) {
        return error.what();
    }
    ADD_FAILURE() << "no fault";
    return {};
}

inline const std::vector<double>& valuesOf(const Log& log, const std::string& name) {
    static const std::vector<double> nothing;
    const Channel* const channel = log.find(name);
    EXPECT_NE(channel, nullptr) << name;
    return channel ? channel->values : nothing;
}

}  // namespace tread
