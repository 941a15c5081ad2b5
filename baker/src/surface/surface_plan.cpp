// SPDX-License-Identifier: MIT
// From limits to the settings of a surface field and its mesh. Triangles come first, texels get the bytes that are
// left.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "fit/fit_shape.h"
#include "fit/gloss/gloss_fit.h"
#include "lumi/baker/surface.h"
#include "lumi/surface/format.h"
#include "mesh/patch_mesh.h"
#include "pack/shadow_patches.h"
#include "pack/view_quantiser.h"
#include "store/bake_stages.h"
#include "store/checkpoint.h"
#include "store/section_writer.h"
#include "trace/path_tracer.h"

namespace lumi::baker
{
namespace
{

// Bytes of the budget; with split edges and view tables the mesh takes about 35. A matt one hardly has either: it takes
// 14 to 18.
constexpr double kBytesATriangle = 90, kBytesAMattTriangle = 60;
constexpr uint32_t kFewestTriangles = 100;
constexpr double kMostForMesh = 0.5;  // share of the budget

// A mesh that is torn gets more of the budget, as long as that mends much of it: a gap shows more than a coarse texel.
constexpr double kTorn = 0.02, kMends = 0.75;  // shares of the light paths, and of those that were wrong before
constexpr double kMoreForMesh[] = {0.7, 0.9};
// A mesh with less of an error than this share of the light paths may have fewer triangles, in steps.
constexpr double kUnseen = 4e-4, kFewer = 2.0 / 3, kMuchFewer = 0.9;
constexpr float kLongestEdge = 0.6f, kLongerEdge = 1.4f;

// Texels along a line of one radius, in steps that options can name.
constexpr int kStepsARadius = 10;
constexpr int kCoarsest = kStepsARadius, kFinest = 250 * kStepsARadius;  // a 480-pixel display shows no more

// Shares of the light paths that meet a scene. A chord field does it more justice if more miss the mesh. The edge of a
// volume is soft, so many of its paths stop off the mesh and no hole is seen. Leaves that are left out of a cloud of
// them may be as many.
constexpr double kMostMissed = 0.05, kMostMissedOfVolume = 0.25;
constexpr double kMostWrong = 0.3;  // share of paths where the mesh is added or displaced, other than in volumes

template <class... Values>
std::string formatted(const char* format, Values... values)
{
    char text[200];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

float density_of(int steps)
{
    return static_cast<float>(steps) / kStepsARadius;
}

// Bytes of the file if as many vertices as can be get a view table, or with these settings none does. Throws BakeError
// for more texels than the format holds.
uint64_t most_bytes(const PatchMesh& mesh, float texels_per_radius, const SurfaceSettings& settings, uint32_t states)
{
    constexpr size_t kSections = 7;  // of opaque fields
    const uint64_t vertices = mesh.positions.size(), patches = mesh.patches.size();
    const uint64_t texels = layout_of(mesh, texels_per_radius).texels;
    const bool has_see_through = mesh.see_through_patches != 0 || settings.ground;
    const size_t sections = kSections + (has_see_through ? 1 : 0) + (states > 1 ? 1 : 0);
    uint64_t bytes = aligned(detail::format::kHeaderBytes + sections * detail::format::kEntryBytes);
    for (const uint64_t section :
         {uint64_t{detail::format::kSurfaceBytes}, vertices * detail::format::kVertexBytes,
          patches * detail::format::kPatchBytes, texels, uint64_t{3 * detail::format::kPaletteEntries},
          patches * detail::format::kNeighbourBytes, planned_view_bytes(mesh, settings.view_tables, states)})
        bytes += aligned(section);
    bytes += aligned(most_shadow_bytes(mesh.parts.size(), static_cast<uint32_t>(texels)));
    if (settings.ground) bytes += aligned(most_ground_room(mesh.longest_edge, texels_per_radius).bytes);
    if (states > 1) bytes += aligned(detail::format::states_bytes(states, has_see_through, 0, 0));
    return has_see_through ? bytes + aligned(detail::format::kSeeThroughBytes) : bytes;
}

bool fits(const PatchMesh& mesh, const SurfaceSettings& settings, uint32_t states, int steps, uint64_t budget)
{
    try {
        return most_bytes(mesh, density_of(steps), settings, states) <= budget;
    } catch (const BakeError&) {
        return false;  // more texels than the format holds
    }
}

// Precondition: the coarsest fits.
int finest_that_fits(const PatchMesh& mesh, const SurfaceSettings& settings, uint32_t states, uint64_t budget)
{
    int low = kCoarsest, high = kFinest + 1;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        (fits(mesh, settings, states, middle, budget) ? low : high) = middle;
    }
    return low;
}

uint32_t triangles_for(double bytes, bool is_matt)
{
    const double of_one = is_matt ? kBytesAMattTriangle : kBytesATriangle;
    return static_cast<uint32_t>(std::clamp(bytes / of_one, double{kFewestTriangles}, double{kMostPlannedTriangles}));
}

// Splitting edges takes some kilobytes, however few triangles there are. It serves view tables.
float edge_for(double bytes, bool is_matt)
{
    if (is_matt) return kLongestEdge;
    constexpr double kShort = 0.2, kBytesForShort = 100'000;
    return static_cast<float>(std::clamp(kShort * std::sqrt(kBytesForShort / bytes), kShort, double{kLongestEdge}));
}

// RAM of a view as `lumi embed` writes it unless a program says otherwise, and of its stripe.
uint64_t ram_of(const PatchMesh& mesh, const SurfaceSettings& settings, uint32_t states, const host::ScreenSize& screen,
                uint32_t gloss_maps = 0)
{
    GroundRoom ground = {};
    if (settings.ground) ground = most_ground_room(mesh.longest_edge, settings.texels_per_radius);
    const host::SurfaceCounts counts = {static_cast<uint32_t>(mesh.positions.size()) + ground.vertices,
                                        mesh.opaque_patches(),
                                        SurfaceMode::antialiased,
                                        mesh.see_through_patches + ground.patches,
                                        static_cast<uint32_t>(mesh.parts.size()),
                                        states > 1 ? states : 0,
                                        gloss_maps,
                                        most_viewed_vertices(mesh)};
    return uint64_t{host::surface_view_bytes<PixelRgb565>(counts, screen)} +
           host::stripe_pixel_bytes<PixelRgb565>(screen);
}

bool has_bending_glass(const SceneData& scene)
{
    return std::any_of(
        scene.mesh.materials.begin(), scene.mesh.materials.end(),
        [&](uint32_t material) { return scene.materials[material].glass; });
}

std::string against(const SurfacePlan& plan, bool of_volume)
{
    const MeshLoss& loss = plan.loss;
    const bool lacks_leaves = loss.missed_see_through > kMostMissedOfVolume;
    const double limit = of_volume || lacks_leaves ? kMostMissedOfVolume : kMostMissed,
                 wrong = loss.added + loss.displaced;
    if (lacks_leaves || loss.missed - loss.missed_see_through > limit)
        return formatted(
            "of the light paths that meet the scene %.1f %% miss a mesh of %u triangles (limit %.0f %%), "
            "%.1f %% meet it elsewhere",
            100 * loss.missed, plan.triangles, 100 * limit, 100 * loss.displaced);
    if (of_volume || wrong <= kMostWrong) return "";
    return formatted(
        "for 100 light paths that meet the scene %.1f meet a mesh of %u triangles where the scene is not (limit %.0f)",
        100 * wrong, plan.triangles, 100 * kMostWrong);
}

// The share of the light paths that meet the scene's solid part and do not meet the mesh there.
double wrong_of(const MeshLoss& loss)
{
    return loss.missed - loss.missed_see_through + loss.displaced;
}

// The share of the light paths that meet either scene or mesh alone, or both in different places.
double outline_error(const MeshLoss& loss)
{
    return loss.missed + loss.added + loss.displaced;
}

class Planner
{
public:
    Planner(const Scene& scene, const SurfaceLimits& limits, const ProgressCallback& progress,
            const std::filesystem::path& output)
        : scene_(scene),
          states_(static_cast<uint32_t>(std::max<size_t>(scene.light_states().size(), 1))),
          limits_(limits),
          trials_(as_stage(Stage::mesh, progress)),
          output_(output)
    {
    }

