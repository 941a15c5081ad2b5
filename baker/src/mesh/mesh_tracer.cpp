// SPDX-License-Identifier: MIT
#include "mesh/mesh_tracer.h"

namespace lumi::baker
{
MeshTracer::MeshTracer(Mesh mesh, bool two_sided) : mesh_(std::move(mesh)), two_sided_(two_sided)
{
    if (mesh_.triangle_count() != 0) accelerator_.emplace(mesh_, two_sided ? Faces::both : Faces::front);
}

std::optional<Hit> MeshTracer::closest(const Ray& ray) const
{
    return accelerator_ ? accelerator_->closest(ray) : std::nullopt;
}

}  // namespace lumi::baker
