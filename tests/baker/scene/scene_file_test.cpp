// SPDX-License-Identifier: MIT
// Scene files: what each member does, and that every fault is named with its line and its mend.
#include "scene/scene_file.h"

#include <catch2/catch.hpp>

#include "scene/scene_data.h"
#include "support/picture_bytes.h"
#include "support/scratch_folder.h"

namespace lumi::baker
{
namespace
{

using testing::ScratchFolder;

constexpr char kObject[] =
    "mtllib m.mtl\nusemtl paint\nv 0 0 0\nv 1 0 0\nv 1 0 -1\nvn 0 1 0\nf 1//1 2//1 3//1\nusemtl pane\nf 1 2 3\n";
constexpr char kMaterials[] = "newmtl paint\nKd 0.5 0.5 0.5\nnewmtl pane\nKd 0.1 0.1 0.1\n";

void write_object(const ScratchFolder& folder)
{
    folder.write("o.obj", kObject);
    folder.write("m.mtl", kMaterials);
}

SceneParts read(const std::string& json, std::vector<std::string>* warnings = nullptr)
{
    const ScratchFolder folder;
    write_object(folder);
    std::vector<std::string> lines;
    SceneParts parts = read_scene_file(folder.write("s.json", json), std::nullopt, lines);
    if (warnings) *warnings = lines;
    return parts;
}

// `rest` follows the objects.
SceneParts with(const std::string& rest)
{
    return read("{\"objects\": [{\"obj\": \"o.obj\"}],\n" + rest + "}");
}

void check_scene_refused(const std::string& json, const std::string& line, const std::string& what)
{
    INFO(json);
    CHECK_THROWS_WITH(read(json),
                      Catch::Contains("s.json:" + line + ": ") && Catch::Contains(what) && Catch::Contains("; "));
}

void check_member_refused(const std::string& rest, const std::string& what)
{
    check_scene_refused("{\"objects\": [{\"obj\": \"o.obj\"}],\n" + rest + "}", "2", what);
}

template <class Light>
Light only_light(const std::string& json)
{
    const SceneParts parts = with("\"lights\": [" + json + "]");
    REQUIRE(parts.fixtures.size() == 1);
    REQUIRE(std::holds_alternative<Light>(parts.fixtures[0]));
    return std::get<Light>(parts.fixtures[0]);
}

void check_vector(const Vec3& v, double x, double y, double z)
{
    INFO(v.x << " " << v.y << " " << v.z);
    CHECK(static_cast<double>(v.x) == Approx(x).margin(1e-5));
    CHECK(static_cast<double>(v.y) == Approx(y).margin(1e-5));
    CHECK(static_cast<double>(v.z) == Approx(z).margin(1e-5));
}

}  // namespace

TEST_CASE("scene file: objects are scaled, turned and moved, in this order, and joined")
{
    const SceneParts parts = read(R"({
      // a comment
      "objects": [
        {"obj": "o.obj", "scale": 2, "rotate": [0, 90, 0], "translate": [0, 5, 0]},
        {"obj": "o.obj", "scale": [1, 1, -1]} /* mirrored */
      ]})");
    CHECK(parts.mesh.triangle_count() == 4);
    CHECK(parts.materials.size() == 4);
    check_vector(parts.mesh.position(0, 1), 0, 5, -2);
    check_vector(parts.mesh.position(0, 2), -2, 5, -2);
    check_vector(parts.mesh.area_vector(0), 0, 4, 0);
    // A mirror image still shows its upper side.
    check_vector(parts.mesh.area_vector(2), 0, 1, 0);
    CHECK(parts.mesh.materials[2] == 2);
    CHECK(parts.mesh.shading[2][0] == 1);
    CHECK(parts.mesh.shading[3][0] == kNoIndex);
}

