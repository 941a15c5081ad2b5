// SPDX-License-Identifier: MIT
#include "scene/light_fields.h"

#include "image/radiance_picture.h"
#include "math/frame.h"
#include "scene/materials.h"
#include "scene/number_ranges.h"

namespace lumi::baker
{
namespace
{

constexpr NumberRange kRadiance = {0, 1e9};

std::array<float, 3> to_array(const Rgb& c)
{
    return {c.r, c.g, c.b};
}

Vec3 required_vector(JsonFields& fields, const char* name)
{
    return fields.vector_of(fields.require(name), name, kPlace);
}

Rgb required_light(JsonFields& fields, const char* name)
{
    const JsonValue& value = fields.require(name);
    const Rgb c = fields.colour_of(value, name, kRadiance);
    if (is_black(c)) {
        fields.fail(value,
                    std::string("'") + name + "' is black, so the light does nothing; raise it or remove the light");
    }
    return c;
}

// The unit vector from `position` to the member 'target'.
Vec3 aim(JsonFields& fields, const Vec3& position)
{
    const Vec3 way = required_vector(fields, "target") - position;
    const float size = length(way);
    if (!(size > 0)) fields.fail(fields.require("target"), "'target' is where the light is; move one of them");
    return way / size;
}

Fixture read_point(JsonFields& fields)
{
    const Vec3 position = required_vector(fields, "position");
    return PointLight{position, required_light(fields, "intensity")};
}

Fixture read_spot(JsonFields& fields)
{
    constexpr NumberRange kHalfAngle = {0.1, 90};
    constexpr float kRadians = kPi / 180;
    const Vec3 position = required_vector(fields, "position");
    const Vec3 axis = aim(fields, position);
    const double outer = fields.number_of(fields.require("angle"), "angle", kHalfAngle);
    double inner = 0.8 * outer;
    fields.number("inner_angle", {0, 90}, inner);
    if (inner >= outer) fields.fail(fields.require("angle"), "'inner_angle' must be smaller than 'angle'; lower it");
    return SpotLight{position, axis, std::cos(static_cast<float>(inner) * kRadians),
                     std::cos(static_cast<float>(outer) * kRadians), required_light(fields, "intensity")};
}

Fixture read_directional(JsonFields& fields)
{
    const Vec3 direction = required_vector(fields, "direction");
    const float size = length(direction);
    if (!(size > 0))
        fields.fail(fields.require("direction"), "'direction' must not be 0; write the way the light goes");
    return DirectionalLight{-direction / size, required_light(fields, "irradiance")};
}

Fixture read_rectangle(JsonFields& fields, UpAxis up)
{
    const Vec3 centre = required_vector(fields, "position");
    const Vec3 facing = aim(fields, centre);
    const JsonValue& size = fields.require("size");
    if (size.kind != JsonValue::Kind::list || size.items.size() != 2)
        fields.fail(size, "'size' of a rectangle must be two numbers; write [width, height]");
    const float width = static_cast<float>(fields.number_of(size.items[0], "size", kLength));
    const float height = static_cast<float>(fields.number_of(size.items[1], "size", kLength));
    // Width lies level; straight up and down any width does.
    const Vec3 vertical = up == UpAxis::y ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    const Vec3 level = cross(vertical, facing);
    constexpr float kUpright = 1e-4f;
    const Vec3 u = length(level) > kUpright ? normalized(level) : Frame(facing).tangent;
    const Vec3 v = cross(facing, u);
    return RectangleLight{centre - u * (width / 2) - v * (height / 2), u * width, v * height,
                          required_light(fields, "radiance")};
}

Fixture read_sphere(JsonFields& fields)
{
    const Vec3 position = required_vector(fields, "position");
    const double radius = fields.number_of(fields.require("radius"), "radius", kLength);
    return SphereLight{position, static_cast<float>(radius), required_light(fields, "radiance")};
}

Environment read_gradient(JsonFields& fields)
{
    Rgb zenith = fields.colour_of(fields.require("zenith"), "zenith", kRadiance);
    Rgb horizon = fields.colour_of(fields.require("horizon"), "horizon", kRadiance);
    Rgb nadir = fields.colour_of(fields.require("nadir"), "nadir", kRadiance);
    return {to_array(zenith), to_array(horizon), to_array(nadir)};
}

Environment read_picture(const std::filesystem::path& file, JsonFields& fields, std::vector<std::string>& warnings)
{
    Environment environment = constant_environment(0);
    const JsonValue& name = fields.require("picture");
    const std::filesystem::path picture = find_beside(file, fields.text_of(name, "picture"));
    if (picture.empty())
        fields.fail(name, "the picture '" + name.text + "' is missing; put it beside " + file.filename().string());
    environment.picture = std::make_shared<RadiancePicture>(read_radiance_picture(picture, warnings));
    fields.number("rotate", kAngle, environment.rotation_degrees);
    return environment;
}

}  // namespace

Fixture read_fixture(const std::string& file, const JsonValue& value, UpAxis up)
{
    JsonFields fields(file, value, "a light");
    static const std::vector<std::string> kTypes = {"point", "spot", "directional", "rectangle", "sphere"};
    fields.require("type");
    const size_t type = fields.choice("type", kTypes, 0);
    const Fixture fixture = type == 0   ? read_point(fields)
                            : type == 1 ? read_spot(fields)
                            : type == 2 ? read_directional(fields)
                            : type == 3 ? read_rectangle(fields, up)
                                        : read_sphere(fields);
    fields.finish();
    return fixture;
}

Environment read_environment(const std::filesystem::path& file, JsonFields& scene, const JsonValue& value,
                             std::vector<std::string>& warnings)
{
    if (value.kind == JsonValue::Kind::text) {
        const size_t named = scene.choice("environment", {"studio", "black"}, 0);
        return named == 0 ? studio_environment() : constant_environment(0);
    }
    if (value.kind != JsonValue::Kind::object)
        return constant_environment(to_array(scene.colour_of(value, "environment", kRadiance)));
    const std::string name = file.string();
    JsonFields fields(name, value, "the environment");
    Environment environment = fields.find("picture") ? read_picture(file, fields, warnings) : read_gradient(fields);
    fields.number("scale", kRadiance, environment.scale);
    fields.finish();
    return environment;
}

}  // namespace lumi::baker
