// SPDX-License-Identifier: MIT
// All emissive triangles of a mesh as one area light; a triangle is chosen by its power. Both sides shine.
#pragma once

#include <vector>

#include "light.h"
#include "material.h"
#include "mesh.h"

namespace lumi::baker
{

class Emitters : public Light
{
public:
    // Borrows both; they must outlive the light.
    Emitters(const Mesh& mesh, const std::vector<Material>& materials);

    size_t count() const { return triangles_.size(); }
    // Solid-angle density of reaching, from a point, the emissive triangle that lies at `distance` along `direction`.
    float pdf(uint32_t triangle, const Vec3& direction, float distance) const;

    float power() const override;
    LightSample sample(const Vec3& from, float u_select, const Vec2& u) const override;

private:
    float brightness(uint32_t triangle) const;

    const Mesh& mesh_;
    const std::vector<Material>& materials_;
    std::vector<uint32_t> triangles_;
    std::vector<double> cumulative_;  // area × brightness, summed up; one entry a triangle
};

}  // namespace lumi::baker
