// SPDX-License-Identifier: MIT
#include "scene/moving_parts.h"

#include <algorithm>
#include <cmath>

#include "lumi/surface/format.h"
#include "scene/named_triangles.h"
#include "util/text_lines.h"

namespace lumi::baker
{
namespace
{

using Vec3d = std::array<double, 3>;

class PartMarker
{
public:
    PartMarker(std::string file, SceneParts& parts) : file_(std::move(file)), parts_(parts) {}

    void mark(const PartOptions& options)
    {
        MovingParts& moving = parts_.moving;
        if (options.name.empty() || options.name.size() > detail::format::part::kNameBytes)
            fail(options, "has a name of " + std::to_string(options.name.size()) + " bytes; a field holds 1 to 40");
        if (moving.motions.size() == detail::format::kMaxParts)
            fail(options, "is one more than a field holds, " + std::to_string(detail::format::kMaxParts));
        const std::vector<bool> chosen = triangles_named(options.name, file_, parts_);
        for (const NamedPart& part : parts_.named)
            for (size_t t = part.first; t < part.bent_end; ++t)
                if (chosen[t])
                    fail(options,
                         "is bent by a skin, and parts that move are rigid; give a rigid piece an object of its own");
        moving.owners.resize(chosen.size(), 0);
        moving.motions.push_back(motion_of(options));
        for (size_t t = 0; t < chosen.size(); ++t) {
            if (!chosen[t]) continue;
            if (moving.owners[t] != 0) {
                fail(options, "shares triangles with the part '" + moving.motions[moving.owners[t] - 1u].name +
                                  "'; a part cannot lie within another");
            }
            const Material& material = parts_.materials[parts_.mesh.materials[t]];
            if (material.glass || material.thin || material.opacity < 1) {
                fail(options, "lets light pass by its material '" + material.name +
                                  "', and parts that move are opaque; give it another, or let it stand");
            }
            moving.owners[t] = static_cast<uint8_t>(moving.motions.size());
        }
    }

    [[noreturn]] void fail(const PartOptions& options, const std::string& text) const
    {
        throw SceneError(at({file_}, "the part '" + options.name + "' " + text));
    }

private:
    PartMovement motion_of(const PartOptions& options) const
    {
        if (!options.axis) fail(options, "has no axis; write --part " + options.name + ":z, or x, y, or a vector");
        const std::optional<Affine> frame = frame_of(options.name);
        if (!options.slides && !options.pivot && !frame)
            fail(options, "has no pivot, for its file has no nodes; write --part " + options.name + ":z@X,Y,Z");
        PartMovement motion;
        motion.name = options.name;
        motion.slides = options.slides;
        motion.axis = axis_of(options, frame.value_or(kIdentity));
        Vec3d pivot = options.pivot ? *options.pivot : frame ? point_of(*frame, 0, 0, 0) : Vec3d{};
        for (size_t k = 0; k < 3 && (options.pivot || !frame); ++k) pivot[k] -= parts_.origin[k];
        motion.pivot = in_floats(pivot);
        motion.is_limited = options.range.has_value();
        if (options.range) {
            motion.from = (*options.range)[0];
            motion.to = (*options.range)[1];
        }
        if (motion.slides && !motion.is_limited)
            fail(options, "slides without an end; give it 'from' and 'to' in a scene file");
        if (motion.is_limited && !(motion.from < motion.to))
            fail(options, "has no room to move: 'from' is not below 'to'");
        motion.value = options.value;
        motion.lit_at = options.lit_at;
        for (const double value : {motion.value, motion.lit_at.value_or(0)}) {
            if (!motion.is_limited || value == 0 || (value >= motion.from && value <= motion.to)) continue;
            fail(options, "moves from " + number_text(motion.from) + " to " + number_text(motion.to) + ", not to " +
                              number_text(value));
        }
        return motion;
    }

    std::optional<Affine> frame_of(const std::string& name) const
    {
        for (const NamedPart& part : parts_.named)
            if (part.name == name && part.end > part.first) return part.frame;
        return std::nullopt;
    }

    Vec3 axis_of(const PartOptions& options, const Affine& frame) const
    {
        Vec3d axis{};
        for (size_t row = 0; row < 3; ++row)
            for (size_t k = 0; k < 3; ++k) axis[row] += frame[row][k] * (*options.axis)[k];
        const double size = std::hypot(axis[0], axis[1], axis[2]);
        if (!(size > 0) || !std::isfinite(size)) fail(options, "has an axis without a length");
        return in_floats({axis[0] / size, axis[1] / size, axis[2] / size});
    }