TEST_CASE("scene file: each of two objects keeps its own pictures, whatever they are for")
{
    const ScratchFolder folder;
    const std::string maps =
        "Kd 1 1 1\nPr 0.5\nPm 0.5\nPs 0.5\nKe 1 1 1\nmap_Kd t.png\nmap_Ke t.png\nmap_Pr t.png\nmap_Pm t.png\nmap_Ps "
        "t.png\n"
        "map_d t.png\nnorm t.png\n";
    folder.write("t.png", testing::rgb_png(2, {0, 0, 0, 255, 255, 255}));
    folder.write("m.mtl", "newmtl x\n" + maps);
    folder.write("o.obj",
                 "mtllib m.mtl\nusemtl x\nv 0 0 0\nv 1 0 0\nv 1 0 -1\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\n");
    std::vector<std::string> warnings;
    const SceneParts parts = read_scene_file(
        folder.write("s.json", R"({"objects": [{"obj": "o.obj"}, {"obj": "o.obj"}]})"), std::nullopt, warnings);
    REQUIRE(parts.materials.size() == 2);
    const auto pictures = static_cast<int32_t>(parts.textures.size()) / 2;
    for (const auto slot : kTextureSlots) {
        if (slot == &TextureSlots::transmission) continue;  // MTL has no picture for it
        CHECK((parts.materials[0].maps.*slot).used());
        CHECK((parts.materials[1].maps.*slot).texture == (parts.materials[0].maps.*slot).texture + pictures);
    }
}

TEST_CASE("scene file: lights are read in the units and axes of the scene")
{
    const auto point = only_light<PointLight>(R"({"type": "point", "position": [1, 2, 3], "intensity": [4, 5, 6]})");
    check_vector(point.position, 1, 2, 3);
    CHECK(point.intensity.b == 6);
    const auto spot = only_light<SpotLight>(
        R"({"type": "spot", "position": [0, 2, 0], "target": [0, 0, 0], "angle": 60, "inner_angle": 0, "intensity": 1})");
    check_vector(spot.axis, 0, -1, 0);
    CHECK(static_cast<double>(spot.cos_outer) == Approx(0.5));
    const auto sun =
        only_light<DirectionalLight>(R"({"type": "directional", "direction": [0, -2, 0], "irradiance": 3})");
    check_vector(sun.towards, 0, 1, 0);
    const auto sphere =
        only_light<SphereLight>(R"({"type": "sphere", "position": [0, 1, 0], "radius": 0.5, "radiance": 2})");
    CHECK(sphere.radius == 0.5f);
    const auto panel = only_light<RectangleLight>(
        R"({"type": "rectangle", "position": [0, 3, 4], "target": [0, 3, 0], "size": [2, 1], "radiance": 2})");
    check_vector(panel.corner + (panel.side_u + panel.side_v) * 0.5f, 0, 3, 4);
    check_vector(cross(panel.side_u, panel.side_v), 0, 0, -2);
    CHECK(static_cast<double>(panel.side_u.y) == Approx(0).margin(1e-6));
    const auto lamp = only_light<RectangleLight>(
        R"({"type": "rectangle", "position": [0, 3, 0], "target": [0, 0, 0], "size": [2, 1], "radiance": 2})");
    check_vector(cross(lamp.side_u, lamp.side_v), 0, -2, 0);
}

TEST_CASE("scene file: environment, exposure, tone, axis and sphere")
{
    CHECK_FALSE(with("\"up\": \"z\"").environment);
    CHECK(with("\"up\": \"z\"").up == UpAxis::z);
    CHECK(with("\"environment\": \"black\"").environment->zenith[0] == 0);
    CHECK(with("\"environment\": [1, 2, 3]").environment->nadir[2] == 3);
    const SceneParts gradient =
        with(R"("environment": {"zenith": 1, "horizon": 0.5, "nadir": [0, 0, 0.25], "scale": 2})");
    CHECK(gradient.environment->nadir[2] == 0.25f);
    CHECK(gradient.environment->scale == 2);
    const SceneParts rest = with(R"("exposure": -1, "tone": "aces", "sphere": {"centre": [1, 2, 3], "radius": 9})");
    CHECK(rest.exposure == 0.5f);
    CHECK(rest.tone == ToneCurve::aces);
    CHECK(rest.sphere->radius == 9);
}