    void plan(SurfacePlan& plan)
    {
        const auto budget = static_cast<double>(limits_.bytes);
        const bool matt = is_matt(scene_.data());
        if (limits_.chooses_triangles) plan.settings.triangles = triangles_for(budget, matt);
        if (limits_.chooses_edge) plan.settings.longest_edge = edge_for(budget, matt);
        make_until_kept(plan);
        for (const double share : kMoreForMesh)
            if (!mend(plan, share, plan.settings.view_tables)) break;
        if (!against(plan, scene_.mesh_is_shell()).empty()) mend(plan, kMoreForMesh[1], false);
        spare_triangles(plan);
        const uint64_t gloss = limited_gloss(plan);
        if (limits_.chooses_density)
            plan.settings.texels_per_radius =
                density_of(finest_that_fits(plan.mesh->mesh, plan.settings, states_, limits_.bytes - gloss));
        plan.most_bytes = most_bytes(plan.mesh->mesh, plan.settings.texels_per_radius, plan.settings, states_) + gloss;
        plan.against = against(plan, scene_.mesh_is_shell());
    }

    // How many bytes do the scene justice, as a mesh of twice, four or eight times the triangles tells; 0 where none
    // does.
    uint64_t enough_bytes(const SurfacePlan& plan)
    {
        constexpr uint32_t kMostTimes = 8;
        if (!plan.mesh || !limits_.chooses_triangles || limits_.ram || scene_.mesh_is_shell()) return 0;
        SurfacePlan larger = {plan.settings};
        for (uint32_t times = 2; times <= kMostTimes; times *= 2) {
            larger.settings.triangles = times * plan.settings.triangles;
            if (larger.settings.triangles > kMostPlannedTriangles) return 0;
            take_mesh(larger);
            if (against(larger, false).empty()) return times * limits_.bytes;
        }
        return 0;
    }

private:
    // Makes meshes until one keeps to the limits.
    void make_until_kept(SurfacePlan& plan)
    {
        do {
            take_mesh(plan);
            if (plan.triangles == 0) throw BakeError("no light path meets a surface");
        } while (shrinks_to_bytes(plan) || shrinks_to_ram(plan));
    }

