// SPDX-License-Identifier: MIT
// The scene as the path tracer sees it: in the frame of the unit sphere, ready for ray queries.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "geometry/accelerator.h"
#include "geometry/bounding_sphere.h"
#include "geometry/mesh.h"
#include "image/texture.h"
#include "image/tone.h"
#include "light/light_set.h"
#include "lumi/baker/scene.h"
#include "material/material.h"
#include "volume/medium.h"

namespace lumi::baker
{

// Level: its normal is the up axis.
struct Disc {
    Vec3 centre;
    float radius;
};

// A scene in its own units and axes, before the sphere is fitted: what a reader of a file format delivers. Positions
// are finite, every triangle has an area, indices and materials are in range.
struct SceneParts {
    Mesh mesh;
    std::vector<Material> materials;  // finished
    std::vector<Texture> textures;
    std::vector<Fixture> fixtures;
    std::optional<Disc> catcher;  // catches shadows, see catcher.h
    std::optional<Volume> volume;
    bool mesh_is_shell = false;  // see SceneData
    float exposure = 1;          // factor on all light
    ToneCurve tone = ToneCurve::srgb;
    // In place of the defaults, where LoadOptions leave them open:
    std::optional<UpAxis> up;
    std::optional<Environment> environment;
    std::optional<BoundingSphere> sphere;  // in place of the fitted one
};

struct SceneData {
    SceneData(SceneParts parts, const LoadOptions& options);
    SceneData(const SceneData&) = delete;
    SceneData& operator=(const SceneData&) = delete;

    std::array<double, 3> centre;  // the sphere's centre, in scene units and scene axes
    double radius;
    UpAxis up;

    Mesh mesh;
    std::vector<Material> materials;
    std::vector<Texture> textures;
    ToneCurve tone;
    bool has_transparency;  // some material may let light pass
    bool mesh_is_shell;     // the mesh only tells where the volume looks solid: light passes it
    std::optional<Disc> catcher;
    std::optional<Medium> medium;
    Accelerator accelerator;
    LightSet lights;
};

// The parts of a volume without objects get their shell if the options ask for it, unless the volume is solid nowhere.
// Throws SceneError if the parts hold neither a triangle nor a volume, or what a given sphere does not hold.
Scene build_scene(SceneParts parts, const LoadOptions& options);

}  // namespace lumi::baker
