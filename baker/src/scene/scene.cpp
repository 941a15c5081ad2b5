// SPDX-License-Identifier: MIT
#include "lumi/baker/scene.h"

#include "geometry/bounding_sphere.h"
#include "scene/moving_parts.h"
#include "scene/scene_data.h"
#include "scene/scene_fingerprint.h"
#include "util/text_lines.h"
#include "volume/iso_surface.h"

namespace lumi::baker
{
namespace
{

// Samples of the lights that a point takes. In a medium, where a path has many points, a second one does not pay
// (docs/log/speed.md).
constexpr float kSamplesOnSurfaces = 2, kSamplesInMedium = 1;

Vec3 to_sphere_axes(const Vec3& v, UpAxis up)
{
    return up == UpAxis::y ? Vec3{v.z, v.x, v.y} : v;
}

// Points that the sphere has to hold besides triangles: the parts of a volume that are not empty, where moving parts
// come.
std::vector<Vec3> other_points(const SceneParts& parts, bool has_poses)
{
    std::vector<Vec3> points;
    if (parts.volume) points = corners_of(*parts.volume);
    if (has_poses && !parts.moving.empty()) points = parts.moving.swept(parts.mesh);
    return points;
}

// Only what triangles use: a stray vertex must not enlarge the sphere.
BoundingSphere fit_sphere(const SceneParts& parts, bool has_poses = true)
{
    const Mesh& mesh = parts.mesh;
    std::vector<bool> used(mesh.positions.size(), false);
    for (const Mesh::Corners& c : mesh.corners) used[c[0]] = used[c[1]] = used[c[2]] = !parts.mesh_is_shell;
    std::vector<Vec3> points = other_points(parts, has_poses);
    points.reserve(points.size() + mesh.positions.size());
    for (size_t i = 0; i < used.size(); ++i)
        if (used[i]) points.push_back(mesh.positions[i]);
    return smallest_sphere(points);
}

Vec3 moved_into_sphere(const Vec3& p, const BoundingSphere& sphere, UpAxis up)
{
    return to_sphere_axes({static_cast<float>((static_cast<double>(p.x) - sphere.centre[0]) / sphere.radius),
                           static_cast<float>((static_cast<double>(p.y) - sphere.centre[1]) / sphere.radius),
                           static_cast<float>((static_cast<double>(p.z) - sphere.centre[2]) / sphere.radius)},
                          up);
}

Mesh moved_into_sphere(Mesh mesh, const BoundingSphere& sphere, UpAxis up)
{
    for (Vec3& p : mesh.positions) p = moved_into_sphere(p, sphere, up);
    for (Vec3& n : mesh.normals) n = to_sphere_axes(n, up);
    return mesh;
}

// How far the scene reaches from the sphere's centre.
double reach_of(const SceneParts& parts, const BoundingSphere& sphere)
{
    const std::vector<Vec3> others = other_points(parts, true);
    double farthest = 0;
    const auto take = [&](const Vec3& p) {
        farthest = std::max(farthest, std::hypot(static_cast<double>(p.x) - sphere.centre[0],
                                                 static_cast<double>(p.y) - sphere.centre[1],
                                                 static_cast<double>(p.z) - sphere.centre[2]));
    };
    for (const Mesh::Corners& corners : parts.mesh.corners)
        for (const uint32_t c : corners) take(parts.mesh.positions[c]);
    std::for_each(others.begin(), others.end(), take);
    return farthest;
}

// The sphere that the scene asks for, which must hold every triangle, or the fitted one with its margin.
BoundingSphere sphere_of(const SceneParts& parts, double margin)
{
    if (!parts.sphere) {
        BoundingSphere sphere = fit_sphere(parts);
        sphere.radius *= 1 + margin;
        return sphere;
    }
    constexpr double kRounding = 1e-6;  // positions have it, also where a scene was moved into its sphere before
    const double farthest = reach_of(parts, *parts.sphere);
    if (farthest > parts.sphere->radius * (1 + kRounding)) {
        throw SceneError("the scene reaches " + std::to_string(farthest) +
                         " from the centre of its 'sphere' of radius " + std::to_string(parts.sphere->radius) +
                         "; give a larger radius, or leave out 'sphere'");
    }
    return *parts.sphere;
}

// Says by how much the poses of parts make the sphere larger, and all else smaller in pictures.
void note_growth(const BoundingSphere& sphere, double margin, SceneParts& parts)
{
    constexpr double kSeen = 1.02;
    if (parts.moving.empty() || parts.sphere) return;
    const double growth = sphere.radius / (fit_sphere(parts, false).radius * (1 + margin));
    if (growth >= kSeen)
        parts.notes.push_back("the sphere is " + number_text(std::round(100 * growth) / 100) +
                              " times as large as the scene, to hold every pose of its parts");
}

// From the frame of the unit sphere to scene units and axes: what moved_into_sphere undoes.
Affine out_of_sphere(const std::array<double, 3>& centre, double radius, UpAxis up)
{
    Affine m{};
    for (size_t r = 0; r < 3; ++r) {
        m[r][up == UpAxis::y ? (r + 1) % 3 : r] = radius;
        m[r][3] = centre[r];
    }
    return m;
}

std::optional<Medium> medium_of(std::optional<Volume> volume, const Affine& to_world, double radius)
{
    return volume ? std::optional<Medium>(std::in_place, std::move(*volume), to_world, radius) : std::nullopt;
}

std::vector<Material> scaled(std::vector<Material> materials, double radius)
{
    for (Material& m : materials) m.absorption = m.absorption * static_cast<float>(radius);
    return materials;
}

const std::vector<Material>& expose(std::vector<Material>& materials, float exposure)
{
    for (Material& m : materials) m.emission = m.emission * exposure;
    return materials;
}

std::optional<float> stated_exposure(const SceneParts& parts, const LoadOptions& options)
{
    if (options.exposure_stops) return static_cast<float>(std::exp2(*options.exposure_stops));
    // A shell must not be metered: what it stands for is not.
    return parts.exposure || !parts.mesh_is_shell ? parts.exposure : std::optional<float>(1.0f);
}

std::vector<Fixture> moved_into_sphere(const std::vector<Fixture>& fixtures, const std::array<double, 3>& centre,
                                       double radius, UpAxis up, float exposure)
{
    std::vector<Fixture> result;
    for (const Fixture& fixture : fixtures) {
        const Fixture moved = moved_into_sphere(fixture, centre, radius, exposure);
        result.push_back(up == UpAxis::y ? rotated(moved, [](const Vec3& v) { return to_sphere_axes(v, UpAxis::y); })
                                         : moved);
    }
    return result;
}

using Vec3d = std::array<double, 3>;

Vec3d unit(const Vec3d& v)
{
    const double size = std::hypot(v[0], v[1], v[2]);
    return {v[0] / size, v[1] / size, v[2] / size};
}

Vec3d cross_product(const Vec3d& a, const Vec3d& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Without its scale and shear.
NamedView moved_into_sphere(const SceneView& view, const Vec3d& centre, double radius, UpAxis up)
{
    const auto column = [&](size_t c) {
        Vec3d v{};
        for (size_t r = 0; r < 3; ++r) v[r] = view.to_scene[up == UpAxis::y ? (r + 2) % 3 : r][c];
        return v;
    };
    const Vec3d back = unit(column(2)), right = unit(cross_product(column(1), back)),
                above = cross_product(back, right);
    const Vec3d place = column(3);
    NamedView result{view.name, {}, view.fov_y * 180 / static_cast<double>(kPi)};
    for (size_t r = 0; r < 3; ++r) {
        const double middle = centre[up == UpAxis::y ? (r + 2) % 3 : r];
        const double row[] = {right[r], above[r], back[r], (place[r] - middle) / radius};
        std::copy(std::begin(row), std::end(row), &result.pose[4 * r]);
    }
    result.pose[15] = 1;
    return result;
}

std::vector<NamedView> moved_into_sphere(const std::vector<SceneView>& views, const Vec3d& centre, double radius,
                                         UpAxis up)
{
    std::vector<NamedView> result;
    for (const SceneView& view : views) {
        const NamedView moved = moved_into_sphere(view, centre, radius, up);
        const bool is_finite =
            std::all_of(moved.pose.begin(), moved.pose.end(), [](double v) { return std::isfinite(v); });
        if (is_finite) result.push_back(moved);
    }
    return result;
}

void add_shell(SceneParts& parts)
{
    parts.mesh = opacity_surface(*parts.volume);
    parts.mesh_is_shell = !parts.mesh.corners.empty();
    Material material;
    material.finish();
    parts.materials = {material};
}

constexpr float kFarthestAxis = 1.9f;  // radii: the format ends at 2, and a shadow's axis is shifted a little

// Parts that move, in the frame of the unit sphere.
MovingParts moved_into_sphere(MovingParts moving, const BoundingSphere& sphere, UpAxis up)
{
    for (PartMovement& motion : moving.motions) {
        motion.axis = to_sphere_axes(motion.axis, up);
        const Vec3 pivot = moved_into_sphere(motion.pivot, sphere, up);
        motion.pivot = pivot - motion.axis * dot(pivot, motion.axis);  // the axis comes nearest to the centre there
        if (!motion.slides && length(motion.pivot) > kFarthestAxis) {
            throw SceneError("the part '" + motion.name + "' turns about an axis that lies " +
                             number_text(static_cast<double>(length(motion.pivot))) +
                             " radii from the middle of the scene, at most " +
                             number_text(static_cast<double>(kFarthestAxis)) + "; give it a pivot nearer to it");
        }
        if (!motion.slides) continue;
        for (double* length : {&motion.from, &motion.to, &motion.value}) *length /= sphere.radius;
        if (motion.lit_at) *motion.lit_at /= sphere.radius;
    }
    return moving;
}

}  // namespace

Environment exposed(Environment environment, float exposure)
{
    environment.scale *= exposure;
    return environment;
}

SceneData::SceneData(SceneParts parts, const LoadOptions& options)
    : centre(),
      radius(),
      up(options.up.value_or(parts.up.value_or(UpAxis::y))),
      mesh([&] {
          const BoundingSphere sphere = sphere_of(parts, options.margin);
          for (size_t k = 0; k < 3; ++k) centre[k] = sphere.centre[k] + parts.origin[k];
          radius = sphere.radius;
          note_growth(sphere, options.margin, parts);
          moving = moved_into_sphere(std::move(parts.moving), sphere, up);
          return moved_into_sphere(std::move(parts.mesh), sphere, up);
      }()),
      materials(scaled(std::move(parts.materials), radius)),
      shared_textures(parts.shared_textures ? std::move(parts.shared_textures)
                                            : std::make_shared<std::vector<Texture>>(std::move(parts.textures))),
      textures(*shared_textures),
      tone(parts.tone),
      has_transparency(std::any_of(materials.begin(), materials.end(), [](const Material& m) { return m.may_pass(); })),
      mesh_is_shell(parts.mesh_is_shell),
      medium(medium_of(std::move(parts.volume), out_of_sphere(centre, radius, up), radius)),
      accelerator(mesh),
      choice(choose_light(
          {options.environment ? options.environment : parts.environment,
           moved_into_sphere(parts.fixtures, centre, radius, up, 1), stated_exposure(parts, options), tone},
          {mesh, materials, textures, accelerator})),
      fixtures(moved_into_sphere(parts.fixtures, centre, radius, up, choice.exposure)),
      lights(mesh, expose(materials, choice.exposure), textures, exposed(choice.environment, choice.exposure), fixtures,
             medium ? kSamplesInMedium : kSamplesOnSurfaces),
      states(std::move(parts.states)),
      views(moved_into_sphere(parts.views, centre, radius, up))
{
    choice.notes.insert(choice.notes.begin(), parts.notes.begin(), parts.notes.end());
}

Scene build_scene(SceneParts parts, const LoadOptions& options)
{
    if (options.solid_volume && parts.volume && parts.mesh.corners.empty()) add_shell(parts);
    if (parts.mesh.corners.empty() && !parts.volume)
        throw SceneError("the scene holds no triangles; export at least one face");
    auto rest = std::make_unique<SceneData>(std::move(parts), options);
    if (rest->moving.are_at_rest()) return Scene(std::move(rest));
    return Scene(with_mesh(*rest, rest->moving.posed(rest->mesh)));
}

std::vector<std::string> Scene::moving_parts() const
{
    std::vector<std::string> names;
    for (const PartMovement& motion : data_->moving.motions) names.push_back(motion.name);
    return names;
}

std::vector<std::string> Scene::light_states() const
{
    return data_->states.names;
}

Scene::Scene(std::unique_ptr<const SceneData> data) : data_(std::move(data)) {}
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;
Scene::~Scene() = default;

std::array<float, 3> Scene::centre() const
{
    return {static_cast<float>(data_->centre[0]), static_cast<float>(data_->centre[1]),
            static_cast<float>(data_->centre[2])};
}

float Scene::radius() const
{
    return static_cast<float>(data_->radius);
}

UpAxis Scene::up() const
{
    return data_->up;
}

size_t Scene::triangle_count() const
{
    return data_->mesh.triangle_count();
}

size_t Scene::light_count() const
{
    return data_->lights.count();
}

const std::vector<std::string>& Scene::notes() const
{
    return data_->choice.notes;
}

const std::vector<NamedView>& Scene::views() const
{
    return data_->views;
}

bool Scene::mesh_is_shell() const
{
    return data_->mesh_is_shell;
}

std::array<uint64_t, 2> Scene::fingerprint() const
{
    return scene_fingerprint(*data_);
}

}  // namespace lumi::baker
