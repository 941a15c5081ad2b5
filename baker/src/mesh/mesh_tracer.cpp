// SPDX-License-Identifier: MIT
#include "mesh/mesh_tracer.h"

namespace lumi::baker
{

MeshTracer::MeshTracer(Mesh mesh, Faces faces) : mesh_(std::move(mesh)), faces_(faces)
{
    if (mesh_.triangle_count() != 0) accelerator_.emplace(mesh_, faces);
}

std::optional<Hit> MeshTracer::closest(const Ray& ray) const
{
    return accelerator_ ? accelerator_->closest(ray) : std::nullopt;
}

}  // namespace lumi::baker
