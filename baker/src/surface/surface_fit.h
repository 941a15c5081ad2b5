// SPDX-License-Identifier: MIT
// From light paths to the colours of a surface field.
//
// A pilot of few paths, kept one by one, finds about which levels each sample shows; then every further path is added
// to sums that are linear around those.
#pragma once

#include <optional>

#include "lumi/baker/surface.h"
#include "surface/surface_solver.h"

namespace lumi::baker
{

class SurfaceFit
{
public:
    // Borrows all.
    SurfaceFit(const SceneData& scene, const SurfaceShape& shape, const SurfaceSettings& settings);

    // Traces. Throws Cancelled.
    void trace(const ProgressCallback& progress);
    uint64_t paths() const { return paths_; }

    // The best for all that was traced; nodes of vertices that are not `viewed` are 0, empty: all are viewed.
    SurfaceModel solve(const std::vector<uint8_t>& viewed, Job& job) const;
    // The texels that go with these nodes.
    void refit_texels(SurfaceModel& model, Job& job) const;
    const SurfaceSums& sums() const { return *sums_; }

private:
    uint32_t batches_for(double paths_per_texel) const;
    void pilot(Job& job);
    SortedSamples traced(uint64_t seed, uint32_t first, uint32_t count, Job& job) const;
    void finish_texels(SurfaceModel& model) const;

    const SurfaceShape& shape_;
    const SurfaceSettings& settings_;
    const EncodedTone tone_;
    const SurfaceTracer tracer_;
    const ViewSmoothness smoothness_;
    double paths_per_batch_;
    SurfaceModel expected_;
    std::optional<SurfaceSums> sums_;
    uint64_t paths_ = 0;
};

}  // namespace lumi::baker
