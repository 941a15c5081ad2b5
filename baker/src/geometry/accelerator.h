// SPDX-License-Identifier: MIT
// Answers ray queries against a mesh.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

#include "geometry/mesh.h"

namespace lumi::baker
{

struct Ray {
    Vec3 origin;
    Vec3 direction;  // unit length
    float end = std::numeric_limits<float>::infinity();
};

struct Hit {
    uint32_t triangle;
    float distance;
    float u, v;  // barycentric weights of the second and third corner
};

// The faces that `closest` meets. A front face winds counter-clockwise seen from where the ray begins.
enum class Faces : uint8_t { both, front };

// Queries are watertight and may run on any number of threads. The same mesh always gives the same answers.
class Accelerator
{
public:
    explicit Accelerator(const Mesh& mesh, Faces faces = Faces::both);  // copies what it needs
    Accelerator(Accelerator&&) noexcept;
    ~Accelerator();

    std::optional<Hit> closest(const Ray& ray) const;
    bool blocked(const Ray& ray) const;  // by a face of either kind

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace lumi::baker
