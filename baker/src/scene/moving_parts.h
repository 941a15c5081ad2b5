// SPDX-License-Identifier: MIT
// The parts of a scene that move: which triangles they are, and the scenes that light them.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "scene/scene_data.h"

namespace lumi::baker
{

// Makes pieces of a scene its moving parts: those of a scene file, and those of the caller, whose pose counts where
// both name one. `file` serves messages. Throws SceneError for what cannot move.
void set_moving_parts(const std::filesystem::path& file, const std::vector<PartOptions>& options, SceneParts& parts);

// A scene with other triangles, in the same light and the same sphere; none of them moves. `more`: materials behind
// those of the scene.
std::unique_ptr<SceneData> with_mesh(const SceneData& scene, Mesh mesh, const std::vector<Material>& more = {});
// Only the triangles of one owner: 0 of the body, k of the k-th part.
std::unique_ptr<SceneData> only_of(const SceneData& scene, uint32_t owner);
// The body, and one part in a pose.
std::unique_ptr<SceneData> lit_with(const SceneData& scene, uint32_t owner, double value);

inline constexpr size_t kMostLitPoses = 4;

// A part in one of the poses whose light it has.
struct LitPose {
    std::unique_ptr<SceneData> scene;  // the body and this part
    Affine pose;                       // from the mesh's

    Ray posed(const Ray& ray) const;
};

// Holds the scenes that light a surface field's triangles: the body's is the body alone, a part's both. So no part
// casts a shadow that would stay where it is. Where nothing moves, it is the scene.
class LitScenes
{
public:
    explicit LitScenes(const SceneData& scene);  // borrows it
    const SceneData& body() const { return body_ ? *body_ : scene_; }
    const std::vector<LitPose>& poses(uint32_t owner) const { return parts_[owner - 1]; }

private:
    const SceneData& scene_;
    std::unique_ptr<SceneData> body_;
    std::vector<std::vector<LitPose>> parts_;
};

}  // namespace lumi::baker
