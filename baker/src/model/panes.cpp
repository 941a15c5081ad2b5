// SPDX-License-Identifier: MIT
#include "model/panes.h"

#include <algorithm>

#include "geometry/open_edges.h"

namespace lumi::baker
{

size_t make_panes(SceneParts& parts, const std::vector<bool>& wanted)
{
    if (std::find(wanted.begin(), wanted.end(), true) == wanted.end()) return 0;
    const size_t count = parts.materials.size();
    constexpr float kSheet = 0.4f;
    const std::vector<float> flat = flatnesses(parts.mesh, places_of(parts.mesh), count);
    const std::vector<float> thick = thicknesses(parts.mesh, count);
    size_t panes = 0;
    for (size_t k = 0; k < count; ++k) {
        Material& m = parts.materials[k];
        if (!wanted[k] || !m.glass || (flat[k] < kSheet && thick[k] > 0)) continue;
        m.glass = false;
        m.thin = m.specular = true;
        m.tint = m.tint * m.transmittance;
        m.finish();
        ++panes;
    }
    return panes;
}

}  // namespace lumi::baker