    const std::string file_;
    SceneParts& parts_;
};

// A part of the caller that the scene file has, too, only gives it a pose.
std::vector<PartOptions> merged(std::vector<PartOptions> all, const std::vector<PartOptions>& callers)
{
    for (const PartOptions& part : callers) {
        const auto same =
            std::find_if(all.begin(), all.end(), [&](const PartOptions& known) { return known.name == part.name; });
        if (same == all.end() || part.axis)
            all.push_back(part);
        else
            same->value = part.value;
    }
    return all;
}

}  // namespace

std::optional<std::array<double, 3>> axis_named(const std::string& word)
{
    const bool is_turned_round = !word.empty() && word[0] == '-';
    const std::string letter = word.substr(is_turned_round ? 1 : 0);
    if (letter != "x" && letter != "y" && letter != "z") return std::nullopt;
    std::array<double, 3> axis{};
    axis[static_cast<size_t>(letter[0] - 'x')] = is_turned_round ? -1 : 1;
    return axis;
}

namespace
{

// From where its file has it, each part goes to the pose 0.
void take_to_zero(const std::vector<PartOptions>& options, SceneParts& parts)
{
    MovingParts back = parts.moving;
    for (size_t k = 0; k < options.size(); ++k) back.motions[k].value = -options[k].at;
    parts.mesh = back.posed(std::move(parts.mesh));
}

}  // namespace

void set_moving_parts(const std::filesystem::path& file, const std::vector<PartOptions>& options, SceneParts& parts)
{
    const std::vector<PartOptions> all = merged(parts.part_options, options);
    if (all.empty()) return;
    PartMarker marker(file.string(), parts);
    if (parts.volume) marker.fail(all[0], "cannot move in a scene with a volume");
    for (const PartOptions& part : all) marker.mark(part);
    take_to_zero(all, parts);
    const std::vector<uint8_t>& owners = parts.moving.owners;
    if (std::find(owners.begin(), owners.end(), 0) == owners.end())
        marker.fail(all[0], "leaves nothing that stands; let one piece of the scene be no part");
    for (const uint32_t number : parts.mesh.materials) {
        const Material& material = parts.materials[number];
        if (material.glass) {
            marker.fail(all[0], "cannot move in a scene with a body of glass ('" + material.name +
                                    "'), which bends the light of what lies behind it; make thin panes of it");
        }
    }
}

std::unique_ptr<SceneData> with_mesh(const SceneData& scene, Mesh mesh, const std::vector<Material>& more)
{
    SceneParts parts;
    parts.mesh = std::move(mesh);
    parts.materials = scene.materials;
    parts.materials.insert(parts.materials.end(), more.begin(), more.end());
    parts.shared_textures = scene.shared_textures;
    parts.fixtures = scene.fixtures;
    parts.tone = scene.tone;
    parts.sphere = BoundingSphere{{0, 0, 0}, 1};
    parts.exposure = 1;  // all light has it already
    LoadOptions options;
    options.up = UpAxis::z;
    options.environment = exposed(scene.choice.environment, scene.choice.exposure);
    auto result = std::make_unique<SceneData>(std::move(parts), options);
    result->centre = scene.centre;
    result->radius = scene.radius;
    result->up = scene.up;
    result->choice = scene.choice;
    result->views = scene.views;
    result->states = scene.states;
    return result;
}

std::unique_ptr<SceneData> only_of(const SceneData& scene, uint32_t owner)
{
    return with_mesh(scene, part_of(
                                scene.mesh, [&](size_t t) { return scene.moving.owners[t] == owner; }));
}

std::unique_ptr<SceneData> lit_with(const SceneData& scene, uint32_t owner, double value)
{
    MovingParts moving = scene.moving;
    for (PartMovement& movement : moving.motions) movement.value = 0;
    if (owner != 0) moving.motions[owner - 1].value = value;
    return with_mesh(scene, part_of(moving.posed(scene.mesh),
                                    [&](size_t t) { return moving.owners[t] == 0 || moving.owners[t] == owner; }));
}

LitScenes::LitScenes(const SceneData& scene) : scene_(scene)
{
    if (scene_.moving.empty()) return;
    body_ = only_of(scene, 0);
    constexpr size_t kMostTriangles = 6'000'000;  // of all these scenes, about 200 bytes each
    const size_t triangles = scene.mesh.triangle_count() * scene.moving.motions.size();
    const size_t poses = std::clamp<size_t>(kMostTriangles / triangles, 1, kMostLitPoses);
    for (uint32_t owner = 1; owner <= scene.moving.motions.size(); ++owner) {
        const PartMovement& movement = scene.moving.motions[owner - 1];
        parts_.emplace_back();
        for (const double value : movement.lit_poses(poses))
            parts_.back().push_back({lit_with(scene, owner, value), movement.pose(value)});
    }
}

Ray LitPose::posed(const Ray& ray) const
{
    return {moved(pose, ray.origin), direction_of(pose, ray.direction), ray.end};
}

}  // namespace lumi::baker