TEST_CASE("scene file: materials override what MTL says")
{
    const SceneParts parts = with(R"("materials": {
      "paint": {"metal": "gold", "roughness": 0.5, "coat": 0.75, "coat_roughness": 0.2},
      "pane": {"glass": {"transmittance": [0.5, 1, 1], "at": 2}, "index": 1.33}})");
    const Material& gold = parts.materials[0];
    CHECK(gold.metalness == 1);
    CHECK(static_cast<double>(gold.base.g) == Approx(0.782));
    CHECK(static_cast<double>(gold.alpha) == Approx(0.25));
    CHECK(static_cast<double>(gold.coat_alpha) == Approx(0.04));
    CHECK(gold.coat_skin);
    const Material& pane = parts.materials[1];
    CHECK(pane.glass);
    CHECK_FALSE(pane.frosts.at(0));
    CHECK(static_cast<double>(pane.index) == Approx(1.33));
    CHECK(static_cast<double>(pane.absorbed(4).r) == Approx(0.25));
}

TEST_CASE("scene file: anisotropy turns by degrees, and a colour of sheen alone asks for all of it")
{
    const SceneParts parts = with(R"("materials": {
      "paint": {"metal": "iron", "roughness": 0.5, "anisotropy": 0.75, "anisotropy_rotation": 90},
      "pane": {"sheen_colour": [1, 0.5, 0.25], "sheen_roughness": 0.1}})");
    const Material& iron = parts.materials[0];
    CHECK(iron.brushed());
    CHECK(iron.anisotropy == 0.75f);
    CHECK(iron.anisotropy_turns == 0.25f);
    CHECK_FALSE(iron.fibres);
    const Material& felt = parts.materials[1];
    CHECK(felt.sheen == 1);
    CHECK(felt.sheen_colour.b == 0.25f);
    CHECK(felt.sheen_roughness == 0.1f);
    CHECK(with(R"("materials": {"pane": {"sheen_colour": 1, "sheen": 0.5}})").materials[1].sheen == 0.5f);
}

TEST_CASE("scene file: the ground lies under the lowest point")
{
    const SceneParts parts = with(R"("ground": {"radius": 3, "material": {"colour": 0.25}})");
    CHECK(parts.mesh.triangle_count() > 100);
    const size_t last = parts.mesh.triangle_count() - 1;
    CHECK(static_cast<double>(parts.mesh.position(last, 1).y) == Approx(0).margin(1e-6));
    CHECK(parts.mesh.area_vector(last).y > 0);
    CHECK(parts.materials[parts.mesh.materials[last]].base.r == 0.25f);
    const SceneParts z = with(R"("up": "z", "ground": {"radius": 3, "height": -2})");
    CHECK(z.mesh.position(last, 1).z == -2);
    CHECK(z.mesh.area_vector(last).z > 0);
}

TEST_CASE("scene file: a whole file loads, and the command line's wishes count more")
{
    const ScratchFolder folder;
    write_object(folder);
    const std::filesystem::path file =
        folder.write("s.json", R"({"objects": [{"obj": "o.obj"}], "up": "z", "exposure": 1, "environment": 3,
                      "lights": [{"type": "point", "position": [0, 9, 0], "intensity": 8}],
                      "sphere": {"centre": [0, 0, 0], "radius": 2}})");
    std::vector<std::string> warnings;
    const Scene scene = load_scene(file, {}, warnings);
    CHECK(scene.up() == UpAxis::z);
    CHECK(scene.radius() == 2);
    CHECK(scene.light_count() == 1);
    CHECK(static_cast<double>(scene.data().lights.sky({1, 0, 0}).radiance.r) == Approx(6));
    LoadOptions options;
    options.up = UpAxis::y;
    options.environment = constant_environment(0);
    const Scene other = load_scene(file, options, warnings);
    CHECK(other.up() == UpAxis::y);
    CHECK(other.data().lights.sky({1, 0, 0}).radiance.r == 0);
    REQUIRE(warnings.size() == 2);  // the object's two faces lie in one place, which is told at each load
    for (const std::string& warning : warnings) CHECK_THAT(warning, Catch::Contains("1 face(s) coincide"));
}

