// SPDX-License-Identifier: MIT
// Samples of the light that leaves a surface field's mesh: pure functions of scene, seed and number.
#pragma once

#include "fit/texel_lines.h"
#include "geometry/view_cap.h"
#include "mesh/mesh_tracer.h"
#include "scene/moving_parts.h"
#include "trace/path_tracer.h"

namespace lumi::baker
{

// View tables are read in the direction from a vertex to the eye, so the fit needs eyes. This one sees along a ray from
// as far off as pictures are mostly drawn from, 3 radii from the centre.
Vec3 eye_of(const Ray& ray);

// The light along one line. Weights of corners are Q12.
struct FitSample {
    uint32_t triangle;  // 2p or 2p + 1 of patch p
    uint32_t texel;
    int16_t second_q12, third_q12;  // barycentric weights of the triangle's corners
    EyePoint eye;                   // on the line
    Rgb radiance, matt;             // of PathResult
};

// A sample of a see-through texel by the light along a line.
struct PassingSample {
    uint32_t texel;
    float opacity;
    Rgb through;   // the share of light that passes
    bool passes;   // goes on behind the texel
    bool covered;  // meets something there
    Rgb radiance;  // what comes from there to the texel's back, or 0
};

using SampleBatches = std::vector<std::vector<FitSample>>;

template <class Io>
void fields(Io& io, FitSample& s)
{
    io(s.triangle, s.texel, s.second_q12, s.third_q12, s.eye.x, s.eye.y, s.eye.z, s.radiance, s.matt);
}
// Whether all lie on the mesh.
bool are_of(const SampleBatches& batches, const FitShape& shape);

class SampleTracer
{
public:
    // Borrows scene and shape.
    SampleTracer(const SceneData& scene, const FitShape& shape, const ViewCap& cap = {});

    // Appends the light along so many lines to a texel (fit/texel_lines.h), which counts from its patch's first. Those
    // are left out that come from outside of the cap or meet something else first, or no scene where the mesh is.
    void trace(uint64_t seed, uint32_t patch, uint32_t texel, uint32_t lines, std::vector<FitSample>& samples) const;

    // See-through texels of the lines of a batch: uniform over all lines through the unit sphere, those outside of the
    // cap left out.
    static constexpr uint32_t kLines = 4096;
    std::vector<PassingSample> passing(uint64_t seed, uint32_t batch) const;

private:
    struct Line {
        Ray ray;
        Hit hit;    // its triangle has the mesh's number
        Rgb panes;  // what panes before it make of a path's light
    };
    struct PartTracer {
        PartTracer(const std::vector<LitPose>& lit, const PatchMesh& of, uint32_t owner);

        const std::vector<LitPose>& poses;
        const bool light_stays;
        std::vector<uint32_t> numbers;
        MeshTracer mesh;
    };
    // The line in the part's own pose, and the same in one of those that light it.
    struct PartLine {
        Line own;
        Ray posed;
        const LitPose* pose;
    };
    const LitPose& pose_along(const Ray& ray, float distance, const PartTracer& part, Sampler& sampler) const;
    std::optional<PartLine> line_to_part(const Ray& ray, const PartTracer& part, Sampler& sampler) const;
    std::optional<FitSample> sample_of_part(const Ray& ray, uint32_t patch, const PartTracer& part,
                                            Sampler& sampler) const;
    std::optional<FitSample> sample_of_body(const Ray& ray, uint32_t patch, Sampler& sampler) const;
    std::optional<Ray> ray(Sampler& sampler) const;
    std::optional<Line> line(const Ray& ray, Sampler& sampler) const;
    std::optional<Line> line_to_mesh(const Ray& ray) const;
    bool scene_is_there(const Line& line, Sampler sampler) const;
    // The line to the mesh's triangle that stands for the surface at which the path of a scene with see-through parts
    // begins.
    std::optional<Line> see_through_line(const Ray& ray, Sampler ahead) const;
    std::optional<Line> line_to(const Ray& ray, const Hit& in_scene) const;
    bool is_see_through(const Hit& in_scene) const;
    uint32_t texel_of(const Hit& hit) const;
    // `seen`: the ray to an eye, for which view tables are read.
    FitSample sample(const Line& line, const Ray& seen, const PathResult& path) const;

    const LitScenes lit_;
    const SceneData& scene_;  // the body
    const FitShape& shape_;
    const ViewCap cap_;
    std::vector<bool> see_through_;                        // by material; empty where the mesh has no such part
    std::vector<uint32_t> numbers_, see_through_numbers_;  // the mesh's triangle for each of an accelerator's
    MeshTracer mesh_, see_through_mesh_;
    PathTracer tracer_;
    std::vector<std::unique_ptr<PartTracer>> parts_;
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
