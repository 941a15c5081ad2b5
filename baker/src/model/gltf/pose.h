// SPDX-License-Identifier: MIT
// Poses a glTF model: its nodes at a time of an animation, and vertices by morph targets and by the joints of a skin.
#pragma once

#include "lumi/baker/scene.h"
#include "model/gltf/model.h"
#include "model/gltf/shape.h"

namespace lumi::baker
{

// Normals turn by the matrix of cofactors, which is the inverse transposed but for a factor; also where there is none.
Affine cofactors(const Affine& m);
// A unit vector, or 0 where the direction is lost.
Vec3 turned(const Affine& turn, const Vec3& n);

// Moves nodes and sets their weights as the animation does at the time, which is held within its first and last key.
// Throws SceneError where there is no animation of that name, or it is damaged.
void play(GltfModel& model, const AnimationTime& time);

// One for each node: from its axes to those of the scene. Nodes that are their own ancestors keep the identity.
std::vector<Affine> places_of_nodes(const GltfModel& model);

// Takes vertices of a skin from where they were bound to where its joints are. Throws SceneError that names the skin.
std::vector<Affine> joint_matrices(const GltfModel& model, int32_t skin, const std::vector<Affine>& places);

// Adds what the targets move, each by its weight. `used`: the rows of the shape's vertices.
void morph(const GltfModel& model, const GltfPrimitive& primitive, const std::vector<float>& weights,
           const std::vector<uint32_t>& used, GltfShape& shape);
// How many vertices that reads and moves, those of each target anew.
size_t morphed_vertices(const GltfPrimitive& primitive, const std::vector<float>& weights, size_t vertices);

// Up to eight joints hold a vertex. False where the primitive names none: then it goes with its node.
bool bend(const GltfModel& model, const GltfPrimitive& primitive, const std::vector<Affine>& joints,
          const std::vector<uint32_t>& used, GltfShape& shape);

}  // namespace lumi::baker
