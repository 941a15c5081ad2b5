// SPDX-License-Identifier: MIT
// The mesh that carries a surface field's radiance (lumi/surface/format.h).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/view_cap.h"
#include "lumi/baker/surface.h"
#include "math/vec3.h"
#include "scene/scene_data.h"
#include "util/job.h"

namespace lumi::baker
{

class BakeStages;

// A rigid opaque part of the scene that turns about an axis, right-handed, or slides along it, in the unit sphere's
// frame. It moves from one value to another, turns or radii; a turn that spans 1 or more is free. At 0 it is where the
// mesh has it.
struct MovingPart {
    std::string name;  // 1 .. 40 bytes of UTF-8
    bool slides = false;
    bool light_stays = false;  // it turns, and the eye of its view tables does not turn with it
    Vec3 axis, pivot;          // unit length; a point of the axis, of a turn
    double from = 0, to = 1;
    uint32_t first_patch = 0;  // its patches run to the next part's, the last part's to the end of the opaque ones
    uint32_t follows = 0;      // k: the shadow of parts[k - 1], which moves as that does; such ones come last
};

struct PatchMesh {
    static constexpr uint32_t kNone = UINT32_MAX;

    // Triangle (a, b, c), counter-clockwise seen from outside, and unless d is kNone (d, c, b).
    struct Patch {
        uint32_t a, b, c, d;
    };

    std::vector<Vec3> positions;  // in the unit sphere's frame, rounded to steps of 2^-14
    std::vector<Vec3> normals;    // unit length: about where the surface around a vertex faces; view tables turn by it
    std::vector<Patch> patches;   // those of the body, of part after part, and see-through ones
    std::vector<MovingPart> parts;
    float longest_edge = 0;            // the longest edge of any triangle
    uint32_t see_through_patches = 0;  // the last so many
    uint32_t ground_patches = 0;       // the first so many of those: a shadow below the object
    uint32_t has_panes = 0;            // 1: of those some mirror, so they have view tables
    uint32_t is_matt = 0;              // 1: nearly all surfaces of the scene are, so few vertices need a view table
    uint32_t is_in_drawing_order = 0;  // 1: those are drawn one after the other, else from far to near

    uint32_t opaque_patches() const { return static_cast<uint32_t>(patches.size()) - see_through_patches; }
    // Owners are 0, the body, and k of parts[k - 1].
    uint32_t owner_of(uint32_t patch) const;
    // The first patch of an owner; of one more than there are, the first that is see-through.
    uint32_t first_patch(uint32_t owner) const
    {
        return owner == 0 ? 0 : owner > parts.size() ? opaque_patches() : parts[owner - 1].first_patch;
    }
};

struct BuiltMesh {
    PatchMesh mesh;
    MeshLoss loss;
    std::vector<MeshWarning> warnings;
};

struct MeshSettings {
    uint32_t triangles = 4000;   // about so many before edges are split
    float longest_edge = 0.2f;   // edges longer than this are split, in radii
    float crease_cosine = 0.2f;  // faces that turn more than this, 78°, get vertices of their own
    ViewCap cap = {};            // what cannot be seen from there is left out
};

// The patches of a mesh whose vertices at creases are parted.
PatchMesh assembled(const Mesh& shape, float crease_cosine);
// The triangles of a part, and their numbers in the field: 2p or 2p + 1 of patch p.
Mesh opaque_triangles(const PatchMesh& mesh, std::vector<uint32_t>& numbers);
Mesh triangles_of(const PatchMesh& mesh, uint32_t owner, std::vector<uint32_t>& numbers);  // opaque ones
Mesh see_through_triangles(const PatchMesh& mesh, std::vector<uint32_t>& numbers);
// By vertex: whether it can have a view table. What see-through patches add depends on the view where they mirror.
std::vector<uint8_t> viewable_vertices(const PatchMesh& mesh);
// So many vertices get one at most: all that can, or of a matt mesh some for each state of the light.
uint32_t most_viewed_vertices(const PatchMesh& mesh, uint32_t states = 1);
uint32_t triangle_count(const PatchMesh& mesh);
// Whether the format can hold it.
bool fits(const PatchMesh& mesh);

// About as much work as tracing so many light paths.
uint64_t mesh_work(const SceneData& scene, const MeshSettings& settings);

// Whether at most an eighth of a scene's area, hidden or not, shows much that depends on the view.
bool is_matt(const SceneData& scene);

// Adds patches of another mesh behind those that there are.
void append(PatchMesh& mesh, const PatchMesh& other);

// At most kMaxSurfaceVertices vertices and kMaxPatches patches (lumi/surface/format.h); none where nothing can be seen.
// Opaque parts come first, then see-through ones. Throws BakeError for a scene that no mesh can hold.
BuiltMesh build_mesh(const SceneData& scene, const MeshSettings& settings, BakeStages& stages, Job& job);

}  // namespace lumi::baker
