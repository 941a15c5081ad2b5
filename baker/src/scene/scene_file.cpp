// SPDX-License-Identifier: MIT
#include "scene/scene_file.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string_view>

#include "model/materials.h"
#include "scene/doubts.h"
#include "scene/framing.h"
#include "scene/light_states.h"
#include "scene/model_reader.h"
#include "scene/moving_parts.h"
#include "scene/placement.h"
#include "scene/scene_data.h"
#include "scene/scene_members.h"
#include "util/json_text.h"
#include "util/text_lines.h"
#include "volume/volume_file.h"

namespace lumi::baker
{

namespace
{

// In the volume's own place. Throws SceneError.
SceneParts read_iso_object(const std::filesystem::path& scene_file, JsonMembers& members)
{
    const JsonValue& volume = members.require("volume");
    const std::filesystem::path path = find_beside(scene_file, members.text_of(volume, "volume"));
    if (path.empty()) {
        members.fail(volume,
                     "the volume '" + volume.text + "' is missing; put it beside " + scene_file.filename().string());
    }
    IsoSurface surface;
    surface.value = static_cast<float>(members.number_of(members.require("iso"), "iso", kScalar));
    members.number("pieces", kShare, surface.pieces);
    SceneParts parts = read_iso_surface(path, surface);
    if (const JsonValue* changes = members.find("material"))
        apply_material_members(scene_file.string(), *changes, parts.materials[0]);
    return parts;
}

constexpr NumberRange kPoses = {-3600, 3600};  // degrees

class SceneFileReader
{
public:
    SceneFileReader(const std::filesystem::path& file, const JsonValue& root, std::vector<std::string>& warnings,
                    ColourScale colours)
        : file_(file), name_(file.string()), scene_(name_, root, "the scene"), warnings_(warnings), colours_(colours)
    {
    }

    SceneParts read(std::optional<UpAxis> up)
    {
        up_ = scene_.choice("up", {"y", "z"}, 0) == 0 ? UpAxis::y : UpAxis::z;
        up_ = up.value_or(up_);
        read_volume();
        if (!parts_.volume || scene_.find("objects"))
            for (const JsonValue& object : list_of(scene_.require("objects"), "objects")) read_object(object);
        read_materials();
        read_ground();
        read_lights();
        read_picture();
        read_sphere();
        read_moving_parts();
        scene_.finish();
        parts_.up = up_;
        return std::move(parts_);
    }

private:
    const std::vector<JsonValue>& list_of(const JsonValue& value, const std::string& name) const
    {
        if (value.kind != JsonValue::Kind::list) scene_.fail(value, "'" + name + "' must be a list; write [ ... ]");
        return value.items;
    }

    void read_object(const JsonValue& value)
    {
        JsonMembers members(name_, value, "an object");
        const Placement placement = read_placement(members);
        SceneParts parts = members.find("volume") ? read_iso_object(file_, members) : read_model_object(members);
        members.finish();
        place(placement, parts);
        append(parts_, std::move(parts));
    }

    SceneParts read_model_object(JsonMembers& members)
    {
        const JsonValue& obj = members.require("obj");
        const std::filesystem::path path = find_beside(file_, members.text_of(obj, "obj"));
        if (path.empty())
            members.fail(obj, "the object '" + obj.text + "' is missing; put it beside " + file_.filename().string());
        ModelOptions options{colours_};
        if (const JsonValue* animation = members.find("animation")) {
            options.animation = animation_time(members.text_of(*animation, "animation"));
            if (!options.animation) members.fail(*animation, "'animation' must be like \"NAME@1.5\", in seconds");
        }
        SceneParts parts = read_model(path, warnings_, options);
        if (!parts.fixtures.empty()) {
            warnings_.push_back(at({name_, obj.line}, "the lamps of '" + obj.text + "' (" +
                                                          std::to_string(parts.fixtures.size()) +
                                                          ") are left out; write them among 'lights'"));
        }
        return parts;
    }

    void read_volume()
    {
        if (const JsonValue* value = scene_.find("volume")) parts_.volume = baker::read_volume(file_, *value);
    }

