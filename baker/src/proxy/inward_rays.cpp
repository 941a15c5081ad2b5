// SPDX-License-Identifier: MIT
#include "proxy/inward_rays.h"

#include "math/frame.h"
#include "math/unit_vector.h"

namespace lumi::baker
{

InwardRays::InwardRays(const Lattice& origins, uint32_t origin) : origin_(unit_vector(point(origins, origin)))
{
    const Frame frame(origin_);
    tangent_ = frame.tangent;
    bitangent_ = frame.bitangent;
}

Ray InwardRays::ray(const Vec2& place) const
{
    const float inwards = std::sqrt(std::max(0.0f, 1 - place.x * place.x - place.y * place.y));
    return {origin_, normalized(tangent_ * place.x + bitangent_ * place.y - origin_ * inwards)};
}

}  // namespace lumi::baker
