// SPDX-License-Identifier: MIT
#include "trace/catcher.h"

#include <array>

#include "lumi/baker/bake.h"
#include "material/lobes.h"
#include "math/warp.h"
#include "trace/hit_point.h"

namespace lumi::baker
{
namespace
{

constexpr Vec3 kZAxis = {0, 0, 1};

// Steps of an additive recurrence in two dimensions, powers of 1/g with g^3 = g + 1: they keep points far apart, after
// M. Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018.
constexpr float kStep1 = 0.7548777f, kStep2 = 0.5698403f;
constexpr float kGoldenFraction = 0.6180340f;  // its one-dimensional kin

constexpr size_t kAimed = kCatcherCandidates / 2;        // drawn by the lights
constexpr size_t kSpread = kCatcherCandidates - kAimed;  // drawn over the hemisphere, of the sky alone
static_assert(kAimed == 16, "radical_inverse() reverses four bits");
constexpr float kEverywhere = std::numeric_limits<float>::infinity();

// Van der Corput's sequence to base 2, for k < 16.
float radical_inverse(size_t k)
{
    const size_t reversed = (k & 1) << 3 | (k & 2) << 1 | (k & 4) >> 1 | (k & 8) >> 3;
    return static_cast<float>(reversed) / 16;
}

float fraction(float x)
{
    return x - std::floor(x);
}

// Samples of the lights, evenly spread, each weighed by what it would add to the irradiance on a level face. The sky is
// sampled both by its brightness and by the face's cosine, and weighed by the balance heuristic (Veach 1997, ch. 9).
class Candidates
{
public:
    Candidates(const LightSet& lights, const Vec3& from, Sampler& sampler)
    {
        const Vec2 choice = sampler.next_2d(), place = sampler.next_2d(), direction = sampler.next_2d();
        for (size_t k = 0; k < kAimed; ++k) {
            const float step = static_cast<float>(k);
            // Each place in the row of lights, and in the row of one light's parts, gets its share of the samples.
            add(lights.sample_outside(from, fraction(choice.x + step / kAimed), fraction(choice.y + radical_inverse(k)),
                                      {fraction(place.x + step * kStep1), fraction(place.y + step * kStep2)}));
        }
        for (size_t k = 0; k < kSpread; ++k) {
            const float step = static_cast<float>(k);
            const Vec3 towards = square_to_cosine_hemisphere(
                {fraction(direction.x + step / kSpread), fraction(direction.y + step * kGoldenFraction)});
            add({towards, kEverywhere, lights.sky_radiance(towards), lights.outside_sky_pdf(towards)});
        }
    }

    bool dark() const { return !(total_ > 0); }
    // One of them with a probability proportional to its weight.
    const LightSample& draw(float u) const
    {
        const auto found = std::upper_bound(up_to_.begin(), up_to_.end(), u * total_);
        const auto last = std::lower_bound(up_to_.begin(), up_to_.end(), total_);
        return samples_[static_cast<size_t>(std::min(found, last) - up_to_.begin())];
    }

private:
    void add(const LightSample& sample)
    {
        const float cosine = sample.direction.z;
        const bool sky = !sample.dirac && sample.distance == kEverywhere;
        const float density = kAimed * sample.pdf + (sky ? kSpread * cosine_pdf(sample.direction) : 0.0f);
        total_ += sample.pdf > 0 && cosine > 0 ? luminance(sample.radiance) * cosine / density : 0.0f;
        samples_[count_] = sample;
        up_to_[count_++] = total_;
    }

    size_t count_ = 0;
    std::array<LightSample, kCatcherCandidates> samples_;
    std::array<float, kCatcherCandidates> up_to_;  // sums of weights
    float total_ = 0;
};

}  // namespace

std::optional<float> distance_to_catcher(const Disc& catcher, const Ray& ray)
{
    const float height = ray.origin.z - catcher.centre.z;
    if (!(height > 0) || !(ray.direction.z < 0)) return std::nullopt;
    const float distance = -height / ray.direction.z;
    const Vec3 aside = ray.origin + ray.direction * distance - catcher.centre;
    const bool inside = aside.x * aside.x + aside.y * aside.y <= catcher.radius * catcher.radius;
    return inside && distance < ray.end ? std::optional<float>(distance) : std::nullopt;
}

float shadow_at(const SceneData& scene, const Vec3& position, Sampler& sampler)
{
    if (scene.lights.none_outside()) return 0;
    const Candidates candidates(scene.lights, position, sampler);
    const float u = sampler.next_1d();
    if (candidates.dark()) return 0;
    const LightSample& light = candidates.draw(u);
    const HitPoint floor = {{}, position, kZAxis, Frame(kZAxis), nullptr, {}, {}};
    return 1 - max_component(transmittance(scene, floor.ray_to_light(light.direction, light.distance), sampler));
}

void require_partial_coverage(const SceneData& scene, bool texels_have_it)
{
    if (texels_have_it) return;
    if (scene.catcher) {
        throw BakeError(
            "the scene's 'catcher' needs texels that are partly covered; bake with --layout chord --texel "
            "palette8, or take a 'ground' in its place");
    }
    if (scene.medium && !scene.mesh_is_shell) {
        throw BakeError(
            "the scene's 'volume' is half transparent and needs texels that are partly covered; bake with --layout "
            "chord --texel palette8");
    }
}

}  // namespace lumi::baker
