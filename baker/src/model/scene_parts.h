// SPDX-License-Identifier: MIT
// A reader of a file format delivers these parts of a scene.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/bounding_sphere.h"
#include "geometry/mesh.h"
#include "image/texture.h"
#include "image/tone.h"
#include "light/fixtures.h"
#include "lumi/baker/scene.h"
#include "material/material.h"
#include "model/part_motion.h"
#include "volume/affine.h"
#include "volume/volume.h"

namespace lumi::baker
{

// Level: its normal is the up axis.
struct Disc {
    Vec3 centre;
    float radius;
};

// Triangles that an object, a group or a node of the file names; those of nodes below it are among them.
struct NamedPart {
    std::string name;
    size_t first = 0, end = 0;
    std::optional<Affine> frame = std::nullopt;  // of a node: from its axes to those of the scene
    size_t bent_end = 0;                         // from `first` on, what a skin bends; 0: nothing
};

// A camera of the file: from its axes (it looks along -z, y up) to those of the scene, with scale or shear if the file
// has them.
struct SceneView {
    std::string name;
    Affine to_scene{};
    double fov_y = 0;  // radians, above 0
};

// Groups of lights: the numbers of states, 0 where there is none. Lists may be shorter than what they count.
struct LightStates {
    std::vector<std::string> names;  // the first, base, is all that no other names; empty: there are no states
    std::vector<uint8_t> of_material, of_fixture;
    uint8_t of_sky = 0;
    bool are_tints = false;  // states are base colours of materials, and base is all light where these are black
};

// A scene in its own units and axes, before the sphere is fitted. Positions are finite, every triangle has an area,
// indices and materials are in range.
struct SceneParts {
    Mesh mesh;
    std::array<double, 3> origin = {0, 0, 0};  // to be added to the mesh's positions, and to nothing else
    std::vector<Material> materials;           // finished
    std::vector<Texture> textures;
    std::shared_ptr<const std::vector<Texture>> shared_textures;  // in place of `textures`, where scenes share them
    std::vector<Fixture> fixtures;
    std::vector<std::string> fixture_names;  // may be shorter; of a scene file, which has_labels, labels of states
    bool has_labels = false;
    std::string sky_state;  // a label; may be empty
    LightStates states;
    std::vector<NamedPart> named;           // names may come twice
    std::vector<PartOptions> part_options;  // of a scene file
    MovingParts moving;
    std::vector<SceneView> views;
    std::vector<std::string> notes;  // choices that the file leaves open, a sentence each
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
