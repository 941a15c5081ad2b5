// SPDX-License-Identifier: MIT
#include "scene/light_choice.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

#include "math/sampler.h"
#include "math/vec3.h"
#include "math/warp.h"
#include "util/fuzzed.h"

namespace lumi::baker
{

namespace
{

constexpr uint64_t kMeterSeed = 0x6c69676874;
constexpr uint32_t kMeterRays = kIsFuzzed ? 16 : 1024;  // through the sphere; about half of them meet a compact object
constexpr uint32_t kPathsAtSpot = kIsFuzzed ? 2 : 16;   // from each place that they meet
constexpr int kClayBounces = 3;  // light goes between surfaces of clay, which then carry a fifth of it
constexpr float kClay = 0.6f;    // the share of light that clay sends back, as a material without numbers does
constexpr float kAway = 1e-5f;   // radii; where rays leave a surface
constexpr float kBeforeLight = 1 - 1e-4f;  // share of the way to a light
constexpr int kMostPanes = 64;             // that a ray may pass

struct ClaySpot {
    Hit hit;
    Vec3 position;
    Frame frame;  // around the normal on the viewer's side
};

bool lets_pass(const LitShape& shape, const Hit& hit)
{
    const Material& material = shape.materials[shape.mesh.materials[hit.triangle]];
    return material.glass || material.may_pass();
}

ClaySpot spot_of(const LitShape& shape, const Ray& ray, const Hit& hit)
{
    const Vec3 normal = normalized(shape.mesh.area_vector(hit.triangle));
    const Vec3 facing = dot(normal, ray.direction) > 0 ? -normal : normal;
    return {hit, ray.origin + ray.direction * hit.distance, Frame(facing)};
}

// The first surface that lets no light pass, before the ray's end.
std::optional<ClaySpot> first_solid(const LitShape& shape, Ray ray)
{
    for (int k = 0; k < kMostPanes; ++k) {
        const std::optional<Hit> hit = shape.accelerator.closest(ray);
        if (!hit) return std::nullopt;
        if (!lets_pass(shape, *hit)) return spot_of(shape, ray, *hit);
        ray.origin = ray.origin + ray.direction * (hit->distance + kAway);
        ray.end -= hit->distance + kAway;
    }
    return std::nullopt;
}

Ray leaving(const ClaySpot& spot, const Vec3& direction)
{
    return {spot.position + spot.frame.normal * kAway, direction};
}

// The light that clay at the spot sends back of what comes straight from lights, but for the share of the sky's that
// rays from there find.
Rgb lit(const LitShape& shape, const LightSet& lights, const ClaySpot& spot, Sampler& sampler)
{
    const Vec2 choice = sampler.next_2d(), place = sampler.next_2d();
    Rgb sum;
    lights.sample(spot.position, {choice, place}, [&](const LightSample& light, float) {
        const float cosine = dot(light.direction, spot.frame.normal);
        if (!(light.pdf > 0) || !(cosine > 0)) return;
        Ray ray = leaving(spot, light.direction);
        ray.end = light.distance * kBeforeLight;
        const bool is_sky = !light.dirac && light.distance == std::numeric_limits<float>::infinity();
        const float weight = is_sky ? power_weight(light.pdf, cosine / kPi) : 1;
        if (!first_solid(shape, ray)) sum = sum + light.radiance * (kClay * cosine / kPi * weight / light.pdf);
    });
    return sum;
}

Rgb path_from(const LitShape& shape, const LightSet& lights, ClaySpot spot, Sampler& sampler)
{
    Rgb sum;
    float share = 1;
    for (int bounce = 0;; ++bounce) {
        sum = sum + lit(shape, lights, spot, sampler) * share;
        const Vec3 local = square_to_cosine_hemisphere(sampler.next_2d());
        const Vec3 way = normalized(spot.frame.to_world(local));
        const std::optional<ClaySpot> next = first_solid(shape, leaving(spot, way));
        share *= kClay;
        if (!next) {
            const SkyLight sky = lights.sky(way);
            return sum + sky.radiance * (share * power_weight(local.z / kPi, sky.pdf));
        }
        if (bounce == kClayBounces) return sum;
        spot = *next;
    }
}

float luminance_at(const LitShape& shape, const LightSet& lights, const ClaySpot& spot, uint32_t ray)
{
    const Material& material = shape.materials[shape.mesh.materials[spot.hit.triangle]];
    Rgb sum;
    Sampler sampler(kMeterSeed, 1, ray);
    for (uint32_t k = 0; k < kPathsAtSpot; ++k) {
        sampler.start(k);
        sum = sum + path_from(shape, lights, spot, sampler);
    }
    const Rgb emitted = material.emits() ? emission_at(shape.mesh, material, shape.textures, spot.hit.triangle,
                                                       {spot.hit.u, spot.hit.v})
                                         : Rgb{};
    return luminance(sum * (1.0f / kPathsAtSpot) + emitted);
}

// All lines through the sphere are equally likely.
Ray ray_from_around(Sampler& sampler)
{
    const Vec3 origin = square_to_sphere(sampler.next_2d());
    return {origin, normalized(Frame(-origin).to_world(square_to_cosine_hemisphere(sampler.next_2d())))};
}

}  // namespace

std::vector<float> meter(const LitShape& shape, const LightSet& lights, Metered what)
{
    std::vector<float> values;
    Sampler sampler(kMeterSeed, 0, 0);
    for (uint32_t k = 0; k < kMeterRays; ++k) {
        sampler.start(k);
        const std::optional<ClaySpot> spot = first_solid(shape, ray_from_around(sampler));
        if (!spot) continue;
        const bool shines = shape.materials[shape.mesh.materials[spot->hit.triangle]].emits();
        if (what == Metered::all || !shines)
            values.push_back(lights.empty() ? 0 : luminance_at(shape, lights, *spot, k));
    }
    std::sort(values.begin(), values.end());
    return values;
}

float middle_of_lit(const std::vector<float>& metered)
{
    constexpr float kDark = 1.0f / 8;
    float sum = 0;
    for (const float value : metered) sum += value;
    const auto lit = std::upper_bound(metered.begin(), metered.end(), kDark * sum / static_cast<float>(metered.size()));
    return lit == metered.end() ? 0 : lit[(metered.end() - lit) / 2];
}

namespace
{

// About the share of white that clay shows in the studio, after the tone curve.
constexpr float kMiddleTone = 0.44f;
constexpr int kStepsPerStop = 3;

class LightChooser
{
public:
    LightChooser(const StatedLight& stated, const LitShape& shape)
        : stated_(stated),
          shape_(shape),
          shines_(std::any_of(shape.materials.begin(), shape.materials.end(),
                              [](const Material& material) { return material.emits(); }))
    {
    }