    // Takes a mesh of so large a share of the bytes, where that is worth it; returns whether it was.
    bool mend(SurfacePlan& plan, double share, bool view_tables)
    {
        const bool may = limits_.chooses_triangles && limits_.chooses_density && !limits_.ram;
        if (!may || scene_.mesh_is_shell() || wrong_of(plan.loss) < kTorn) return false;
        SurfacePlan finer = plan;
        SurfaceSettings& s = finer.settings;
        s.view_tables = view_tables;
        if (limits_.chooses_edge) s.longest_edge = kLongestEdge;
        const auto taken = static_cast<double>(most_bytes(plan.mesh->mesh, density_of(kCoarsest), s, states_));
        s.triangles = static_cast<uint32_t>(
            std::min(double{kMostPlannedTriangles}, s.triangles * share * static_cast<double>(limits_.bytes) / taken));
        most_for_mesh_ = share;
        make_until_kept(finer);
        const bool mends = wrong_of(finer.loss) < kMends * wrong_of(plan.loss);
        if (mends) plan = finer;
        return mends;
    }

    // Takes fewer triangles as long as nobody sees that: larger patches need fewer texels, too.
    void spare_triangles(SurfacePlan& plan)
    {
        const bool may = limits_.chooses_triangles && limits_.chooses_density && !limits_.ram;
        if (!may || plan.settings.fills || scene_.mesh_is_shell()) return;
        while (outline_error(plan.loss) < kUnseen && plan.triangles > kFewestTriangles) {
            SurfacePlan fewer = plan;
            fewer.settings.triangles =
                static_cast<uint32_t>(kFewer * std::min(plan.settings.triangles, plan.triangles));
            make_until_kept(fewer);
            if (outline_error(fewer.loss) > kUnseen || fewer.triangles > kMuchFewer * plan.triangles) return;
            plan = fewer;
        }
    }

    void take_mesh(SurfacePlan& plan)
    {
        MeshSettings settings;
        settings.triangles = plan.settings.triangles;
        settings.longest_edge = plan.settings.longest_edge;
        settings.cap = ViewCap(plan.settings.cap);
        Job job(mesh_work(scene_.data(), settings), plan.settings.threads, trials_.next());
        BakeStages stages(output_.empty() ? output_ : stages_of(output_), scene_.fingerprint());
        const auto built = std::make_shared<const BuiltMesh>(build_mesh(scene_.data(), settings, stages, job));
        plan.mesh = built;
        plan.triangles = triangle_count(built->mesh);
        plan.loss = built->loss;
        plan.warnings = built->warnings;
        if (has_bending_glass(scene_.data()))
            plan.warnings.push_back(
                {"the scene has bodies of glass, of which a surface field shows a coarse colour that depends on the "
                 "view",
                 "give thin panes an opacity (d) instead"});
    }

    // Whether the mesh takes too many of the bytes, and the settings ask for a smaller one now.
    bool shrinks_to_bytes(SurfacePlan& plan) const
    {
        const uint64_t least = most_bytes(plan.mesh->mesh, density_for_mesh(plan), plan.settings, states_);
        const auto budget = static_cast<double>(limits_.bytes);
        const double most = limits_.chooses_density && limits_.chooses_triangles ? most_for_mesh_ * budget : budget;
        if (static_cast<double>(least) <= most) return false;
        const double share = static_cast<double>(least) / budget;
        SurfaceSettings& s = plan.settings;
        if (shrink(s, kLongerEdge * s.longest_edge, s.triangles * std::min(0.8, most_for_mesh_ / share))) return true;
        if (least > limits_.bytes)
            throw BakeError("nothing fits into " + std::to_string(limits_.bytes) +
                            " bytes; the smallest that works takes " + std::to_string(least) + " bytes");
        return false;
    }

