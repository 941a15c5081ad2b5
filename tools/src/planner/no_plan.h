// SPDX-License-Identifier: MIT
// The failure of both planners.
#pragma once

#include <stdexcept>

namespace lumi::planner
{

// No plan fits; what() says what would.
struct NoPlan : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace lumi::planner
