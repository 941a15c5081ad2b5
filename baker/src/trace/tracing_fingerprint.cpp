// SPDX-License-Identifier: MIT
#include "trace/tracing_fingerprint.h"

#include "lumi/detail/lattice.h"
#include "math/frame.h"
#include "math/unit_vector.h"
#include "math/warp.h"
#include "trace/error_gauge.h"
#include "trace/path_tracer.h"
#include "util/digest.h"

namespace lumi::baker
{

uint64_t tracing_fingerprint(const SceneData& scene)
{
    constexpr uint32_t kPathProbes = 2048;
    constexpr uint64_t kProbeSeed = 0x70726F6265;
    const detail::Lattice places(kPathProbes);
    const float radius = 2 / std::sqrt(static_cast<float>(kPathProbes));  // a place's share of the sphere, as a disc
    const PathTracer tracer(scene);
    Digest digest;
    for (uint32_t k = 0; k < kPathProbes; ++k) {
        const uint32_t j = static_cast<uint32_t>(uint64_t{k} * 0x9E3779B9u % kPathProbes);
        const Frame frame(unit_vector(detail::point(places, k)));
        const Vec3 target = unit_vector(detail::point(places, j));
        Sampler sampler(kProbeSeed, k, j);
        const auto path_from = [&](const Vec2& u) -> std::optional<PathResult> {
            const Vec2 d = square_to_disc(u);
            const Vec3 start = frame.normal + frame.tangent * (radius * d.x) + frame.bitangent * (radius * d.y);
            const Vec3 towards = target - start;
            const float distance = length(towards);
            if (!(distance > 0)) return std::nullopt;
            return tracer.trace({start, towards / distance, distance}, sampler);
        };
        sampler.start(0);
        Estimate estimate(scene.tone);
        estimate.add(path_from(sampler.next_2d()).value_or(PathResult{}));
        digest.add(estimate.covered_colour());
        sampler.start(0);
        if (const std::optional<PathResult> path = path_from({})) {
            digest.add(path->covered);
            digest.add(path->radiance);
        }
    }
    return digest.value()[0];
}

}  // namespace lumi::baker