TEST_CASE("scene file: what is no JSON is refused with its line")
{
    check_scene_refused("", "1", "this is no JSON");
    check_scene_refused("[", "1", "this is no JSON");
    check_scene_refused("{\n\"objects\": [}\n", "2", "this is no JSON");
    check_scene_refused("{\"objects\":\n[{\"obj\" \"o.obj\"}]}", "2", "this is no JSON");
    check_scene_refused("{\"objects\": []\n\n", "2", "this is no JSON");
    check_scene_refused("{\"exposure\":\n1e999}", "2", "this is no JSON");
    check_scene_refused("{\"exposure\": 1,\n\"exposure\": 1}", "2", "'exposure' is given twice");
    check_scene_refused(std::string(100, '['), "1", "nest too deeply");
    check_scene_refused("3", "1", "must be an object");
    check_scene_refused("{}", "1", "no 'objects'");
}

TEST_CASE("scene file: members that cannot be are refused with their line")
{
    check_member_refused("\"colour\": 1", "knows no 'colour'");
    check_member_refused("\"up\": \"x\"", "'up' of the scene is 'x'; choose one of: y, z");
    check_member_refused("\"tone\": 3", "'tone' of the scene must be a text");
    check_member_refused("\"exposure\": \"1\"", "must be a number");
    check_member_refused("\"exposure\": 99", "choose it from -20 to 20");
    check_member_refused("\"environment\": -1", "choose it from 0");
    check_member_refused("\"environment\": \"sunny\"", "choose one of: studio, gradient, overcast, evening, black");
    check_member_refused("\"environment\": {\"sky\": \"night\"}", "choose one of: studio, gradient, overcast");
    check_member_refused("\"environment\": [1, 2]", "must be a colour");
    check_member_refused("\"environment\": {\"zenith\": 1}", "has no 'horizon'");
    check_member_refused("\"environment\": {\"picture\": \"no.hdr\"}", "the picture 'no.hdr' is missing");
    check_member_refused("\"ground\": {}", "the ground has no 'radius'");
    check_member_refused("\"sphere\": {\"centre\": [0, 0, 0], \"radius\": 0}", "'radius' of the sphere is 0");
    check_member_refused("\"materials\": {\"gold\": {}}", "no object has a material 'gold'; choose among: paint, pane");
    check_member_refused("\"materials\": {\"paint\": {\"metal\": \"tin\"}}", "choose one of: aluminium");
    check_member_refused("\"materials\": {\"paint\": {\"roughness\": 2}}", "choose it from 0 to 1");
    check_member_refused("\"materials\": {\"paint\": {\"anisotropy\": 1.5}}", "choose it from 0 to 1");
    check_member_refused("\"materials\": {\"paint\": {\"anisotropy_rotation\": 361}}", "choose it from -360 to 360");
    check_member_refused("\"materials\": {\"paint\": {\"sheen\": -0.5}}", "choose it from 0 to 1");
    check_member_refused("\"materials\": {\"paint\": {\"sheen_colour\": [1, 2, 1]}}", "choose it from 0 to 1");
    check_member_refused("\"materials\": {\"paint\": {\"sheen_roughness\": 0.05}}", "choose it from 0.1 to 1");
    check_member_refused("\"lights\": {}", "'lights' must be a list");
    check_scene_refused("{\"objects\": [{\n\"obj\": \"no.obj\"}]}", "2", "the object 'no.obj' is missing");
    check_scene_refused("{\"objects\": [{\"obj\": \"o.obj\",\n\"scale\": 0}]}", "2", "'scale' flattens the object");
    check_scene_refused("{\"objects\": [{\"obj\": \"o.obj\",\n\"rotate\": [1, 2]}]}", "2", "must be three numbers");
}

