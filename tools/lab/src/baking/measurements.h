// SPDX-License-Identifier: MIT
// What the baker costs: each returns rows of a table.
#pragma once

#include <nlohmann/json.hpp>

namespace lumi::baker::bench
{

using Json = nlohmann::ordered_json;

// How much of a bake's time Embree alone takes for the same rays.
Json share(const char* scene_file, unsigned rows);
// The same for an OBJ file whose surfaces are all made matt.
Json matt_share(const char* obj_file, unsigned rows);
// Error against the number of light paths.
Json convergence(const char* scene_file, unsigned rows);
// What adaptive sampling leaves out, and what it costs in error, on so many texels.
Json adaptive(const char* scene_file, unsigned texels);
// Paths a second against the number of threads.
Json thread_rates(const char* scene_file, unsigned rows);
// Memory of a scene of that many triangles.
Json memory(unsigned triangles);

}  // namespace lumi::baker::bench