    void read_materials()
    {
        const JsonValue* value = scene_.find("materials");
        if (!value) return;
        JsonMembers(name_, *value, "'materials'");
        std::multimap<std::string_view, Material*> by_name;
        for (Material& material : parts_.materials) by_name.emplace(material.name, &material);
        for (const auto& [material_name, changes] : value->members) {
            const auto [first, last] = by_name.equal_range(material_name);
            for (auto found = first; found != last; ++found) apply_material_members(name_, changes, *found->second);
            if (first == last)
                scene_.fail(changes, "no object has a material '" + material_name + "'; choose among: " + names());
        }
    }

    std::string names() const
    {
        std::string text;
        for (const Material& material : parts_.materials)
            text += (text.empty() ? "" : ", ") + (material.name.empty() ? "(nameless)" : material.name);
        return text;
    }

    void read_ground()
    {
        const JsonValue* value = scene_.find("ground");
        if (!value) return;
        JsonMembers members(name_, *value, "the ground");
        const Disc disc = read_disc(members);
        Material material;
        material.name = "ground";
        material.finish();
        if (const JsonValue* changes = members.find("material")) apply_material_members(name_, *changes, material);
        members.finish();
        append_disc(parts_, disc, up_, material);
    }

    // Under the lowest point of objects and volume, unless told otherwise.
    Disc read_disc(JsonMembers& members) const
    {
        Disc disc = {};
        float& height = up_ == UpAxis::y ? disc.centre.y : disc.centre.z;
        height = std::numeric_limits<float>::infinity();
        for (const Mesh::Corners& corners : parts_.mesh.corners) {
            for (const uint32_t c : corners) {
                const Vec3& p = parts_.mesh.positions[c];
                height = std::min(height, up_ == UpAxis::y ? p.y : p.z);
            }
        }
        for (const Vec3& p : parts_.volume ? corners_of(*parts_.volume) : std::vector<Vec3>())
            height = std::min(height, up_ == UpAxis::y ? p.y : p.z);
        members.number("height", kPlace, height);
        disc.radius = static_cast<float>(members.number_of(members.require("radius"), "radius", kLength));
        return disc;
    }

    void read_lights()
    {
        if (const JsonValue* value = scene_.find("environment"))
            parts_.environment = read_environment(file_, scene_, *value, warnings_, parts_.sky_state);
        parts_.has_labels = true;
        if (const JsonValue* value = scene_.find("lights")) {
            for (const JsonValue& light : list_of(*value, "lights")) {
                parts_.fixture_names.emplace_back();
                parts_.fixtures.push_back(read_fixture(name_, light, up_, parts_.fixture_names.back()));
            }
        }
    }

    void read_picture()
    {
        if (scene_.find("exposure")) {
            double stops = 0;
            scene_.number("exposure", {-kMostStops, kMostStops}, stops);
            parts_.exposure = static_cast<float>(std::exp2(stops));
        }
        parts_.tone = static_cast<ToneCurve>(scene_.choice("tone", {"srgb", "reinhard", "aces", "agx"}, 0));
    }

    void read_sphere()
    {
        const JsonValue* value = scene_.find("sphere");
        if (!value) return;
        JsonMembers members(name_, *value, "the sphere");
        const Vec3 c = members.vector_of(members.require("centre"), "centre", kPlace);
        const double radius = members.number_of(members.require("radius"), "radius", kLength);
        members.finish();
        parts_.sphere =
            BoundingSphere{{static_cast<double>(c.x), static_cast<double>(c.y), static_cast<double>(c.z)}, radius};
    }

    void read_moving_parts()
    {
        const JsonValue* value = scene_.find("parts");
        if (!value) return;
        for (const JsonValue& part : list_of(*value, "parts")) parts_.part_options.push_back(read_part(part));
    }

    PartOptions read_part(const JsonValue& value) const
    {
        JsonMembers members(name_, value, "a part");
        PartOptions part;
        part.name = members.text("name");
        const JsonValue *turn = members.find("turn"), *slide = members.find("slide");
        if ((turn == nullptr) == (slide == nullptr))
            members.fail(value, "a part has a 'turn' or a 'slide': the axis, as \"z\" or [0, 0, 1]");
        part.slides = slide != nullptr;
        part.axis = axis_of(members, part.slides ? *slide : *turn, part.slides ? "slide" : "turn");
        if (const JsonValue* pivot = members.find("pivot"))
            part.pivot = in_doubles(members.vector_of(*pivot, "pivot", kPlace));
        members.number("at", part.slides ? kPlace : kPoses, part.at);
        if (const JsonValue* lit_at = members.find("lit_at"))
            part.lit_at = members.number_of(*lit_at, "lit_at", part.slides ? kPlace : kPoses);
        if (members.find("from") || members.find("to")) {
            const NumberRange range = part.slides ? kPlace : kPoses;
            part.range = {members.number_of(members.require("from"), "from", range),
                          members.number_of(members.require("to"), "to", range)};
        }
        members.finish();
        return part;
    }