TEST_CASE("scene file: lights that cannot shine are refused with their line")
{
    const auto check_light = [](const std::string& light, const std::string& what) {
        check_member_refused("\"lights\": [" + light + "]", what);
    };
    check_light("{}", "a light has no 'type'");
    check_light(R"({"type": "bulb"})", "choose one of: point, spot");
    check_light(R"({"type": "point", "position": [0, 0, 0], "intensity": 0})", "is black");
    check_light(R"({"type": "point", "position": [0, 0, 0]})", "a light has no 'intensity'");
    check_light(R"({"type": "sphere", "position": [0, 0, 0], "radius": 0, "radiance": 1})", "'radius' of a light is 0");
    check_light(R"({"type": "directional", "direction": [0, 0, 0], "irradiance": 1})", "'direction' must not be 0");
    check_light(R"({"type": "spot", "position": [0, 1, 0], "target": [0, 1, 0], "angle": 9, "intensity": 1})",
                "'target' is where the light is");
    check_light(
        R"({"type": "spot", "position": [0, 1, 0], "target": [0, 0, 0], "angle": 9, "inner_angle": 9, "intensity": 1})",
        "'inner_angle' must be smaller");
    check_light(R"({"type": "rectangle", "position": [0, 1, 0], "target": [0, 0, 0], "size": 3, "radiance": 1})",
                "two numbers");
    check_light(R"({"type": "point", "position": [0, 0, 0], "radiance": 1, "intensity": 1})", "knows no 'radiance'");
}

TEST_CASE("scene file: faults beyond the text are named too")
{
    const ScratchFolder folder;
    write_object(folder);
    std::vector<std::string> warnings;
    const auto load = [&](const std::string& rest) {
        return load_scene(folder.write("s.json", "{\"objects\": [{\"obj\": \"o.obj\"}],\n" + rest + "}"), {}, warnings);
    };
    CHECK_THROWS_WITH(load(R"("sphere": {"centre": [0, 0, 0], "radius": 1})"), Catch::Contains("give a larger radius"));
    folder.write("bad.hdr", "rubbish");
    CHECK_THROWS_WITH(load(R"("environment": {"picture": "bad.hdr"})"),
                      Catch::Contains("bad.hdr: this is neither a Radiance .hdr nor an OpenEXR picture; save"));
    folder.write("empty.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 0 +X 1\n");
    CHECK_THROWS_WITH(load(R"("environment": {"picture": "empty.hdr"})"), Catch::Contains("has no pixels"));
    folder.write("bad.exr", std::string("\x76\x2f\x31\x01\x02\0\0\0", 8) + "rubbish");
    CHECK_THROWS_WITH(load(R"("environment": {"picture": "bad.exr"})"),
                      Catch::Contains("bad.exr: the picture cannot be read") && Catch::Contains("; save"));
    CHECK_THROWS_WITH(load_scene("/dev/zero", {}, warnings), Catch::Contains("a device or a pipe; name a file"));
    CHECK_THROWS_WITH(load_scene(folder.at("no.json"), {}, warnings), Catch::Contains("cannot be opened"));
    std::filesystem::create_symlink("loop.json", folder.at("loop.json"));
    CHECK_THROWS_WITH(load_scene(folder.at("loop.json"), {}, warnings), Catch::Contains("cannot be opened"));
    folder.write("huge.json", "");
    std::filesystem::resize_file(folder.at("huge.json"), uintmax_t{1} << 33);
    CHECK_THROWS_WITH(load_scene(folder.at("huge.json"), {}, warnings), Catch::Contains("bytes, at most"));
}

}  // namespace lumi::baker
