// SPDX-License-Identifier: MIT
// What a reader of a file format delivers of a scene.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/bounding_sphere.h"
#include "geometry/mesh.h"
#include "image/texture.h"
#include "image/tone.h"
#include "light/fixtures.h"
#include "lumi/baker/scene.h"
#include "material/material.h"
#include "volume/volume.h"

namespace lumi::baker
{

// Level: its normal is the up axis.
struct Disc {
    Vec3 centre;
    float radius;
};

// A scene in its own units and axes, before the sphere is fitted. Positions are finite, every triangle has an area,
// indices and materials are in range.
struct SceneParts {
    Mesh mesh;
    std::array<double, 3> origin = {0, 0, 0};  // what to add to the mesh's positions, and to nothing else
    std::vector<Material> materials;           // finished
    std::vector<Texture> textures;
    std::vector<Fixture> fixtures;
    std::optional<Disc> catcher;  // catches shadows, see catcher.h
    std::optional<Volume> volume;
    bool mesh_is_shell = false;  // see SceneData
    ToneCurve tone = ToneCurve::srgb;
    // In place of the defaults, where LoadOptions leave them open:
    std::optional<UpAxis> up;
    std::optional<Environment> environment;
    std::optional<float> exposure;         // factor on all light
    std::optional<BoundingSphere> sphere;  // in place of the fitted one
};

}  // namespace lumi::baker
