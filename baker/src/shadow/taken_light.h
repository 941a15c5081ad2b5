// SPDX-License-Identifier: MIT
// How much of a place's light something takes away.
#pragma once

#include <cstdint>

#include "fit/encoded_tone.h"
#include "trace/path_tracer.h"

namespace lumi::baker
{

struct TakenLight {
    float taken = 0, without = 0;  // the share that is taken, 0 .. 1, of the light without it
};

struct PathNumbers {
    uint32_t paths;
    uint64_t seed;
    uint32_t place;
};

// Traces a ray in two scenes, in which paths draw the same numbers.
TakenLight taken_light(const Ray& ray, const PathTracer& with, const PathTracer& without, const PathNumbers& numbers);

// The share of the levels behind, 0 .. 255, that stays where this much light becomes so small a part of it.
uint8_t passed_share(const EncodedTone& tone, float light, float rest);

}  // namespace lumi::baker