    LightChoice choose()
    {
        choice_.environment = stated_.environment ? *stated_.environment : open_environment();
        const bool dark_sky = is_dark(choice_.environment);
        if (dark_sky && stated_.fixtures.empty() && !shines_)
            choice_.warnings.emplace_back(
                "the scene has no light, so it is black; give it a light, such as --sky studio");
        choice_.exposure = stated_.exposure.value_or(1);
        const bool in_any_unit = (choice_.environment.picture && choice_.environment.needs_exposure) ||
                                 !stated_.fixtures.empty() || (dark_sky && shines_);
        if (!stated_.exposure && in_any_unit) choose_exposure();
        return std::move(choice_);
    }

private:
    static bool is_dark(const Environment& environment) { return !(Sky(environment).power() > 0); }

    std::vector<float> metered(const Environment& environment, Metered what = Metered::all) const
    {
        return meter(shape_, LightSet(shape_.mesh, shape_.materials, shape_.textures, environment, stated_.fixtures, 1),
                     what);
    }

    // By the median of all that is seen: a display lights nothing but itself, a lamp most of what is around it. A
    // glowing floor is bright, but what stands on it may be nearly black, three stops below the middle tone, once the
    // exposure suits the floor.
    bool shines_enough() const
    {
        constexpr float kEnough = kMiddleTone / 16, kNearlyBlack = kMiddleTone / 8;
        const Environment black = constant_environment(0);
        const std::vector<float> own = metered(black), others = metered(black, Metered::lit_only);
        if (own.empty() || own[own.size() / 2] < kEnough) return false;
        const float exposure = stated_.exposure.value_or(
            std::exp2(static_cast<float>(steps_to_middle(middle_of_lit(own))) / kStepsPerStop));
        return others.empty() || exposure * middle_of_lit(others) >= kNearlyBlack;
    }

    Environment open_environment()
    {
        if (!stated_.fixtures.empty() || (shines_ && shines_enough())) {
            choice_.notes.emplace_back(
                stated_.fixtures.empty() ? "what shines in the scene lights it, without the studio; --sky studio adds "
                                           "that"
                                         : "its lamps light the scene, without the studio; --sky studio adds that");
            return constant_environment(0);
        }
        choice_.notes.emplace_back(shines_ ? "the studio lights the scene, too, because what shines in it lights less "
                                             "than half of it; --sky black leaves the studio out"
                                           : "the studio lights the scene, which has no light of its own; --sky "
                                             "chooses another");
        return studio_environment();
    }

    // In steps of a third of a stop, from 0.
    int steps_to_middle(float lit) const
    {
        constexpr int kMost = static_cast<int>(kMostStops) * kStepsPerStop;
        const auto shown = [&](int step) {
            return luminance(toned(stated_.tone, grey(lit * std::exp2(static_cast<float>(step) / kStepsPerStop))));
        };
        int step = -kMost;
        while (step < kMost && shown(step + 1) <= kMiddleTone) ++step;
        return step < kMost && shown(step + 1) - kMiddleTone < kMiddleTone - shown(step) ? step + 1 : step;
    }

    void choose_exposure()
    {
        const std::vector<float> values = metered(choice_.environment);
        const float lit = middle_of_lit(values);
        if (!(lit > 0)) {
            if (!values.empty())
                choice_.warnings.emplace_back(
                    "no lamp lights what is seen, so it is black; move the lamps, or add --sky studio");
            return;
        }
        const int steps = steps_to_middle(lit);
        if (std::abs(steps) <= kStepsPerStop) return;
        choice_.exposure = std::exp2(static_cast<float>(steps) / kStepsPerStop);
        char text[120];
        std::snprintf(text, sizeof text,
                      "the exposure is set to %+.2f stops, by the light on the scene; --exposure "
                      "sets another",
                      static_cast<double>(steps) / kStepsPerStop);
        choice_.notes.emplace_back(text);
    }

    const StatedLight& stated_;
    const LitShape& shape_;
    const bool shines_;
    LightChoice choice_;
};

}  // namespace

LightChoice choose_light(const StatedLight& stated, const LitShape& shape)
{
    return LightChooser(stated, shape).choose();
}

}  // namespace lumi::baker
