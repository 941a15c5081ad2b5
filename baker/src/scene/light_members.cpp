// SPDX-License-Identifier: MIT
#include "scene/scene_members.h"

#include "image/radiance_picture.h"
#include "math/vec3.h"
#include "model/materials.h"

namespace lumi::baker
{
namespace
{

constexpr NumberRange kRadiance = {0, 1e9};

std::array<float, 3> to_array(const Rgb& c)
{
    return {c.r, c.g, c.b};
}

Vec3 required_vector(JsonMembers& members, const char* name)
{
    return members.vector_of(members.require(name), name, kPlace);
}

Rgb required_light(JsonMembers& members, const char* name)
{
    const JsonValue& value = members.require(name);
    const Rgb c = members.colour_of(value, name, kRadiance);
    if (is_black(c)) {
        members.fail(value,
                     std::string("'") + name + "' is black, so the light does nothing; raise it or remove the light");
    }
    return c;
}

// The unit vector from `position` to the member 'target'.
Vec3 aim(JsonMembers& members, const Vec3& position)
{
    const Vec3 way = required_vector(members, "target") - position;
    const float size = length(way);
    if (!(size > 0)) members.fail(members.require("target"), "'target' is where the light is; move one of them");
    return way / size;
}

Fixture read_point(JsonMembers& members)
{
    const Vec3 position = required_vector(members, "position");
    return PointLight{position, required_light(members, "intensity")};
}

Fixture read_spot(JsonMembers& members)
{
    constexpr NumberRange kHalfAngle = {0.1, 90};
    constexpr float kRadians = kPi / 180;
    const Vec3 position = required_vector(members, "position");
    const Vec3 axis = aim(members, position);
    const double outer = members.number_of(members.require("angle"), "angle", kHalfAngle);
    double inner = 0.8 * outer;
    members.number("inner_angle", {0, 90}, inner);
    if (inner >= outer) members.fail(members.require("angle"), "'inner_angle' must be smaller than 'angle'; lower it");
    return SpotLight{position, axis, std::cos(static_cast<float>(inner) * kRadians),
                     std::cos(static_cast<float>(outer) * kRadians), required_light(members, "intensity")};
}

Fixture read_directional(JsonMembers& members)
{
    const Vec3 direction = required_vector(members, "direction");
    const float size = length(direction);
    if (!(size > 0))
        members.fail(members.require("direction"), "'direction' must not be 0; write the way the light goes");
    return DirectionalLight{-direction / size, required_light(members, "irradiance")};
}

Fixture read_rectangle(JsonMembers& members, UpAxis up)
{
    const Vec3 centre = required_vector(members, "position");
    const Vec3 facing = aim(members, centre);
    const JsonValue& size = members.require("size");
    if (size.kind != JsonValue::Kind::list || size.items.size() != 2)
        members.fail(size, "'size' of a rectangle must be two numbers; write [width, height]");
    const float width = static_cast<float>(members.number_of(size.items[0], "size", kLength));
    const float height = static_cast<float>(members.number_of(size.items[1], "size", kLength));
    // Width lies level; straight up and down any width does.
    const Vec3 vertical = up == UpAxis::y ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    const Vec3 level = cross(vertical, facing);
    constexpr float kUpright = 1e-4f;
    const Vec3 u = length(level) > kUpright ? normalized(level) : Frame(facing).tangent;
    const Vec3 v = cross(facing, u);
    return RectangleLight{centre - u * (width / 2) - v * (height / 2), u * width, v * height,
                          required_light(members, "radiance")};
}

Fixture read_sphere(JsonMembers& members)
{
    const Vec3 position = required_vector(members, "position");
    const double radius = members.number_of(members.require("radius"), "radius", kLength);
    return SphereLight{position, static_cast<float>(radius), required_light(members, "radiance")};
}

Environment read_gradient(JsonMembers& members)
{
    Rgb zenith = members.colour_of(members.require("zenith"), "zenith", kRadiance);
    Rgb horizon = members.colour_of(members.require("horizon"), "horizon", kRadiance);
    Rgb nadir = members.colour_of(members.require("nadir"), "nadir", kRadiance);
    return {to_array(zenith), to_array(horizon), to_array(nadir)};
}

Environment read_named(JsonMembers& members)
{
    Environment environment = *named_environment(kSkyNames[members.choice("sky", kSkyNames, 0)]);
    members.number("rotate", kAngle, environment.rotation_degrees);
    return environment;
}

Environment read_picture(const std::filesystem::path& file, JsonMembers& members, std::vector<std::string>& warnings)
{
    const JsonValue& name = members.require("picture");
    const std::filesystem::path picture = find_beside(file, members.text_of(name, "picture"));
    if (picture.empty())
        members.fail(name, "the picture '" + name.text + "' is missing; put it beside " + file.filename().string());
    Environment environment = picture_environment(picture, warnings);
    members.number("rotate", kAngle, environment.rotation_degrees);
    return environment;
}

}  // namespace

Environment picture_environment(const std::filesystem::path& file, std::vector<std::string>& warnings)
{
    Environment environment = constant_environment(0);
    environment.picture = std::make_shared<RadiancePicture>(read_radiance_picture(file, warnings));
    return environment;
}

void take_state(JsonMembers& members, std::string& state)
{
    const JsonValue* label = members.find("state");
    if (label == nullptr) return;
    state = members.text_of(*label, "state");
    if (state.empty()) members.fail(*label, "'state' is empty; write the name of a light state");
}

Fixture read_fixture(const std::string& file, const JsonValue& value, UpAxis up, std::string& state)
{
    JsonMembers members(file, value, "a light");
    static const std::vector<std::string> kTypes = {"point", "spot", "directional", "rectangle", "sphere"};
    members.require("type");
    const size_t type = members.choice("type", kTypes, 0);
    const Fixture fixture = type == 0   ? read_point(members)
                            : type == 1 ? read_spot(members)
                            : type == 2 ? read_directional(members)
                            : type == 3 ? read_rectangle(members, up)
                                        : read_sphere(members);
    take_state(members, state);
    members.finish();
    return fixture;
}

Environment read_environment(const std::filesystem::path& file, JsonMembers& scene, const JsonValue& value,
                             std::vector<std::string>& warnings, std::string& state)
{
    if (value.kind == JsonValue::Kind::text)
        return *named_environment(kSkyNames[scene.choice("environment", kSkyNames, 0)]);
    if (value.kind != JsonValue::Kind::object)
        return constant_environment(to_array(scene.colour_of(value, "environment", kRadiance)));
    const std::string name = file.string();
    JsonMembers members(name, value, "the environment");
    Environment environment = members.find("sky")       ? read_named(members)
                              : members.find("picture") ? read_picture(file, members, warnings)
                                                        : read_gradient(members);
    members.number("scale", kRadiance, environment.scale);
    take_state(members, state);
    members.finish();
    return environment;
}

}  // namespace lumi::baker
