// SPDX-License-Identifier: MIT
// The scene as the path tracer sees it: in the frame of the unit sphere, ready for ray queries.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "geometry/accelerator.h"
#include "light/light_set.h"
#include "model/scene_parts.h"
#include "scene/light_choice.h"
#include "volume/medium.h"

namespace lumi::baker
{

struct SceneData {
    SceneData(SceneParts parts, const LoadOptions& options);
    SceneData(const SceneData&) = delete;
    SceneData& operator=(const SceneData&) = delete;

    std::array<double, 3> centre;  // the sphere's centre, in scene units and scene axes
    double radius;
    UpAxis up;

    MovingParts moving;
    Mesh mesh;  // with parts that move in the pose of the files
    std::vector<Material> materials;
    std::shared_ptr<const std::vector<Texture>> shared_textures;
    const std::vector<Texture>& textures;  // those
    ToneCurve tone;
    bool has_transparency;  // some material may let light pass
    bool mesh_is_shell;     // the mesh only tells where the volume looks solid: light passes it
    std::optional<Medium> medium;
    Accelerator accelerator;
    LightChoice choice;             // its exposure is a factor that the light of `materials` and `lights` already has
    std::vector<Fixture> fixtures;  // `lights` has them, too
    LightSet lights;
    LightStates states;
    std::vector<NamedView> views;
};

Environment exposed(Environment environment, float exposure);

// The parts of a volume without objects get their shell if the options ask for it, unless the volume is solid nowhere.
// Throws SceneError if the parts hold neither a triangle nor a volume, or what a given sphere does not hold.
Scene build_scene(SceneParts parts, const LoadOptions& options);

}  // namespace lumi::baker
