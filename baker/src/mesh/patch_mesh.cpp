// SPDX-License-Identifier: MIT
#include "mesh/patch_mesh.h"

#include <cmath>

#include "geometry/smooth_groups.h"
#include "lumi/surface/format.h"
#include "material/texture_slot.h"
#include "mesh/edge_split.h"
#include "mesh/mesh_draft.h"
#include "mesh/mesh_fit.h"
#include "mesh/mesh_loss.h"
#include "mesh/mesh_tracer.h"
#include "mesh/patch_pairs.h"
#include "mesh/see_through.h"
#include "scene/moving_parts.h"
#include "store/bake_stages.h"

namespace lumi::baker
{
namespace
{

constexpr float kFewerTriangles = 0.8f;
constexpr float kLongerEdges = 1.1f;
constexpr float kNoLongerEdge = 2;    // radii, the sphere's diameter
constexpr uint32_t kViewedOneOf = 8;  // vertices of a matt scene: so many may have a view table, and so much may shine

// Work of the stages, in light paths that take as long: of a triangle of the scene, of one that is asked for, and of
// the pictures and rays that judge the result. Estimates: they decide how evenly progress moves.
constexpr double kLookWork = 6, kSimplifyWork = 3, kShapeWork = 60, kCheckWork = 2e5;
constexpr uint32_t kLookRuns = 2, kSimplifyRuns = 3, kShapeRuns = 9, kCheckRuns = 2;

struct MeshWork {
    double look, simplify, shape, check;
};

MeshWork work_of(const SceneData& scene, const MeshSettings& s)
{
    const auto triangles = static_cast<double>(scene.mesh.triangle_count());
    return {kLookWork * triangles, kSimplifyWork * triangles, kShapeWork * s.triangles, kCheckWork};
}

// Near the scene, in steps of the format. A draft that is the scene's own shape stays as it is: fitting is for what was
// simplified, and tears thin parts where outlines of the far and the near side lie in one pixel.
Mesh shaped(const SceneData& scene, const MeshDraft& draft, Faces faces, const MeshSettings& s, Job& job)
{
    const Mesh fit = draft.exact ? draft.mesh : fitted_in_rounds(scene, draft.mesh, faces, job, s.cap);
    const Mesh mesh = seen_part(MeshTracer(fit, faces), job, s.cap);
    return rounded(
        with_short_edges(mesh, s.longest_edge, [](const Vec3& middle, const Vec3&, float) { return middle; }));
}

// Settings that ask for a smaller mesh: fewer triangles, or longer edges where most triangles come from splitting.
MeshSettings smaller(MeshSettings s)
{
    if (s.longest_edge > kNoLongerEdge)
        throw BakeError(
            "no mesh of this scene is small enough for a surface field; remove from the model what nobody can see, or "
            "simplify it");
    if (s.triangles > detail::format::kMaxPatches / 2)
        s.triangles = static_cast<uint32_t>(kFewerTriangles * static_cast<float>(s.triangles));
    else
        s.longest_edge *= kLongerEdges;
    return s;
}

MeshLoss loss_of(const SceneData& scene, const MeshTracer& shape, const ViewCap& cap, Job& job)
{
    MeshLoss loss = loss_of(scene, shape, job, cap);
    const MissingPixels pixels = missing_pixels(scene, shape, job, cap);
    loss.holes = pixels.regions;
    loss.largest_hole = pixels.largest;
    return loss;
}

Mesh triangles_of(const PatchMesh& mesh, uint32_t begin, uint32_t end, std::vector<uint32_t>& numbers)
{
    Mesh result;
    result.positions = mesh.positions;
    for (uint32_t p = begin; p < end; ++p) {
        const PatchMesh::Patch& patch = mesh.patches[p];
        result.corners.push_back({patch.a, patch.b, patch.c});
        numbers.push_back(2 * p);
        if (patch.d != PatchMesh::kNone) {
            result.corners.push_back({patch.d, patch.c, patch.b});
            numbers.push_back(2 * p + 1);
        }
    }
    return result;
}

// Takes all of the job's work, less what `stages` have of it.
BuiltMesh opaque_mesh(const SceneData& scene, const MeshSettings& settings, BakeStages& stages, Job& job)
{
    const MeshWork work = work_of(scene, settings);
    const double later = work.simplify + work.shape + work.check;
    const Outside outside = [&] {
        const JobStage stage(job, Stage::mesh, job.part_of_rest(work.look / (work.look + later)), kLookRuns);
        return stages.once<Outside>(
            "outside", [&] { return outside_of(scene, job, settings.cap); }, settings.cap.lowest());
    }();
    BuiltMesh result;
    MeshSettings s = settings;
    s.triangles = std::min(s.triangles, 2 * detail::format::kMaxPatches);
    for (;; s = smaller(s)) {
        MeshDraft draft = [&] {
            const JobStage stage(job, Stage::mesh, job.part_of_rest(work.simplify / later), kSimplifyRuns);
            return stages.once<MeshDraft>(
                "draft", [&] { return drafted(outside, s, job); }, s.triangles, s.longest_edge, s.cap.lowest());
        }();
        if (!draft.fits) continue;
        const Mesh shape = [&] {
            const double share = work.shape / (work.shape + work.check);
            const JobStage stage(job, Stage::mesh, job.part_of_rest(share), kShapeRuns);
            return stages.once<Mesh>(
                "shape", [&] { return shaped(scene, draft, outside.faces(), s, job); }, s.triangles, s.longest_edge,
                s.cap.lowest());
        }();
        result.mesh = assembled(shape, settings.crease_cosine);
        if (fits(result.mesh)) {
            const JobStage stage(job, Stage::mesh, job.part_of_rest(1), kCheckRuns);
            result.loss = stages.once<MeshLoss>(
                "loss", [&] { return loss_of(scene, MeshTracer(shape, Faces::front), s.cap, job); }, s.triangles,
                s.longest_edge, s.cap.lowest());
            const size_t asked = std::min<size_t>(s.triangles, outside.mesh.triangle_count());
            result.warnings =
                mesh_warnings(result.loss, {asked, shape.triangle_count(), draft.exact}, scene.mesh_is_shell);
            return result;
        }
    }
}

}  // namespace

PatchMesh assembled(const Mesh& shape, float crease_cosine)
{
    Mesh mesh = with_creases(shape, crease_cosine);
    PatchMesh result;
    result.patches = paired(mesh);
    for (size_t k = 0; k < mesh.triangle_count(); ++k) {
        for (size_t i = 0; i < 3; ++i) {
            const float edge = length(mesh.position(k, i) - mesh.position(k, (i + 1) % 3));
            result.longest_edge = std::max(result.longest_edge, edge);
        }
    }
    result.positions = std::move(mesh.positions);
    result.normals = std::move(mesh.normals);
    return result;
}

uint32_t PatchMesh::owner_of(uint32_t patch) const
{
    const bool is_opaque = patch < opaque_patches();
    uint32_t owner = 0;
    for (uint32_t k = 0; k < parts.size(); ++k)
        if ((parts[k].follows == 0) == is_opaque && parts[k].first_patch <= patch) owner = k + 1;
    return owner;
}

Mesh triangles_of(const PatchMesh& mesh, uint32_t owner, std::vector<uint32_t>& numbers)
{
    return triangles_of(mesh, mesh.first_patch(owner), mesh.first_patch(owner + 1), numbers);
}

void append(PatchMesh& mesh, const PatchMesh& other)
{
    const auto from = static_cast<uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
    mesh.normals.insert(mesh.normals.end(), other.normals.begin(), other.normals.end());
    for (PatchMesh::Patch p : other.patches) {
        for (uint32_t* corner : {&p.a, &p.b, &p.c, &p.d})
            if (*corner != PatchMesh::kNone) *corner += from;
        mesh.patches.push_back(p);
    }
    mesh.longest_edge = std::max(mesh.longest_edge, other.longest_edge);
}

Mesh opaque_triangles(const PatchMesh& mesh, std::vector<uint32_t>& numbers)
{
    return triangles_of(mesh, 0, mesh.opaque_patches(), numbers);
}

Mesh see_through_triangles(const PatchMesh& mesh, std::vector<uint32_t>& numbers)
{
    return triangles_of(mesh, mesh.opaque_patches(), static_cast<uint32_t>(mesh.patches.size()), numbers);
}

std::vector<uint8_t> viewable_vertices(const PatchMesh& mesh)
{
    std::vector<uint8_t> viewable(mesh.positions.size(), 0);
    const size_t end = mesh.has_panes != 0 ? mesh.patches.size() : mesh.opaque_patches();
    for (size_t p = 0; p < end; ++p) {
        const PatchMesh::Patch& patch = mesh.patches[p];
        for (const uint32_t corner : {patch.a, patch.b, patch.c, patch.d})
            if (corner != PatchMesh::kNone) viewable[corner] = 1;
    }
    return viewable;
}

uint32_t most_viewed_vertices(const PatchMesh& mesh, uint32_t states)
{
    constexpr uint32_t kFew = 64;
    const std::vector<uint8_t> viewable = viewable_vertices(mesh);
    const auto all = static_cast<uint32_t>(std::count(viewable.begin(), viewable.end(), 1));
    return mesh.is_matt == 0 ? all : std::min(all, states * std::max(all / kViewedOneOf, kFew));
}

uint32_t triangle_count(const PatchMesh& mesh)
{
    uint32_t triangles = 0;
    for (const PatchMesh::Patch& patch : mesh.patches) triangles += patch.d == PatchMesh::kNone ? 1u : 2u;
    return triangles;
}

bool fits(const PatchMesh& mesh)
{
    return mesh.positions.size() <= detail::format::kMaxSurfaceVertices &&
           mesh.patches.size() <= detail::format::kMaxPatches;
}

namespace
{

// The opaque part of a scene in which nothing moves, then its see-through part.
BuiltMesh standing_mesh(const SceneData& scene, const MeshSettings& settings, BakeStages& stages, Job& job)
{
    constexpr uint32_t kSeeThroughParts = 4, kFewest = 64, kSides = 2;
    const std::unique_ptr<SceneData> opaque = opaque_part(scene);
    if (!opaque) return opaque_mesh(scene, settings, stages, job);
    MeshSettings mesh = settings;
    for (;; mesh.triangles = mesh.triangles / 4 * 3) {
        BuiltMesh built = opaque->mesh.corners.empty() ? BuiltMesh() : opaque_mesh(*opaque, mesh, stages, job);
        const uint32_t most = mesh.triangles + mesh.triangles / 2, opaque_ones = triangle_count(built.mesh);
        const uint32_t left = mesh.triangles - std::min(mesh.triangles, opaque_ones);
        const uint32_t few = std::max({kFewest, mesh.triangles / kSeeThroughParts, left / kSides});
        const uint32_t cards = std::max(few, most - std::min(most, opaque_ones));  // which have no view tables
        const size_t room =
            detail::format::kMaxPatches - std::min<size_t>(detail::format::kMaxPatches, built.mesh.patches.size());
        add_see_through(scene, *opaque, mesh, {few, cards, room}, built, job);
        if (fits(built.mesh)) return built;
        if (mesh.triangles < kFewest) throw BakeError("the scene's see-through parts are too many for a surface field");
    }
}

// Whether most of what turns looks along the axis, as a clock's hand does: a turn leaves such a face in the same light.
bool lies_across(const SceneData& scene, size_t owner, const Vec3& axis)
{
    float across = 0, all = 0;
    for (size_t t = 0; t < scene.mesh.triangle_count(); ++t) {
        if (scene.moving.owners[t] != owner) continue;
        const Vec3 area = scene.mesh.area_vector(t);
        const float size = length(area), along = dot(area, axis);
        across += size > 0 ? along * along / size : 0;
        all += size;
    }
    return across > 0.5f * all;
}

MovingPart part_of(const SceneData& scene, size_t number, uint32_t first_patch)
{
    constexpr double kTurn = 360;
    const PartMovement& motion = scene.moving.motions[number];
    MovingPart part = {motion.name, motion.slides, !motion.slides && lies_across(scene, number + 1, motion.axis),
                       motion.axis, motion.pivot};
    part.first_patch = first_patch;
    if (!motion.is_limited) return part;
    part.from = motion.slides ? motion.from : motion.from / kTurn;
    part.to = motion.slides ? motion.to : motion.to / kTurn;
    return part;
}

// Puts the patches of parts between the body's opaque and its see-through ones.
void insert(const std::vector<BuiltMesh>& parts, const SceneData& scene, BuiltMesh& built)
{
    PatchMesh& mesh = built.mesh;
    const auto opaque = static_cast<ptrdiff_t>(mesh.opaque_patches());
    const std::vector<PatchMesh::Patch> see_through(mesh.patches.begin() + opaque, mesh.patches.end());
    mesh.patches.resize(static_cast<size_t>(opaque));
    for (size_t k = 0; k < parts.size(); ++k) {
        mesh.parts.push_back(part_of(scene, k, static_cast<uint32_t>(mesh.patches.size())));
        append(mesh, parts[k].mesh);
        for (MeshWarning warning : parts[k].warnings) {
            warning.problem = "of the part '" + scene.moving.motions[k].name + "': " + warning.problem;
            built.warnings.push_back(warning);
        }
    }
    mesh.patches.insert(mesh.patches.end(), see_through.begin(), see_through.end());
}

// How many triangles each moving part gets: by the part that it has of all surface, but more of small ones, for they
// are looked at; no more than it has.
std::vector<uint32_t> triangles_by_part(const SceneData& scene, uint32_t triangles)
{
    constexpr double kPower = 2.0 / 3;
    constexpr size_t kFewest = 32;
    std::vector<double> areas(scene.moving.motions.size() + 1);
    std::vector<size_t> counts(areas.size());
    for (size_t t = 0; t < scene.mesh.triangle_count(); ++t) {
        areas[scene.moving.owners[t]] += static_cast<double>(scene.mesh.area(t));
        counts[scene.moving.owners[t]] += 1;
    }
    double sum = 0;
    for (double& area : areas) sum += area = std::pow(area, kPower);
    std::vector<uint32_t> result;
    for (size_t owner = 1; owner < areas.size(); ++owner) {
        const auto share = static_cast<size_t>(triangles * areas[owner] / sum);
        result.push_back(static_cast<uint32_t>(std::min(counts[owner], std::max(share, kFewest))));
    }
    return result;
}

// A part that moves is left out of the body's mesh and alone in its own: so all that any pose shows is there, and no
// patch and no vertex belongs to two.
BuiltMesh moving_mesh(const SceneData& scene, const MeshSettings& settings, BakeStages& stages, Job& job)
{
    constexpr uint32_t kFewest = 64;
    const ProgressCallback as_whole = [&](const Progress&) {
        job.finish();  // reports, and leaves where it is cancelled
        return true;
    };
    MeshSettings mesh = settings;
    for (;; mesh.triangles = mesh.triangles / 4 * 3) {
        const std::vector<uint32_t> counts = triangles_by_part(scene, mesh.triangles);
        std::vector<BuiltMesh> parts;
        MeshSettings body = mesh;
        for (uint32_t k = 0; k < counts.size(); ++k) {
            MeshSettings part = mesh;
            part.triangles = counts[k];
            const std::unique_ptr<SceneData> alone = only_of(scene, k + 1);
            Job quiet(mesh_work(*alone, part), job.threads(), as_whole);
            stages.begin_part(k + 1);
            parts.push_back(standing_mesh(*alone, part, stages, quiet));
            if (parts[k].mesh.see_through_patches != 0) {
                throw BakeError("the part '" + scene.moving.motions[k].name +
                                "' has a picture of soft opacity, and parts that move are opaque");
            }
            body.triangles -= std::min(body.triangles - kFewest, triangle_count(parts[k].mesh));
        }
        stages.begin_part(0);
        BuiltMesh built = standing_mesh(*only_of(scene, 0), body, stages, job);
        insert(parts, scene, built);
        if (fits(built.mesh)) return built;
        if (mesh.triangles < kFewest)
            throw BakeError("the scene and its moving parts are too much for a surface field");
    }
}

}  // namespace

bool is_matt(const SceneData& scene)
{
    constexpr Vec2 kMiddle = {1.0f / 3, 1.0f / 3};
    const Mesh& mesh = scene.mesh;
    double all = 0, shining = 0;
    for (uint32_t t = 0; t < mesh.materials.size(); ++t) {
        const Material& material = scene.materials[mesh.materials[t]];
        const Rgb body = material.base * slot_colour(mesh, scene.textures, material.maps.base, t, kMiddle);
        all += mesh.area(t);
        shining += material.is_matt(body) ? 0 : mesh.area(t);
    }
    return shining <= all / kViewedOneOf;
}

BuiltMesh build_mesh(const SceneData& scene, const MeshSettings& settings, BakeStages& stages, Job& job)
{
    BuiltMesh built =
        scene.moving.empty() ? standing_mesh(scene, settings, stages, job) : moving_mesh(scene, settings, stages, job);
    built.mesh.is_matt = is_matt(scene) ? 1 : 0;
    return built;
}

uint64_t mesh_work(const SceneData& scene, const MeshSettings& settings)
{
    const MeshWork work = work_of(scene, settings);
    return static_cast<uint64_t>(work.look + work.simplify + work.shape + work.check);
}

}  // namespace lumi::baker