    // Does the same for RAM, but to the size.
    bool shrinks_to_ram(SurfacePlan& plan) const
    {
        constexpr double kLeastStep = 0.95;  // so that there are few meshes
        if (!limits_.ram) return false;
        const host::ScreenSize& screen = limits_.ram->screen;
        plan.ram_bytes = ram_of(plan.mesh->mesh, plan.settings, states_, screen);
        if (plan.ram_bytes <= limits_.ram->bytes) return false;
        if (plan.triangles_without_ram == 0) plan.triangles_without_ram = plan.triangles;
        const uint64_t least = ram_of({}, {}, states_, screen);  // does not depend on the mesh
        const double room = static_cast<double>(limits_.ram->bytes) - static_cast<double>(least),
                     needed = static_cast<double>(plan.ram_bytes) - static_cast<double>(least);
        const double share = std::min(kLeastStep, room / needed);
        SurfaceSettings& s = plan.settings;
        if (room > 0 && shrink(s, s.longest_edge / static_cast<float>(std::sqrt(share)), s.triangles * share))
            return true;
        throw BakeError("view and stripe of " + std::to_string(screen.stripe_rows()) + " rows take " +
                        std::to_string(plan.ram_bytes) + " bytes of RAM with a mesh of " +
                        std::to_string(plan.triangles) + " triangles, " + std::to_string(least) +
                        " without any; give more --ram, or fewer --rows");
    }

    // As many gloss maps as keep to the limits beside the mesh. Returns what they take beyond the tables' bytes.
    uint64_t limited_gloss(SurfacePlan& plan) const
    {
        constexpr uint64_t kMostOneOf = 8;  // of the bytes: texels need them more
        const PatchMesh& mesh = plan.mesh->mesh;
        uint32_t& maps = plan.settings.gloss_maps;
        if (!may_gloss(scene_.data(), mesh, plan.settings)) return 0;
        const uint64_t others = most_bytes(mesh, density_for_mesh(plan), plan.settings, states_);
        const auto beyond = [&] { return gloss_bytes_beyond_tables(mesh, maps); };
        while (maps != 0 && (others + beyond() > limits_.bytes || beyond() > limits_.bytes / kMostOneOf)) --maps;
        if (limits_.ram) {
            const auto ram = [&] { return ram_of(mesh, plan.settings, states_, limits_.ram->screen, maps); };
            for (; maps != 0 && ram() > limits_.ram->bytes; --maps) plan.fewer_maps = true;
            plan.ram_bytes = ram();
        }
        return beyond();
    }

    // The density of the fewest bytes.
    float density_for_mesh(const SurfacePlan& plan) const
    {
        return limits_.chooses_density ? density_of(kCoarsest) : plan.settings.texels_per_radius;
    }

    // First by longer edges, since splitting them shows less than triangles do. False where it cannot be.
    bool shrink(SurfaceSettings& s, float longer_edge, double fewer_triangles) const
    {
        if (limits_.chooses_edge && s.longest_edge < kLongestEdge) {
            s.longest_edge = std::min(kLongestEdge, longer_edge);
            return true;
        }
        if (!limits_.chooses_triangles || s.triangles <= kFewestTriangles) return false;
        s.triangles = std::max(kFewestTriangles, static_cast<uint32_t>(fewer_triangles));
        return true;
    }

    const Scene& scene_;
    const uint32_t states_;  // of the light
    const SurfaceLimits& limits_;
    JobSeries trials_;
    const std::filesystem::path& output_;
    double most_for_mesh_ = kMostForMesh;  // share of the budget
};

}  // namespace

SurfacePlan plan_surface(const Scene& scene, const SurfaceSettings& settings, const SurfaceLimits& limits,
                         const ProgressCallback& progress, const std::filesystem::path& output)
{
    SurfacePlan plan = {settings};
    try {
        require_partial_coverage(scene.data(), false);
        Planner planner(scene, limits, progress, output);
        planner.plan(plan);
        if (!plan.against.empty()) plan.enough_bytes = planner.enough_bytes(plan);
        return plan;
    } catch (const BakeError& error) {
        SurfacePlan none = {settings};
        none.against = error.what();
        return none;
    }
}

}  // namespace lumi::baker
