// SPDX-License-Identifier: MIT
// The tables about speed and accuracy, docs/log/tradeoff.md.
#pragma once

#include <string>
#include <vector>

#include "bench/baselines.h"
#include "bench/matrix.h"

namespace lumi::bench
{

// `plots` are paths of pictures, relative to the page.
std::string markdown_page(const Results& results, const SurfaceResults& surface, const Baselines& baselines,
                          const std::vector<std::string>& plots, const FieldSettings& field);

}  // namespace lumi::bench
