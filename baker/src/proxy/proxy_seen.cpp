// SPDX-License-Identifier: MIT
#include "proxy/proxy_seen.h"

#include "proxy/proxy_survey.h"

namespace lumi::baker
{

Mesh seen_part(const SceneData& scene, const Mesh& mesh, bool two_sided, Job& job)
{
    const ProxyTracer tracer(mesh, two_sided);
    const Survey survey = fitting_survey(scene, mesh);
    std::vector<std::vector<uint8_t>> seen(survey.origins(), std::vector<uint8_t>(mesh.triangle_count(), 0));
    job.run(survey.origins(), [&](uint32_t i) {
        for (const SurveyRay& r : survey.look(i, tracer)) {
            if (r.proxy) {
                seen[i][r.proxy->triangle] = 1;
            }
        }
    });
    Mesh result;
    result.positions = mesh.positions;
    for (size_t k = 0; k < mesh.triangle_count(); ++k) {
        if (std::any_of(seen.begin(), seen.end(), [k](const std::vector<uint8_t>& part) { return part[k] != 0; })) {
            result.corners.push_back(mesh.corners[k]);
        }
    }
    return result;
}

}  // namespace lumi::baker
