// SPDX-License-Identifier: MIT
// The extra lights of a scene file. Like the environment they light the scene, are seen in reflections where they have
// a size, and are never seen by the rays of the field; they cast no shadows.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "geometry/accelerator.h"
#include "light/light.h"
#include "math/distribution.h"
#include "util/digest.h"

namespace lumi::baker
{

struct PointLight {
    Vec3 position;
    Rgb intensity;  // radiance × length²
};

struct SpotLight {
    Vec3 position, axis;         // axis: unit, the way the light goes
    float cos_inner, cos_outer;  // full light inside the one, none outside the other; inner > outer
    Rgb intensity;               // on the axis
};

struct DirectionalLight {
    Vec3 towards;    // unit, from the scene to the light
    Rgb irradiance;  // on a face that looks at it
};

// Shines to the side of cross(side_u, side_v).
struct RectangleLight {
    Vec3 corner, side_u, side_v;  // sides are perpendicular
    Rgb radiance;
};

struct SphereLight {
    Vec3 centre;
    float radius;
    Rgb radiance;
};

using Fixture = std::variant<PointLight, SpotLight, DirectionalLight, RectangleLight, SphereLight>;

// The light in the frame of the unit sphere: lengths divide by `radius`, points move by -centre first, all radiance is
// multiplied by `exposure`. Axes stay.
Fixture moved_into_sphere(const Fixture& fixture, const std::array<double, 3>& centre, double radius, float exposure);
// Its directions and points after a rotation of the axes.
Fixture rotated(const Fixture& fixture, Vec3 (*rotate)(const Vec3&));

class Fixtures
{
public:
    explicit Fixtures(std::vector<Fixture> fixtures);

    size_t count() const { return fixtures_.size(); }
    // Directional lights have none.
    std::vector<Vec3> positions() const;
    // About the flux into the unit sphere, the same measure as of other lights.
    float power() const { return static_cast<float>(choice_.total()); }
    LightSample sample(const Vec3& from, float u_select, const Vec2& u) const;
    void add_to(Digest& digest) const;  // all that decides their light

    // Calls seen(radiance, pdf) for each light that lies along the ray before its end.
    template <class Seen>
    void for_each_seen(const Ray& ray, const Seen& seen) const
    {
        for (const size_t k : sized_)
            if (const std::optional<LightSample> s = found(fixtures_[k], ray))
                seen(s->radiance, s->pdf * choice_.probability(k));
    }

private:
    static std::optional<LightSample> found(const Fixture& fixture, const Ray& ray);

    std::vector<Fixture> fixtures_;
    std::vector<size_t> sized_;  // the fixtures that a ray can meet
    Distribution choice_;
};

}  // namespace lumi::baker
