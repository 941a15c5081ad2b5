// SPDX-License-Identifier: MIT
// A volume in the frame of the unit sphere, ready for light paths. Lengths are the sphere's radii.
//
// Flights are unbiased: a path runs to points that a denser medium would stop it at, and goes on from each with the
// probability that the real one would not (delta tracking: E. Woodcock et al., 1965); the share of light that reaches a
// lamp is the product of those probabilities (ratio tracking: J. Novák, A. Selle and W. Jarosz, "Residual Ratio
// Tracking for Estimating Attenuation in Participating Media", SIGGRAPH Asia 2014). Both draw as many numbers as they
// need.
#pragma once

#include <optional>

#include "geometry/accelerator.h"
#include "math/sampler.h"
#include "util/digest.h"
#include "volume/affine.h"
#include "volume/majorants.h"
#include "volume/phase.h"
#include "volume/volume.h"

namespace lumi::baker
{

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
    // The part of the ray between the outermost voxels' centres.
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
