// SPDX-License-Identifier: MIT
// Samples of the light that leaves a surface field's mesh: pure functions of scene, seed and number.
#pragma once

#include "fit/fit_shape.h"
#include "geometry/view_cap.h"
#include "mesh/mesh_tracer.h"
#include "trace/path_tracer.h"

namespace lumi::baker
{

// The light along one line. Weights of corners are Q12.
struct FitSample {
    uint32_t triangle;  // 2p or 2p + 1 of patch p
    uint32_t texel;
    int16_t second_q12, third_q12;  // barycentric weights of the triangle's corners
    EyePoint eye;                   // on the line
    Rgb radiance;
};

using SampleBatches = std::vector<std::vector<FitSample>>;

template <class Io>
void fields(Io& io, FitSample& s)
{
    io(s.triangle, s.texel, s.second_q12, s.third_q12, s.eye.x, s.eye.y, s.eye.z, s.radiance);
}
// Whether all lie on the mesh.
bool are_of(const SampleBatches& batches, const FitShape& shape);

class SampleTracer
{
public:
    // Borrows scene and shape.
    SampleTracer(const SceneData& scene, const FitShape& shape, const ViewCap& cap = {});

    // The lines of a batch: uniform over all lines through the unit sphere, those outside of the cap left out.
    static constexpr uint32_t kLines = 4096;
    // The light along those of a batch that meet the mesh where the scene is.
    std::vector<FitSample> samples(uint64_t seed, uint32_t batch) const;

    struct Meeting {
        uint32_t mesh = 0, scene = 0;  // lines that meet the mesh, and those of them that count
    };
    // The same without light.
    Meeting meeting(uint64_t seed, uint32_t batch) const;

private:
    struct Line {
        Ray ray;
        Hit hit;
    };
    std::optional<Line> line(Sampler& sampler) const;
    bool scene_is_there(const Line& line, Sampler sampler) const;
    FitSample sample(const Line& line, const Rgb& radiance) const;

    const SceneData& scene_;
    const FitShape& shape_;
    const ViewCap cap_;
    std::vector<uint32_t> numbers_;  // the mesh's triangle for each of the accelerator's
    MeshTracer mesh_;
    PathTracer tracer_;
};

struct SortedSamples {
    std::vector<FitSample> samples;
    std::vector<size_t> begins;  // by patch, and the end

    const FitSample* begin(uint32_t patch) const { return samples.data() + begins[patch]; }
    const FitSample* end(uint32_t patch) const { return samples.data() + begins[patch + 1]; }
};

// Samples of a patch stay in their order.
SortedSamples sorted(const std::vector<std::vector<FitSample>>& batches, uint32_t patches);

}  // namespace lumi::baker
