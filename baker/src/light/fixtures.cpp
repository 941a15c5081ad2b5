// SPDX-License-Identifier: MIT
#include "light/fixtures.h"

#include "math/vec3.h"
#include "math/warp.h"

namespace lumi::baker
{
namespace
{

constexpr float kFar = std::numeric_limits<float>::infinity();

Vec3 moved(const Vec3& p, const std::array<double, 3>& c, double radius)
{
    return {static_cast<float>((static_cast<double>(p.x) - c[0]) / radius),
            static_cast<float>((static_cast<double>(p.y) - c[1]) / radius),
            static_cast<float>((static_cast<double>(p.z) - c[2]) / radius)};
}

// The solid angle under which a point sees the unit sphere.
float solid_angle_of_scene(const Vec3& position)
{
    const float d2 = dot(position, position);
    return d2 <= 1 ? 4 * kPi : 2 * kPi * (1 - std::sqrt(1 - 1 / d2));
}

float share_of_spot(const SpotLight& s, float cosine)
{
    const float t = std::clamp((cosine - s.cos_outer) / (s.cos_inner - s.cos_outer), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

// Solid angle of the cone that a sphere fills, as seen from outside; exact for far and small ones too.
float cone_solid_angle(float sine2)
{
    return 2 * kPi * sine2 / (1 + std::sqrt(1 - sine2));
}

float power_of(const PointLight& l)
{
    return max_component(l.intensity) * solid_angle_of_scene(l.position);
}
float power_of(const SpotLight& l)
{
    const float cone = 2 * kPi * (1 - l.cos_outer);
    return max_component(l.intensity) * std::min(cone, solid_angle_of_scene(l.position));
}
float power_of(const DirectionalLight& l)
{
    return max_component(l.irradiance) * kPi;
}
float power_of(const RectangleLight& l)
{
    const Vec3 centre = l.corner + (l.side_u + l.side_v) * 0.5f;
    const float intensity = max_component(l.radiance) * length(cross(l.side_u, l.side_v));
    return intensity * std::min(kPi, solid_angle_of_scene(centre));
}
float power_of(const SphereLight& l)
{
    return max_component(l.radiance) * kPi * l.radius * l.radius * solid_angle_of_scene(l.centre);
}

LightSample dirac(const Vec3& direction, float distance, const Rgb& irradiance)
{
    LightSample s{direction, distance, irradiance, 1};
    s.dirac = true;
    return s;
}

LightSample sample_of(const PointLight& l, const Vec3& from, const Vec2&)
{
    const Vec3 towards = l.position - from;
    const float d2 = dot(towards, towards);
    return d2 > 0 ? dirac(normalized(towards), std::sqrt(d2), l.intensity * (1 / d2)) : LightSample{};
}

LightSample sample_of(const SpotLight& l, const Vec3& from, const Vec2& u)
{
    LightSample s = sample_of(PointLight{l.position, l.intensity}, from, u);
    s.radiance = s.radiance * share_of_spot(l, -dot(s.direction, l.axis));
    return s;
}

LightSample sample_of(const DirectionalLight& l, const Vec3&, const Vec2&)
{
    return dirac(l.towards, kFar, l.irradiance);
}

float rectangle_pdf(const Vec3& area, const Vec3& direction, float distance)
{
    const float facing = -dot(area, direction);
    return facing > 0 ? distance * distance / facing : 0.0f;
}

LightSample sample_of(const RectangleLight& l, const Vec3& from, const Vec2& u)
{
    const Vec3 towards = l.corner + l.side_u * u.x + l.side_v * u.y - from;
    const float distance = length(towards);
    if (!(distance > 0)) return {};
    const Vec3 direction = towards / distance;
    return {direction, distance, l.radiance, rectangle_pdf(cross(l.side_u, l.side_v), direction, distance)};
}

// Distance along the ray to the sphere's surface, or a negative number.
float sphere_distance(const SphereLight& l, const Vec3& from, const Vec3& direction)
{
    const Vec3 to_centre = l.centre - from;
    const float along = dot(to_centre, direction);
    const Vec3 across = to_centre - direction * along;
    const float half2 = l.radius * l.radius - dot(across, across);
    if (half2 < 0) return -1;
    const float half = std::sqrt(half2);
    return along > half ? along - half : along + half;
}

float sphere_pdf(const SphereLight& l, const Vec3& from)
{
    const Vec3 to_centre = l.centre - from;
    const float sine2 = l.radius * l.radius / dot(to_centre, to_centre);
    return sine2 < 1 ? 1 / cone_solid_angle(sine2) : 1 / (4 * kPi);
}

LightSample sample_of(const SphereLight& l, const Vec3& from, const Vec2& u)
{
    const Vec3 to_centre = l.centre - from;
    const float sine2 = l.radius * l.radius / dot(to_centre, to_centre);
    Vec3 direction;
    if (sine2 < 1) {
        // Uniform in the cone: the height falls by u.x of 1 - cos.
        const float fall = u.x * sine2 / (1 + std::sqrt(1 - sine2));
        const float across = std::sqrt(std::max(0.0f, fall * (2 - fall)));
        const SineCosine s = sine_cosine_of_turns(u.y);
        const Vec3 local = {across * s.cosine, across * s.sine, 1 - fall};
        direction = normalized(Frame(normalized(to_centre)).to_world(local));
    } else {
        direction = square_to_sphere(u);
    }
    const float distance = sphere_distance(l, from, direction);
    // A sample on the rim may miss by rounding: it then ends beside the centre.
    return {direction, distance > 0 ? distance : length(to_centre), l.radiance, sphere_pdf(l, from)};
}

std::optional<LightSample> seen_of(const RectangleLight& l, const Ray& ray)
{
    const Vec3 area = cross(l.side_u, l.side_v);
    const float facing = -dot(area, ray.direction);
    const float distance = dot(ray.origin - l.corner, area) / facing;
    if (!(facing > 0) || !(distance > 0) || distance >= ray.end) return std::nullopt;
    const Vec3 place = ray.origin + ray.direction * distance - l.corner;
    const float u = dot(place, l.side_u) / dot(l.side_u, l.side_u);
    const float v = dot(place, l.side_v) / dot(l.side_v, l.side_v);
    if (u < 0 || u >= 1 || v < 0 || v >= 1) return std::nullopt;
    return LightSample{ray.direction, distance, l.radiance, rectangle_pdf(area, ray.direction, distance)};
}

std::optional<LightSample> seen_of(const SphereLight& l, const Ray& ray)
{
    const float distance = sphere_distance(l, ray.origin, ray.direction);
    if (!(distance > 0) || distance >= ray.end) return std::nullopt;
    return LightSample{ray.direction, distance, l.radiance, sphere_pdf(l, ray.origin)};
}

// Lights without a size are never met.
template <class Sizeless>
std::optional<LightSample> seen_of(const Sizeless&, const Ray&)
{
    return std::nullopt;
}

bool has_size(const Fixture& f)
{
    return std::holds_alternative<RectangleLight>(f) || std::holds_alternative<SphereLight>(f);
}

}  // namespace

Fixture moved_into_sphere(const Fixture& fixture, const std::array<double, 3>& centre, double radius, float exposure)
{
    const float shrink = static_cast<float>(1 / radius);
    struct Mover {
        const std::array<double, 3>& centre;
        double radius;
        float shrink, exposure;

        Fixture operator()(PointLight l) const
        {
            return PointLight{moved(l.position, centre, radius), l.intensity * (exposure * shrink * shrink)};
        }
        Fixture operator()(SpotLight l) const
        {
            l.position = moved(l.position, centre, radius);
            l.intensity = l.intensity * (exposure * shrink * shrink);
            return l;
        }
        Fixture operator()(DirectionalLight l) const { return DirectionalLight{l.towards, l.irradiance * exposure}; }
        Fixture operator()(RectangleLight l) const
        {
            return RectangleLight{moved(l.corner, centre, radius), l.side_u * shrink, l.side_v * shrink,
                                  l.radiance * exposure};
        }
        Fixture operator()(SphereLight l) const
        {
            return SphereLight{moved(l.centre, centre, radius), l.radius * shrink, l.radiance * exposure};
        }
    };
    return std::visit(Mover{centre, radius, shrink, exposure}, fixture);
}

Fixture rotated(const Fixture& fixture, Vec3 (*rotate)(const Vec3&))
{
    struct Rotator {
        Vec3 (*turn)(const Vec3&);

        Fixture operator()(PointLight l) const { return PointLight{turn(l.position), l.intensity}; }
        Fixture operator()(SpotLight l) const
        {
            l.position = turn(l.position);
            l.axis = turn(l.axis);
            return l;
        }
        Fixture operator()(DirectionalLight l) const { return DirectionalLight{turn(l.towards), l.irradiance}; }
        Fixture operator()(RectangleLight l) const
        {
            return RectangleLight{turn(l.corner), turn(l.side_u), turn(l.side_v), l.radiance};
        }
        Fixture operator()(SphereLight l) const { return SphereLight{turn(l.centre), l.radius, l.radiance}; }
    };
    return std::visit(Rotator{rotate}, fixture);
}

Fixtures::Fixtures(std::vector<Fixture> fixtures) : fixtures_(std::move(fixtures))
{
    std::vector<double> powers;
    for (size_t k = 0; k < fixtures_.size(); ++k) {
        powers.push_back(static_cast<double>(std::visit([](const auto& l) { return power_of(l); }, fixtures_[k])));
        if (has_size(fixtures_[k]) && powers.back() > 0) sized_.push_back(k);
    }
    choice_ = Distribution(powers);
}

std::vector<Vec3> Fixtures::positions() const
{
    std::vector<Vec3> result;
    for (const Fixture& fixture : fixtures_) {
        if (const auto* point = std::get_if<PointLight>(&fixture)) result.push_back(point->position);
        if (const auto* spot = std::get_if<SpotLight>(&fixture)) result.push_back(spot->position);
        if (const auto* sphere = std::get_if<SphereLight>(&fixture)) result.push_back(sphere->centre);
        if (const auto* panel = std::get_if<RectangleLight>(&fixture))
            result.push_back(panel->corner + (panel->side_u + panel->side_v) * 0.5f);
    }
    return result;
}

LightSample Fixtures::sample(const Vec3& from, float u_select, const Vec2& u) const
{
    const size_t k = choice_.draw(u_select).index;
    LightSample s = std::visit([&](const auto& l) { return sample_of(l, from, u); }, fixtures_[k]);
    s.pdf *= choice_.probability(k);
    return s;
}

std::optional<LightSample> Fixtures::found(const Fixture& fixture, const Ray& ray)
{
    return std::visit([&](const auto& l) { return seen_of(l, ray); }, fixture);
}

void Fixtures::add_to(Digest& digest) const
{
    for (const Fixture& fixture : fixtures_) {
        digest.add(fixture.index());
        std::visit([&](const auto& light) { digest.add(light); }, fixture);
    }
}

}  // namespace lumi::baker
