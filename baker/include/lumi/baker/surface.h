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
#include <string>
#include <vector>

#include "lumi/baker/bake.h"
#include "lumi/baker/mesh_loss.h"
#include "lumi/baker/progress.h"
#include "lumi/baker/scene.h"

namespace lumi::baker
{

struct SurfaceSettings {
    uint32_t triangles = 4000;       // about so many before edges are split
    float longest_edge = 0.2f;       // edges longer than this are split, in radii
    float texels_per_radius = 100;   // texels along a line of one radius
    uint32_t paths_per_texel = 300;  // light paths, in the mean
    // Share of the sphere around the scene, its uppermost part, from which eyes at any distance look. What none of them
    // sees is left out; from elsewhere, what is there is drawn, and the rest is absent.
    float cap = 1;
    bool view_tables = true;  // false: colours do not depend on the direction of view
    uint64_t seed = 1;
    unsigned threads = 0;  // 0 = as many as the machine has
};

struct SurfaceBake {
    std::vector<uint8_t> file;
    uint32_t vertices = 0, viewed_vertices = 0, triangles = 0, texels = 0;
    MeshLoss loss;
    uint64_t paths = 0;  // that meet the mesh where the scene is
};

struct BuiltMesh;  // baker's own, see baker/src

// The mesh of a surface field before any light is traced: what the file will take, and what the mesh gets wrong.
class SurfaceDraft
{
public:
    // Only the settings triangles, longest edge, cap and threads matter. If the name of the field is given, the steps
    // of the mesh that are done are kept beside it, and found there. Throws BakeError for a scene that no surface field
    // can hold, Cancelled.
    SurfaceDraft(const Scene& scene, const SurfaceSettings& settings, const ProgressCallback& progress = {},
                 const std::filesystem::path& output = {});
    ~SurfaceDraft();
    SurfaceDraft(SurfaceDraft&&) noexcept;
    SurfaceDraft& operator=(SurfaceDraft&&) noexcept;

    uint32_t triangles() const;  // 0: there is no surface
    // What the field will have; patches are opaque ones, see-through ones besides.
    uint32_t vertices() const;
    uint32_t patches() const;
    uint32_t see_through_patches() const;
    const MeshLoss& loss() const;
    const std::vector<MeshWarning>& warnings() const;
    // The file's bytes if every vertex gets a view table. Throws BakeError for more texels than the format holds.
    uint64_t most_bytes(float texels_per_radius) const;

    const BuiltMesh& built() const { return *built_; }

private:
    std::unique_ptr<BuiltMesh> built_;
};

// The bytes depend on scene, settings and seed, never on `threads`. Memory: about a kilobyte a texel. Throws BakeError
// for settings that no field can hold, Cancelled. A `draft` of the same scene and settings saves building its mesh
// again.
SurfaceBake surface_field(const Scene& scene, const SurfaceSettings& settings, const ProgressCallback& progress = {},
                          const SurfaceDraft* draft = nullptr);

// Writes `output` when all is done, as bake_field does: until then an earlier file of that name stays as it was. The
// checkpoint keeps the mesh and the sums of what is traced, written every few seconds and when a bake is cancelled.
// A file of stages beside it keeps the parts of mesh, pilot and solution that are done.
// Disk: about three times the sums, which take some hundred bytes a texel; of the pilot 2 kB a texel, at most 480 MB.
// Throws BakeError, Cancelled; either way both stay.
SurfaceBake bake_surface(const Scene& scene, const SurfaceSettings& settings, const std::filesystem::path& output,
                         const ProgressCallback& progress = {}, Earlier earlier = Earlier::resume,
                         const SurfaceDraft* draft = nullptr);

// Where the stages of a bake of `output` are kept that was begun and is not done; empty if there are none.
std::filesystem::path kept_stages(const std::filesystem::path& output);
void discard_stages(const std::filesystem::path& output);

// The same for one shard of the light paths, as bake_shard does. Each shard traces the pilot for itself, about 65 paths
// a texel: that share of the work is not divided.
void bake_surface_shard(const Scene& scene, const SurfaceSettings& settings, const Shard& shard,
                        const std::filesystem::path& output, const ProgressCallback& progress = {},
                        Earlier earlier = Earlier::resume);

}  // namespace lumi::baker
