// SPDX-License-Identifier: MIT
// The estimate of one texel: a pure function of scene, settings and the texel's place.
#pragma once

#include <cstdint>

#include "chord/field_rays.h"
#include "image/palette.h"
#include "lumi/baker/chord.h"
#include "lumi/chord/format.h"
#include "trace/error_gauge.h"
#include "trace/estimate.h"
#include "trace/path_tracer.h"

namespace lumi::baker
{

class TexelTracer
{
public:
    TexelTracer(const SceneData& scene, const BakeSettings& settings);  // borrows the scene

    OriginDisc disc(uint32_t i) const { return rays_.disc(i); }
    // `disc` is disc(i), which a row shares. Any number of threads may call it.
    Estimate estimate(const OriginDisc& disc, uint32_t i, uint32_t j) const;

private:
    std::optional<Ray> ray(const OriginDisc& start, const OriginDisc& target, Sampler& sampler) const;
    bool enough(const ErrorGauge& gauge) const
    {
        return max_error_levels_ > 0 && gauge.settled(tone_, max_error_levels_);
    }

    ToneCurve tone_;
    uint64_t seed_;
    uint32_t samples_;
    float max_error_levels_;
    Footprint footprint_;
    Beam beam_;
    FieldRays rays_;
    PathTracer tracer_;
};

// Writes texel j of a row. `palette` is only read for palette8.
void encode_texel(TexelFormat format, const Palette& palette, const Estimate& estimate, uint8_t* row, uint32_t j);

}  // namespace lumi::baker
