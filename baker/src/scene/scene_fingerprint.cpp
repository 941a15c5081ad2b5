// SPDX-License-Identifier: MIT
// Each function takes its struct apart by a structured binding of all members: a member that is added there and not
// here does not compile. Add what it says to the digest, unless it is derived from what is hashed already.
#include "scene/scene_fingerprint.h"

namespace lumi::baker
{
namespace
{

void add(Digest& digest, const Mesh& mesh)
{
    const auto& [positions, normals, uvs, second_uvs, corners, shading, mapping, materials] = mesh;
    digest.add(positions);
    digest.add(normals);
    digest.add(uvs);
    if (!second_uvs.empty()) digest.add(second_uvs);  // older scenes keep their fingerprints
    digest.add(corners);
    digest.add(shading);
    digest.add(mapping);
    digest.add(materials);
}

void add(Digest& digest, const TextureSlots& slots)
{
    const auto& [base, emission, roughness, metalness, opacity, normal, sheen, transmission] = slots;
    for (const TextureSlot* slot :
         {&base, &emission, &roughness, &metalness, &opacity, &normal, &sheen, &transmission}) {
        if (slot == &transmission && !slot->used()) continue;
        const auto& [texture, scale, offset, turn, wrap, takes_second_uvs] = *slot;
        digest.add(texture);
        digest.add(scale);
        digest.add(offset);
        const bool is_plain = turn.y == 0 && turn.x == 1 && wrap == TextureSlot().wrap && !takes_second_uvs;
        if (is_plain) continue;  // older scenes keep their fingerprint
        digest.add(turn);
        digest.add(wrap);
        digest.add(takes_second_uvs);
    }
}

// Nothing where nothing moves: older scenes keep their fingerprints.
void add(Digest& digest, const MovingParts& moving)
{
    const auto& [motions, owners] = moving;
    if (motions.empty()) return;
    digest.add(owners);
    for (const PartMovement& motion : motions) {
        const auto& [name, slides, axis, pivot, is_limited, from, to, value, lit_at] = motion;
        digest.add(name);
        digest.add(slides);
        digest.add(axis);
        digest.add(pivot);
        digest.add(is_limited);
        digest.add(from);
        digest.add(to);
        digest.add(value);
        for (const double pose : motion.lit_poses(1)) digest.add(pose);
        digest.add(lit_at.has_value());
    }
}

// The name does not count: materials are found by number. What finish() makes of the rest does not, either.
void add(Digest& digest, const Material& material)
{
    for (const MaterialParameter& parameter : kMaterialParameters)
        std::visit([&](auto member) { digest.add(material.*member); }, parameter.member);
    digest.add(material.specular);
    digest.add(material.rough_body);
    digest.add(material.glass);
    add(digest, material.maps);
    const bool is_plain = !material.thin && !material.blends && material.transmission == 1 && material.tint.r == 1 &&
                          material.tint.g == 1 && material.tint.b == 1;
    if (is_plain) return;  // older scenes keep their fingerprint
    digest.add(material.thin);
    digest.add(material.blends);
    digest.add(material.transmission);
    digest.add(material.tint);
}

void add(Digest& digest, const Texture& texture)
{
    const auto& [width, height, rgb, encoded] = texture;
    digest.add(width);
    digest.add(height);
    digest.add(rgb);
    digest.add(encoded);
}

}  // namespace

Digest::Value scene_fingerprint(const SceneData& scene)
{
    const auto& [centre, radius, up, moving, mesh, materials, shared_textures, textures, tone, has_transparency,
                 mesh_is_shell, medium, accelerator, choice, fixtures, lights, states, views] = scene;
    static_cast<void>(has_transparency);
    static_cast<void>(shared_textures);  // `textures` are those
    static_cast<void>(accelerator);
    static_cast<void>(choice);    // materials and lights have it
    static_cast<void>(fixtures);  // `lights` has them
    static_cast<void>(views);
    Digest digest;
    digest.add(centre);
    digest.add(radius);
    digest.add(up);
    digest.add(tone);
    if (medium) medium->add_to(digest);
    add(digest, mesh_is_shell ? Mesh() : mesh);  // a shell is made from the medium
    for (const Material& material : mesh_is_shell ? std::vector<Material>() : materials) add(digest, material);
    for (const Texture& texture : textures) add(digest, texture);
    lights.add_to(digest);
    add(digest, moving);
    for (const std::string& name : states.names) digest.add(name);
    if (!states.names.empty()) {  // scenes without states keep their fingerprint
        digest.add(states.of_material);
        digest.add(states.of_fixture);
        digest.add(states.of_sky);
        digest.add(states.are_tints);
    }
    return digest.value();
}

}  // namespace lumi::baker
