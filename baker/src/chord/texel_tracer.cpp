// SPDX-License-Identifier: MIT
#include "chord/texel_tracer.h"

#include "lumi/chord/texel.h"
#include "math/vec3.h"
#include "math/warp.h"

namespace lumi::baker
{

Vec3 OriginDisc::at(const Vec2& u) const
{
    const Vec2 d = square_to_disc(u);
    return frame.normal + frame.tangent * (radius * d.x) + frame.bitangent * (radius * d.y);
}

OriginDisc FieldRays::disc(uint32_t i) const
{
    // π·radius² = 4π/M
    return {Frame(unit_vector(detail::point(origins_, i))), 2 / std::sqrt(static_cast<float>(origins_.size()))};
}

OriginDisc FieldRays::direction_disc(uint32_t j) const
{
    return {Frame(direction_point(j)), 2 / std::sqrt(static_cast<float>(directions_.size()))};
}

Vec3 FieldRays::direction_point(uint32_t j) const
{
    return unit_vector(detail::point(directions_, j));
}

std::optional<Ray> FieldRays::ray(const Vec3& start, const Vec3& target)
{
    const Vec3 towards = target - start;
    const float distance = length(towards);
    if (!(distance > 0)) return std::nullopt;
    return Ray{start, towards / distance, distance};
}

std::optional<Ray> FieldRays::parallel_ray(const Vec3& start, const Vec3& from, const Vec3& to)
{
    const std::optional<Ray> axis = ray(from, to);
    if (!axis) return std::nullopt;
    return Ray{start, axis->direction};
}

TexelTracer::TexelTracer(const SceneData& scene, const BakeSettings& settings)
    : tone_(scene.tone),
      seed_(settings.seed),
      samples_(settings.samples),
      // Texels that end where no path has met a faint shadow or thin smoke yet would lose it.
      max_error_levels_(scene.medium ? 0 : settings.max_error_levels),
      footprint_(settings.footprint),
      beam_(settings.beam),
      rays_(settings.origins, settings.directions),
      tracer_(scene)
{
}

std::optional<Ray> TexelTracer::ray(const OriginDisc& start, const OriginDisc& target, Sampler& sampler) const
{
    const Vec2 u = sampler.next_2d();
    const Vec3 from = footprint_ == Footprint::point ? start.frame.normal : start.at(u);
    const Vec3 to = footprint_ == Footprint::both ? target.at(sampler.next_2d()) : target.frame.normal;
    return beam_ == Beam::parallel ? FieldRays::parallel_ray(from, start.frame.normal, to) : FieldRays::ray(from, to);
}

Estimate TexelTracer::estimate(const OriginDisc& disc, uint32_t i, uint32_t j) const
{
    Estimate result(tone_);
    const OriginDisc target = rays_.direction_disc(j);
    Sampler sampler(seed_, i, j);
    ErrorGauge gauge;
    for (uint32_t s = 0; s < samples_ && !enough(gauge); ++s) {
        sampler.start(s);
        const std::optional<Ray> eye_ray = ray(disc, target, sampler);
        const PathResult path = eye_ray ? tracer_.trace(*eye_ray, sampler) : PathResult{};
        result.add(path);
        gauge.add(path);
    }
    return result;
}

void encode_texel(TexelFormat format, const Palette& palette, const Estimate& estimate, uint8_t* row, uint32_t j)
{
    uint8_t* const at = row + static_cast<size_t>(j) * detail::format::bytes_per_texel(format);
    detail::with_texel(format, [&](auto texel) {
        if constexpr (decltype(texel)::kIndexed)
            *at = nearest_entry(palette, estimate.covered_colour());
        else if (estimate.mostly_covered())  // rows start out as zeros, which mean a miss
            texel.store(at, estimate.colour());
    });
}

}  // namespace lumi::baker
