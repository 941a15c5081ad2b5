// SPDX-License-Identifier: MIT
// What the benchmark program measures; each prints rows of a Markdown table.
#pragma once

namespace lumi::baker::bench
{

// How much of a bake's time Embree alone takes for the same rays.
void print_share(const char* scene_file, unsigned rows);
// The same for an OBJ file whose surfaces are all made matt.
void print_matt_share(const char* obj_file, unsigned rows);
// Error against the number of light paths.
void print_convergence(const char* scene_file, unsigned rows);
// What adaptive sampling leaves out, and what it costs in error, on so many texels.
void print_adaptive(const char* scene_file, unsigned texels);
// Paths a second against the number of threads.
void print_threads(const char* scene_file, unsigned rows);
// Memory of a scene of that many triangles.
void print_memory(unsigned triangles);

}  // namespace lumi::baker::bench
