// SPDX-License-Identifier: MIT
#include "mesh/see_through.h"

#include <algorithm>
#include <cmath>

#include "geometry/drawing_order.h"
#include "math/sampler.h"
#include "math/vec3.h"
#include "math/warp.h"
#include "mesh/copies.h"
#include "mesh/cut_outs.h"
#include "mesh/edge_split.h"
#include "mesh/mesh_loss.h"
#include "mesh/outside.h"
#include "mesh/sheets.h"
#include "mesh/simplify/simplify.h"
#include "mesh/survey.h"

namespace lumi::baker
{
namespace
{

constexpr float kInvisible = 1.0f / 255;  // an opacity that no display shows
constexpr float kSoftShare = 0.25f;       // the share of a picture between transparent and opaque that makes it soft
constexpr float kFeather = 2.5f;          // pixels across an edge: more than antialiasing makes
constexpr uint8_t kSoftLow = 26, kSoftHigh = 229;
constexpr float kLongestCut = 16;    // radii; a mesh cannot follow a longer line, with a triangle for each few pixels
constexpr uint32_t kOpenRays = 256;  // a side that none of so many reaches past opaque triangles is hidden
constexpr float kAboveSide = 1e-4f;  // radii, as in outside.cpp
constexpr uint32_t kMeetingRays = 4096;  // an origin
constexpr float kSamePlace = 1e-3f;      // radii
constexpr uint64_t kSidesSeed = 0x73696465, kMeetingSeed = 0x6D656574;

// `feathers`: also where it is soft along its edges only, wider than a filter makes them.
bool is_soft(const Texture& picture, bool feathers)
{
    size_t between = 0, crossings = 0;
    const size_t pixels = picture.rgb.size() / 3, width = static_cast<size_t>(picture.width);
    const auto is_open = [&](size_t k) { return picture.rgb[3 * k + 1] < 128; };
    for (size_t k = 0; k < pixels; ++k) {
        const uint8_t v = picture.rgb[3 * k + 1];
        between += v > kSoftLow && v < kSoftHigh ? 1u : 0u;
        crossings += (k + 1) % width != 0 && is_open(k) != is_open(k + 1) ? 1u : 0u;
        crossings += k + width < pixels && is_open(k) != is_open(k + width) ? 1u : 0u;
    }
    return static_cast<float>(between) > kSoftShare * static_cast<float>(pixels) ||
           (feathers && static_cast<float>(between) > kFeather * static_cast<float>(crossings));
}

// `cut`: how long the lines are along which the material's picture would cut.
bool is_see_through(const SceneData& scene, const Material& m, float cut)
{
    if (m.glass || !m.may_pass()) return false;
    const TextureSlot& picture = m.maps.opacity;
    return m.thin || m.opacity < 1 - kInvisible || cut > kLongestCut ||
           (picture.used() && is_soft(scene.textures[static_cast<size_t>(picture.texture)], m.blends));
}

bool is_invisible(const Material& m)
{
    return m.opacity < kInvisible && !m.emits();
}

// A path meets one of the triangles at one place and goes on behind all of them.
Mesh without_copies(Mesh mesh)
{
    const std::vector<uint32_t> first = first_copies(mesh);
    std::vector<Mesh::Corners> kept;
    for (uint32_t k = 0; k < first.size(); ++k)
        if (first[k] == k) kept.push_back(mesh.corners[k]);
    mesh.corners = std::move(kept);
    return mesh;
}

// Whether light gets from a side of a triangle past all that is opaque.
bool is_open(const Mesh& mesh, uint32_t triangle, float side, const SceneData& opaque, const ViewCap& cap)
{
    const Vec3 area = mesh.area_vector(triangle) * side;
    if (!(length(area) > 0)) return false;
    const Frame frame(normalized(area));
    Sampler sampler(kSidesSeed, triangle, 0);
    for (uint32_t k = 0; k < kOpenRays; ++k) {
        sampler.start(k);
        const Vec2 w = square_to_triangle(sampler.next_2d());
        const Vec3& a = mesh.position(triangle, 0);
        const Vec3 place = a + (mesh.position(triangle, 1) - a) * w.x + (mesh.position(triangle, 2) - a) * w.y;
        const Vec2 square = sampler.next_2d();
        const Vec3 outwards = frame.to_world(direction_at(square.x, square.y));
        const Vec3 start = place + frame.normal * kAboveSide;
        const bool is_seen = cap.sees({start, -outwards});
        if (is_seen && (opaque.mesh.corners.empty() || !opaque.accelerator.blocked({start, outwards}))) return true;
    }
    return false;
}

Mesh open_sides(const Mesh& mesh, const SceneData& opaque, const ViewCap& cap, Job& job)
{
    struct Open {
        bool front = false, back = false;
    };
    constexpr uint32_t kSidesATask = 64;
    const auto triangles = static_cast<uint32_t>(mesh.triangle_count());
    std::vector<Open> open(triangles);
    job.run((triangles + kSidesATask - 1) / kSidesATask, [&](uint32_t task) {
        const uint32_t end = std::min(triangles, (task + 1) * kSidesATask);
        for (uint32_t k = task * kSidesATask; k < end && !job.stopping(); ++k)
            open[k] = {is_open(mesh, k, 1, opaque, cap), is_open(mesh, k, -1, opaque, cap)};
    });
    Mesh result;
    result.positions = mesh.positions;
    for (uint32_t k = 0; k < triangles; ++k) {
        const Mesh::Corners& c = mesh.corners[k];
        if (open[k].front) result.corners.push_back(c);
        if (open[k].back) result.corners.push_back({c[0], c[2], c[1]});
    }
    return result;
}

// By triangle of `mesh`, which are see-through ones of the scene: how many light paths meet the scene there first.
std::vector<uint32_t> meetings(const SceneData& scene, const Mesh& mesh, const ViewCap& cap, Job& job)
{
    const MeshTracer tracer(mesh, Faces::both);
    const Survey survey(scene, kSurveyOrigins, kMeetingRays, kMeetingSeed, cap);
    std::vector<std::vector<uint32_t>> met(survey.origins());
    job.run(survey.origins(), [&](uint32_t i) {
        for (const SurveyRay& r : survey.look(i, tracer)) {
            const auto hit = std::isfinite(r.scene) ? tracer.near(r.ray, r.scene, kSamePlace) : std::nullopt;
            if (hit) met[i].push_back(hit->triangle);
        }
    });
    std::vector<uint32_t> counts(mesh.triangle_count(), 0);
    for (const std::vector<uint32_t>& some : met)
        for (const uint32_t triangle : some) ++counts[triangle];
    return counts;
}

// A sheet of the mesh: its triangles, and the light paths that meet it first.
struct Card {
    uint32_t number = 0, triangles = 0, met = 0;
    float worth() const { return static_cast<float>(met) / static_cast<float>(triangles); }
};

// By sheet; those that are no number of a sheet have no triangles.
std::vector<Card> cards_of(const Sheets& sheets, const std::vector<uint32_t>& met)
{
    std::vector<Card> cards(met.size());
    for (uint32_t k = 0; k < met.size(); ++k) {
        Card& card = cards[sheets.of(k).sheet];
        card = {sheets.of(k).sheet, card.triangles + 1, card.met + met[k]};
    }
    return cards;
}

// Whether each sheet is small beside so many triangles.
bool is_cloud(const Mesh& mesh, const Sheets& sheets, uint32_t triangles)
{
    constexpr uint32_t kFewestCards = 8;
    std::vector<uint32_t> sizes(mesh.triangle_count(), 0);
    for (uint32_t k = 0; k < sizes.size(); ++k) ++sizes[sheets.of(k).sheet];
    return *std::max_element(sizes.begin(), sizes.end()) <= triangles / kFewestCards;
}

// Those that are seen most for their triangles.
Mesh most_seen(const Mesh& mesh, const Sheets& sheets, std::vector<Card> cards, uint32_t triangles)
{
    cards.erase(std::remove_if(
                    cards.begin(), cards.end(), [](const Card& c) { return c.met == 0; }),
                cards.end());
    std::stable_sort(cards.begin(), cards.end(), [](const Card& a, const Card& b) { return a.worth() > b.worth(); });
    std::vector<bool> kept(mesh.triangle_count(), false);
    for (uint32_t left = triangles, k = 0; k < cards.size() && cards[k].triangles <= left; ++k) {
        left -= cards[k].triangles;
        kept[cards[k].number] = true;
    }
    Mesh result;
    result.positions = mesh.positions;
    for (uint32_t k = 0; k < mesh.triangle_count(); ++k)
        if (kept[sheets.of(k).sheet]) result.corners.push_back(mesh.corners[k]);
    return result;
}

// Cards of a cloud, such as leaves, cannot be simplified: whole ones are left out.
Mesh few_of(const SceneData& scene, const Mesh& mesh, const SeeThroughCount& most, const ViewCap& cap,
            std::vector<MeshWarning>& warnings, Job& job)
{
    if (mesh.triangle_count() <= most.triangles) return mesh;
    const Sheets sheets(mesh);
    if (!is_cloud(mesh, sheets, most.cards)) return simplified(mesh, most.triangles);
    if (mesh.triangle_count() <= most.cards) return mesh;
    Mesh few = most_seen(mesh, sheets, cards_of(sheets, meetings(scene, mesh, cap, job)), most.cards);
    warnings.push_back({"of " + std::to_string(mesh.triangle_count()) + " see-through triangles, such as leaves, the " +
                            std::to_string(few.triangle_count()) + " that are seen most are drawn",
                        "", true});
    return few;
}

// If that is better than to sort by depth.
void put_in_drawing_order(PatchMesh& mesh, Job& job)
{
    std::vector<uint32_t> patch_of;
    const Mesh triangles = opaque_triangles(mesh, patch_of);
    for (uint32_t& number : patch_of) number /= 2;
    const OneSidedFaces faces = {triangles, patch_of};
    const std::vector<uint32_t> order = drawing_order(faces, job);
    const OrderFaults faults = order_faults(faces, order, job);
    mesh.is_in_drawing_order = faults.in_order <= faults.by_depth ? 1 : 0;
    if (mesh.is_in_drawing_order == 0) return;
    const std::vector<PatchMesh::Patch> patches = mesh.patches;
    for (size_t k = 0; k < order.size(); ++k) mesh.patches[k] = patches[order[k]];
}

// Splits edges that are longer than `longest`, or than more where there would be more than `most` patches.
PatchMesh split_mesh(const Mesh& few, float longest, float crease_cosine, size_t most, const PlaceMiddle& middle,
                     const SceneData& opaque, const ViewCap& cap, Job& job)
{
    constexpr float kLeastStep = 1.2f, kDiameter = 2;
    for (;;) {
        const Mesh split = with_short_edges(few, longest, middle);
        PatchMesh mesh = assembled(rounded(open_sides(split, opaque, cap, job)), crease_cosine);
        const bool is_whole = split.triangle_count() == few.triangle_count();
        if (mesh.patches.size() <= most || is_whole || longest > kDiameter) return mesh;
        const float excess = static_cast<float>(mesh.patches.size()) / static_cast<float>(most);
        longest *= std::max(kLeastStep, 0.9f * std::sqrt(excess));  // patches are about as many as 1 / longest²
    }
}

PatchMesh see_through_mesh(const SceneData& scene, const SceneData& opaque, const MeshSettings& settings,
                           const SeeThroughCount& most, std::vector<MeshWarning>& warnings, Job& job)
{
    const std::vector<bool> see_through = see_through_materials(scene);
    const Mesh all = without_copies(welded(part_of(scene.mesh, [&](size_t t) {
        const uint32_t material = scene.mesh.materials[t];
        return see_through[material] && !is_invisible(scene.materials[material]);
    })));
    const MeshTracer fronts(all, Faces::front);
    const Mesh few = few_of(scene, all, most, settings.cap, warnings, job);
    constexpr float kNoCrease = -2;  // both sides of a sheet share vertices where those have no view tables
    const bool has_panes = std::any_of(scene.mesh.materials.begin(), scene.mesh.materials.end(), [&](uint32_t m) {
        return see_through[m] && scene.materials[m].thin && scene.materials[m].specular;
    });
    PatchMesh mesh = split_mesh(few, settings.longest_edge, has_panes ? settings.crease_cosine : kNoCrease,
                                most.patches, onto(fronts), opaque, settings.cap, job);
    mesh.has_panes = has_panes ? 1 : 0;
    if (fits(mesh)) put_in_drawing_order(mesh, job);
    return mesh;
}

// Makes the loss of opaque parts, of which alone the mesh was judged, that of both parts.
void judge(const SceneData& scene, const PatchMesh& mesh, const ViewCap& cap, Job& job, MeshLoss& loss)
{
    std::vector<uint32_t> numbers;
    const MeshTracer opaque(opaque_triangles(mesh, numbers), Faces::front);
    const MeshTracer see_through(see_through_triangles(mesh, numbers), Faces::front);
    const MeshLoss all = loss_of(scene, opaque, job, cap, &see_through);
    loss.missed_see_through = std::max(0.0, all.missed - loss.missed);
    loss.missed = all.missed;
    loss.displaced = all.displaced;
}

}  // namespace

std::vector<bool> see_through_materials(const SceneData& scene)
{
    const std::vector<float> cuts = cut_lengths(scene);
    std::vector<bool> result;
    for (size_t k = 0; k < scene.materials.size(); ++k)
        result.push_back(!scene.medium && is_see_through(scene, scene.materials[k], cuts[k]));
    return result;
}

std::unique_ptr<SceneData> opaque_part(const SceneData& scene)
{
    const std::vector<bool> see_through = see_through_materials(scene);
    const auto is_seen_through = [&](uint32_t material) { return see_through[material]; };
    if (!std::any_of(scene.mesh.materials.begin(), scene.mesh.materials.end(), is_seen_through)) return nullptr;
    SceneParts parts;
    parts.mesh = part_of(scene.mesh, [&](size_t t) { return !see_through[scene.mesh.materials[t]]; });
    parts.materials = scene.materials;
    parts.shared_textures = scene.shared_textures;
    parts.tone = scene.tone;
    parts.sphere = BoundingSphere{{0, 0, 0}, 1};
    LoadOptions options;
    options.up = UpAxis::z;
    options.environment = constant_environment(0);
    options.exposure_stops = 0;  // or it would be metered
    return std::make_unique<SceneData>(std::move(parts), options);
}

void add_see_through(const SceneData& scene, const SceneData& opaque, const MeshSettings& settings,
                     const SeeThroughCount& most, BuiltMesh& built, Job& job)
{
    const PatchMesh part = see_through_mesh(scene, opaque, settings, most, built.warnings, job);
    append(built.mesh, part);
    built.mesh.see_through_patches = static_cast<uint32_t>(part.patches.size());
    built.mesh.has_panes = part.has_panes;
    built.mesh.is_in_drawing_order = part.is_in_drawing_order;
    if (fits(built.mesh)) judge(scene, built.mesh, settings.cap, job, built.loss);
}

}  // namespace lumi::baker
