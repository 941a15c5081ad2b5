// SPDX-License-Identifier: MIT
#include "guided/guided_settings.h"

#include "lumi/baker/bake.h"

namespace lumi::baker
{
namespace
{

void require(bool good, const std::string& message)
{
    if (!good) {
        throw BakeError(message);
    }
}

void require_range(uint32_t value, uint32_t low, uint32_t high, const std::string& name)
{
    require(value >= low && value <= high,
            name + " of a guided field must lie in " + std::to_string(low) + " to " + std::to_string(high));
}

}  // namespace

GuidedSettings checked(const GuidedSettings& settings)
{
    GuidedSettings s = settings;
    require_range(s.origins, format::kMinGuidedOrigins, format::kMaxGuidedOrigins, "the number of origins");
    require_range(s.chart_size, format::kMinChart, format::kMaxChart, "the chart's size");
    require(s.used_origins <= s.origins, "the cap holds " + std::to_string(s.used_origins) + " origins of " +
                                             std::to_string(s.origins) + "; choose at most all of them, or 0 for all");
    require(s.samples >= 1, "the number of samples must be at least 1");
    require(s.jitter >= 0 && s.jitter <= 2, "the jitter must lie in 0 to 2 cells");
    s.used_origins = s.used_origins == 0 ? s.origins : s.used_origins;
    if (s.surface == format::GuidedSurface::focus) {
        require(s.texel != format::GuidedTexel::none, "a refocused field consists of texels; choose 4 or 8 bits");
        require(s.texel != format::GuidedTexel::vq8,
                "texels of a refocused field say where there is nothing, which blocks cannot; choose 4 or 8 bits");
        require(s.focus_radius >= 0, "the focus sphere's radius must not be negative");
        s.mean_resolution = 0;
        s.occlusion = false;
        return s;
    }
    require_range(s.proxy_triangles, 1, format::kMaxProxyTriangles, "the number of proxy triangles");
    require(s.mean_resolution != 0 || s.texel != format::GuidedTexel::none,
            "a guided field needs mean colours, texels or both");
    if (s.mean_resolution != 0) {
        require_range(s.mean_resolution, format::kMinMean, format::kMaxMean, "the resolution of the mean colours");
    }
    s.occlusion = s.occlusion && s.texel != format::GuidedTexel::none;
    return s;
}

PackedFocus focus_of(const SceneData& scene, const GuidedSettings& settings)
{
    constexpr double kOneQ14 = 16384;
    std::array<double, 3> f = {};
    for (size_t axis = 0; settings.focus && axis < 3; ++axis) {
        f[axis] = (static_cast<double>((*settings.focus)[axis]) - scene.centre[axis]) / scene.radius;
    }
    f = scene.up == UpAxis::y ? std::array<double, 3>{f[2], f[0], f[1]} : f;
    const double radius = static_cast<double>(settings.focus_radius) / scene.radius;
    require(std::hypot(f[0], f[1], f[2]) + radius <= 1,
            "the focus sphere reaches out of the bounding sphere; move it inwards or make it smaller");
    PackedFocus focus = {};
    for (size_t axis = 0; axis < 3; ++axis) {
        focus.point_q14[axis] = static_cast<int16_t>(std::lround(f[axis] * kOneQ14));
    }
    focus.radius_q14 = static_cast<uint16_t>(std::lround(radius * kOneQ14));
    return focus;
}

}  // namespace lumi::baker
