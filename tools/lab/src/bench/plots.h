// SPDX-License-Identifier: MIT
// Cost against accuracy, one plot per core.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/matrix.h"

namespace lumi::bench
{

// "tradeoff-<core>.svg".
std::string plot_name(const std::string& core);

// Writes plot_name(core) of the generic view into `folder` (made if missing); returns the file names.
std::vector<std::string> write_plots(const Results& results, const std::filesystem::path& folder);

}  // namespace lumi::bench
