// SPDX-License-Identifier: MIT
// The failure of every planner.
#pragma once

#include <stdexcept>

namespace lumi::planner
{

// No plan fits, or none is fast enough; what() says which would.
struct NoPlan : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace lumi::planner
