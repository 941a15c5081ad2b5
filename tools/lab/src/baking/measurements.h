// SPDX-License-Identifier: MIT
// These measure what the baker costs; each returns rows of a table.
#pragma once

#include <nlohmann/json.hpp>

namespace lumi::baker::bench
{

using Json = nlohmann::ordered_json;

// Measures the error against the number of light paths.
Json convergence(const char* scene_file, unsigned rows);
// Measures what adaptive sampling leaves out and its error, on so many texels.
Json adaptive(const char* scene_file, unsigned texels);
// Measures paths a second against the number of threads.
Json thread_rates(const char* scene_file, unsigned rows);
// Measures the memory of a scene of that many triangles.
Json memory(unsigned triangles);

}  // namespace lumi::baker::bench
