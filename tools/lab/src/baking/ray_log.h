// SPDX-License-Identifier: MIT
// Every ray that the baker asks Embree for, in order, and the time that Embree alone takes for them.
//
// ray_log.cpp defines Embree's two query functions, which the linker prefers to those of the library: the baker calls
// them, they note the ray where that is wanted and pass it on. The baker itself knows nothing of it.
#pragma once

#include <cstdint>

namespace lumi::baker::bench
{

// Between start() and stop() rays are noted, from one thread.
void start_ray_log();
void stop_ray_log();

struct RayCounts {
    uint64_t closest = 0, blocked = 0;
    uint64_t all() const { return closest + blocked; }
};

RayCounts logged_rays();

// CPU seconds of the calling thread for the same queries on the same trees, and nothing else. Their answers go to the
// checksum, so that no query can be left out.
struct Replay {
    double seconds = 0;
    double checksum = 0;
};

Replay replay_ray_log();

// CPU seconds that the calling thread has taken.
double thread_seconds();

}  // namespace lumi::baker::bench
