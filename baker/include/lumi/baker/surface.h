// SPDX-License-Identifier: MIT
// Bakes a scene into a surface field (lumi/surface/format.h): radiance kept where rays meet the surface.
//
// Random lines through the unit sphere, uniform over all lines, meet a mesh that follows the scene; the light along
// each is one sample of a model that is linear in texels and view tables. What is kept of the samples are integer sums,
// so memory does not grow with the number of paths, and order does not matter.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lumi/baker/bake.h"
#include "lumi/baker/progress.h"
#include "lumi/baker/scene.h"
#include "lumi/host/view_memory.h"

namespace lumi::baker
{

// A radius, for each pixel of a display's shorter side: 1.25 to a pixel where the sphere fills it.
inline constexpr float kFinestTexelsASide = 0.625f;

struct SurfaceSettings {
    uint32_t triangles = 4000;      // about so many before edges are split
    float longest_edge = 0.2f;      // edges longer than this are split, in radii
    float texels_per_radius = 100;  // texels along a line of one radius, in the mean
    uint32_t paths_per_texel = 60;  // light paths, in the mean; never fewer than the pilot's
    // Share of the sphere around the scene, its uppermost part, from which eyes at any distance look. What none of them
    // sees is left out; from elsewhere, what is there is drawn, and the rest is absent.
    float cap = 1;
    bool view_tables = true;  // false: colours do not depend on the direction of view
    uint32_t gloss_maps = 3;  // at most so many, up to 3; for highlights with edges
    bool fills = false;       // texels_per_radius also where fewer texels would show as much
    // Unless that: nowhere more texels along a line of one radius, since texels that are smaller than a pixel of the
    // display flicker, and are not seen.
    float finest_texels = kFinestTexelsASide * 240;
    bool ground = false;  // a soft shadow below the object, on a level ground that is not drawn
    bool draft = false;   // the file says that it is a first look
    uint64_t seed = 1;
    unsigned threads = 0;  // 0 = as many as the machine has
};

// The errors of the mesh, in shares of the rays that meet the scene.
struct MeshLoss {
    double missed = 0;              // the mesh is not there
    double missed_see_through = 0;  // a part of that lies where see-through parts are
    double added = 0;               // the ray meets the mesh, but not the scene
    double displaced = 0;           // the depths differ by more than a twentieth of the radius

    // The share of the scene itself that is thinner than a pixel at 240 x 240; 0 where light may pass through surfaces.
    double thin = 0;

    // These are known for the mesh of a surface field only:
    uint32_t holes = 0;         // regions of more than 2 pixels that its silhouettes lack, 24 of 240 × 240 pixels
    uint32_t largest_hole = 0;  // pixels
};

// These are for the user, each as the part of a sentence.
struct MeshWarning {
    std::string problem;
    std::string remedy;  // in the scene, or by another layout; may be empty
    bool more_triangles_help =
        false;  // settings with more triangles are a remedy, too; not where the scene has no more
};

// A view that draws up to `antialiased`, and its stripe, take at most so much RAM.
struct RamLimit {
    uint64_t bytes;
    host::ScreenSize screen;
};

// The limits that a field must keep to, and which settings a plan may choose for that.
struct SurfaceLimits {
    uint64_t bytes = 500'000;
    std::optional<RamLimit> ram = std::nullopt;
    bool chooses_triangles = true, chooses_edge = true, chooses_density = true;
};

inline constexpr uint32_t kMostPlannedTriangles = 6000;  // more are asked for by hand

struct BuiltMesh;  // baker's own, see baker/src

// All that is decided of a field before its light is traced.
struct SurfacePlan {
    SurfaceSettings settings;
    // Null: a bake makes the mesh of the settings when it needs one.
    std::shared_ptr<const BuiltMesh> mesh = nullptr;
    uint32_t triangles = 0;  // the mesh has these, and what follows
    MeshLoss loss = {};
    std::vector<MeshWarning> warnings = {};
    uint64_t most_bytes = 0;             // the file has these if every vertex gets a view table, and all maps pay
    uint64_t ram_bytes = 0;              // 0 where there is no limit
    uint32_t triangles_without_ram = 0;  // before the limit of RAM made the mesh coarser; 0: it did not
    bool fewer_maps = false;             // the limit of RAM leaves fewer gloss maps than that of bytes
    std::string against = {};            // why the mesh does the scene no justice, with figures; may be empty
    uint64_t enough_bytes = 0;           // then about so many do it; 0: nobody knows
};

// From a scene to the mesh of its field. A mesh or two are made, which takes seconds to a minute, and a few more where
// RAM is scarce or thin parts take many triangles: these get more of the bytes, and if need be those of view tables. If
// the name of the field is given, the steps that are done are kept beside it, and found there. Where no surface field
// can hold the scene or keep to the limits, the plan has no mesh, and `against` tells why. Throws Cancelled.
SurfacePlan plan_surface(const Scene& scene, const SurfaceSettings& settings, const SurfaceLimits& limits,
                         const ProgressCallback& progress = {}, const std::filesystem::path& output = {});

struct SurfaceBake {
    std::vector<uint8_t> file;
    uint32_t vertices = 0, viewed_vertices = 0, triangles = 0, texels = 0;
    MeshLoss loss;
    uint64_t paths = 0;              // that meet the mesh where the scene is
    std::vector<std::string> notes;  // what parts and ground lack, a sentence each
    bool suffices = false;           // settings allow more texels, which would show no more
};

// The bytes depend on scene, settings and seed, never on `threads`. Memory: about a kilobyte a texel, and up to 100 kB
// a patch. Throws BakeError for scenes and settings that no field can hold, Cancelled.
SurfaceBake surface_field(const Scene& scene, const SurfacePlan& plan, const ProgressCallback& progress = {});

// Writes `output` when all is done, as bake_field does: until then an earlier file of that name stays as it was. The
// checkpoint keeps the mesh and the sums of what is traced, written every few seconds and when a bake is cancelled.
// A file of stages beside it keeps the parts of mesh, pilot and solution that are done.
// Disk, for fields of the usual size at most 300 MB: first the pilot's paths, about 42 bytes each, then twice the sums.
// Throws BakeError, Cancelled; either way both stay.
SurfaceBake bake_surface(const Scene& scene, const SurfacePlan& plan, const std::filesystem::path& output,
                         const ProgressCallback& progress = {}, Earlier earlier = Earlier::resume);

// Does the same for one shard of the light paths, as bake_shard does. Each shard traces the pilot for itself, at most
// 32 paths a texel: that share of the work is not divided.
void bake_surface_shard(const Scene& scene, const SurfacePlan& plan, const Shard& shard,
                        const std::filesystem::path& output, const ProgressCallback& progress = {},
                        Earlier earlier = Earlier::resume);

// Where the stages of a bake of `output` are kept that was begun and is not done; empty if there are none.
std::filesystem::path kept_stages(const std::filesystem::path& output);
void discard_stages(const std::filesystem::path& output);

}  // namespace lumi::baker
