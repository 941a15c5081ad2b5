// SPDX-License-Identifier: MIT
// Which texels the benchmarks trace: whole rows of a field, as a bake does, at origins all over the sphere.
#pragma once

#include "chord/texel_tracer.h"
#include "scene/scene_data.h"

namespace lumi::baker::bench
{

struct Rows {
    BakeSettings settings;
    uint32_t count;  // how many rows

    uint64_t texels() const { return uint64_t{count} * settings.directions; }
    uint64_t paths() const { return texels() * settings.samples; }
    uint32_t origin(uint32_t row) const
    {
        return static_cast<uint32_t>((2 * uint64_t{row} + 1) * settings.origins / (2 * count));
    }
};

Scene load(const char* file);

// The encoded colours of texels; none where most rays miss.
using Colours = std::vector<std::optional<Rgb8>>;

inline std::optional<Rgb8> colour_of(const Estimate& estimate)
{
    return estimate.mostly_covered() ? std::optional(estimate.colour()) : std::nullopt;
}

// Differences in steps of 255 over all channels of texels that both sides cover.
struct Difference {
    double rms = 0, mean = 0;
};

Difference difference(const Colours& found, const Colours& truth);

// Calls take(estimate) for every texel of the rows, on the calling thread.
template <class Take>
void trace_rows(const Scene& scene, const Rows& rows, const Take& take)
{
    const TexelTracer tracer(scene.data(), rows.settings);
    for (uint32_t row = 0; row < rows.count; ++row) {
        const uint32_t i = rows.origin(row);
        const OriginDisc disc = tracer.disc(i);
        for (uint32_t j = 0; j < rows.settings.directions; ++j) take(tracer.estimate(disc, i, j));
    }
}

}  // namespace lumi::baker::bench
