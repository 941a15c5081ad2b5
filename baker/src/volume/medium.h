// SPDX-License-Identifier: MIT
// A volume in the frame of the unit sphere, ready for light paths. Lengths are the sphere's radii.
//
// Flights are unbiased: a path runs to points that a denser medium would stop it at, and goes on from each with the
// probability that the real one would not (delta tracking: E. Woodcock et al., 1965); the share of light that reaches a
// lamp is the product of those probabilities (ratio tracking: J. Novák, A. Selle and W. Jarosz, "Residual Ratio
// Tracking for Estimating Attenuation in Participating Media", SIGGRAPH Asia 2014). Both draw as many numbers as they
// need.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/accelerator.h"
#include "math/sampler.h"
#include "math/vec3.h"
#include "math/warp.h"
#include "util/digest.h"
#include "volume/affine.h"
#include "volume/grid.h"
#include "volume/volume.h"

namespace lumi::baker
{

// Into which directions a medium scatters: L. Henyey and J. Greenstein, "Diffuse radiation in the galaxy", 1941.
// Cosines are between the ways of the light before and after: 1 is straight on.

class Phase
{
public:
    // g: the mean cosine, between -1 and 1 and neither of them; 0 scatters alike into all directions.
    explicit Phase(float g = 0) : g_(g) {}

    // Returns per solid angle both the value and the density of sample().
    float density(float cosine) const
    {
        const float d = 1 + g_ * g_ - 2 * g_ * cosine;
        return (1 - g_ * g_) / (4 * kPi * d * std::sqrt(d));
    }

    Vec3 sample(const Vec3& way, const Vec2& u) const { return Frame(way).to_world(direction_at(cosine_of(u.x), u.y)); }

    float anisotropy() const { return g_; }

private:
    float cosine_of(float u) const
    {
        constexpr float kEven = 1e-3f;  // below it the other formula loses its digits; this one is off by less than 2·g
        if (std::abs(g_) < kEven) return 1 - 2 * u;
        const float q = (1 - g_ * g_) / (1 + g_ - 2 * g_ * u);
        return std::clamp((1 + g_ * g_ - q * q) / (2 * g_), -1.0f, 1.0f);
    }

    float g_;
};

// The largest density in each block of a volume: a ray passes empty blocks without a look, and takes steps in the
// others that suit their densest part.

// A ray in voxel coordinates: where it is after `t` of the units of its direction, which is no unit vector.
struct VoxelRay {
    Vec3 origin, direction;
    Vec3 at(float t) const { return origin + direction * t; }
};

class Majorants
{
public:
    static constexpr uint32_t kBlock = 8;  // cells between voxel centres, a side

    Majorants(const Grid& grid, const TransferFunction& transfer);

    float most() const;
    // Calls use(t0, t1, majorant) for each block along the ray between the two, as long as it returns true.
    template <class Use>
    void walk(const VoxelRay& ray, float start, float end, const Use& use) const;
    // Corners, in voxel coordinates, of the blocks that are not empty.
    std::vector<Vec3> corners() const;

private:
    float at(const std::array<int32_t, 3>& block) const
    {
        return blocks_[static_cast<size_t>((block[2] * counts_[1] + block[1]) * counts_[0] + block[0])];
    }

    std::array<uint32_t, 3> cells_;  // cells along each side of the grid
    std::array<int32_t, 3> counts_;  // blocks along each side
    std::vector<float> blocks_;      // x fastest
};

// From block to block as the ray goes: J. Amanatides and A. Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing",
// Eurographics 1987.
template <class Use>
void Majorants::walk(const VoxelRay& ray, float start, float end, const Use& use) const
{
    constexpr float kSide = kBlock;
    const Vec3 first = ray.at(start);
    const std::array<float, 3> place = {first.x, first.y, first.z};
    const std::array<float, 3> origin = {ray.origin.x, ray.origin.y, ray.origin.z};
    const std::array<float, 3> way = {ray.direction.x, ray.direction.y, ray.direction.z};
    std::array<int32_t, 3> block, step;
    std::array<float, 3> next, width;  // t of the next border, and from border to border
    for (size_t k = 0; k < 3; ++k) {
        block[k] = std::clamp(static_cast<int32_t>(place[k] / kSide), 0, counts_[k] - 1);
        step[k] = way[k] > 0 ? 1 : -1;
        const float border = static_cast<float>(block[k] + (way[k] > 0 ? 1 : 0)) * kSide;
        next[k] = way[k] != 0 ? (border - origin[k]) / way[k] : std::numeric_limits<float>::infinity();
        width[k] = kSide / std::abs(way[k]);
    }
    for (float t = start; t < end;) {
        const size_t k = next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
        const float border = std::min(next[k], end);
        if (border > t && !use(t, border, at(block))) return;
        t = std::max(t, border);
        block[k] += step[k];
        next[k] += width[k];
        if (block[k] < 0 || block[k] >= counts_[k]) return;
    }
}

class Medium
{
public:
    // `to_world` takes a point of the unit sphere's frame to the volume's units and axes; `radius` is its scale.
    Medium(Volume volume, const Affine& to_world, double radius);

    // Where the ray is scattered or absorbed before its end; nothing if it is not.
    std::optional<float> collision(const Ray& ray, Sampler& sampler) const;
    // An estimate, with the right mean, of the share of light that gets through to the ray's end.
    float transmittance(const Ray& ray, Sampler& sampler) const;

    float density(const Vec3& point) const;  // extinction, 1 / radius; 0 outside of the grid
    Rgb colour(const Vec3& point) const;     // albedo of what is scattered there
    const Phase& phase() const { return phase_; }

    void add_to(Digest& digest) const;  // all that decides light paths

private:
    struct Part {
        VoxelRay ray;
        float start, end;
    };
    // Returns the part of the ray between the outermost voxels' centres.
    std::optional<Part> inside(const Ray& ray) const;
    VoxelRay to_voxels(const Ray& ray) const;
    float scalar(const Vec3& voxel) const;
    float density_at(const Vec3& voxel) const { return transfer_.density(scalar(voxel)) * radius_; }

    Grid grid_;
    TransferFunction transfer_;
    Phase phase_;
    Majorants majorants_;
    float radius_;
    float voxels_[3][4];  // from the unit sphere's frame to voxel coordinates
};

}  // namespace lumi::baker
