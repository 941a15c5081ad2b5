// SPDX-License-Identifier: MIT
// The header of Catch2 2, for Catch2 3: names that moved, as the tests use them.
#pragma once
#include <catch2/catch_all.hpp>

namespace Catch
{

using Matchers::EndsWith;
using Matchers::StartsWith;

inline auto Contains(const std::string& part)
{
    return Matchers::ContainsSubstring(part);
}

}  // namespace Catch

using Catch::Approx;