    static std::array<double, 3> axis_of(const JsonMembers& members, const JsonValue& value, const std::string& name)
    {
        if (value.kind != JsonValue::Kind::text) return in_doubles(members.vector_of(value, name, kPlace));
        const std::optional<std::array<double, 3>> axis = axis_named(value.text);
        if (!axis) members.fail(value, "'" + name + "' must be \"x\", \"y\", \"z\" or three numbers");
        return *axis;
    }

    const std::filesystem::path& file_;
    std::string name_;
    JsonMembers scene_;
    std::vector<std::string>& warnings_;
    const ColourScale colours_;
    UpAxis up_ = UpAxis::y;
    SceneParts parts_;
};

}  // namespace

SceneParts read_scene_file(const std::filesystem::path& file, std::optional<UpAxis> up,
                           std::vector<std::string>& warnings, ColourScale colours)
{
    const std::string name = file.string();
    const JsonValue root = parse_json(name, read_text(file));
    return SceneFileReader(file, root, warnings, colours).read(up);
}

namespace
{

SceneParts read_volume_file(const std::filesystem::path& file, const std::optional<IsoSurface>& iso)
{
    if (!iso) {
        throw SceneError(at({file.string()},
                            "a volume becomes a scene by the surface of one value; say which with --iso, "
                            "from " +
                                range_of_volume(file)));
    }
    return read_iso_surface(file, *iso);
}

SceneParts read_parts(const std::filesystem::path& file, const LoadOptions& options, std::vector<std::string>& warnings)
{
    if (is_volume_file(file)) return read_volume_file(file, options.iso);
    refuse_foreign_volume(file);
    if (options.iso) {
        throw SceneError(at({file.string()},
                            "this is no volume, and only volumes have iso-surfaces; leave out --iso, or "
                            "name a .nii, .nii.gz or .vdb file"));
    }
    if (file.extension() != ".json") return read_model(file, warnings, {options.colours, options.animation});
    if (options.animation) {
        throw SceneError(at({file.string()},
                            "the objects of a scene file have animations each; leave out --animation, and "
                            "write \"animation\": \"NAME@SECONDS\" beside \"obj\""));
    }
    return read_scene_file(file, options.up, warnings, options.colours);
}

// Lit with what the options say, where they say it.
Scene with_weights(Scene scene, const std::vector<StateOption>& options)
{
    const std::vector<std::string>& names = scene.data().states.names;
    std::vector<Rgb> weights(names.size(), grey(1));
    bool are_full = true;
    for (const StateOption& option : options) {
        const Rgb weight = {option.weight[0], option.weight[1], option.weight[2]};
        const auto found = std::find(names.begin(), names.end(), option.name);
        if (found == names.end()) continue;  // base, where no other state is
        weights[static_cast<size_t>(found - names.begin())] = weight;
        are_full = are_full && option.weight == StateOption{}.weight;
    }
    return are_full ? std::move(scene) : Scene(lit_by(scene.data(), weights));
}

}  // namespace

Scene load_scene(const std::filesystem::path& file, const LoadOptions& options, std::vector<std::string>& warnings)
{
    SceneParts parts = read_parts(file, options, warnings);
    if (!options.frame.empty()) frame_part(file, options.frame, parts);
    set_moving_parts(file, options.parts, parts);
    set_light_states(file, options.states, parts);
    set_tints(file, options, parts);
    const std::array<double, 3> origin = parts.origin;
    Scene scene = [&] {
        try {
            return build_scene(std::move(parts), options);
        } catch (const SceneError& error) {
            throw SceneError(at({file.string()}, error.what()));
        }
    }();
    scene = with_weights(std::move(scene), options.states);
    for (const std::string& warning : scene.data().choice.warnings) warnings.push_back(at({file.string()}, warning));
    report_doubts(scene.data(), origin, file, warnings);
    return scene;
}

}  // namespace lumi::baker
