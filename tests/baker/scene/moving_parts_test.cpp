// SPDX-License-Identifier: MIT
// Parts of a scene that turn or slide: what they are, how far they reach, and what cannot move.
#include "scene/moving_parts.h"

#include <catch2/catch.hpp>

#include "support/gltf_bytes.h"
#include "support/obj_files.h"

namespace lumi::baker
{
namespace
{

using testing::GltfMaker;
using testing::ScratchFolder;

// A dial in the plane z = 0 and a hand before it that shares two of its corners, from the middle to x = 1.
const std::string kDialScene =
    "mtllib m.mtl\no dial\nusemtl grey\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n"
    "o hand\nusemtl red\nv 0 0 0.1\nf 2 3 5\no pane\nusemtl pane\nv 0 0 -0.5\nv 0.1 0 -0.5\nv 0 0.1 -0.5\nf 6 7 8\n"
    "o bulb\nusemtl glass\nv 0 0 -0.6\nv 0.1 0 -0.6\nv 0 0.1 -0.6\nv 0 0 -0.7\n"
    "f 9 11 10\nf 9 10 12\nf 10 11 12\nf 9 12 11\n";
const std::string kDialMaterials =
    "newmtl grey\nKd 0.5 0.5 0.5\nnewmtl red\nKd 1 0 0\nnewmtl pane\nKd 1 1 1\nd 0.4\nnewmtl glass\nillum 7\nNi 1.5\n";

std::string without_bulb()
{
    return kDialScene.substr(0, kDialScene.find("o bulb"));
}

PartOptions hand(double value = 0)
{
    PartOptions part;
    part.name = "hand";
    part.axis = {0, 0, 1};
    part.pivot = {0, 0, 0};
    part.value = value;
    return part;
}

Scene dial_with(const std::vector<PartOptions>& parts, const std::string& obj = without_bulb())
{
    const ScratchFolder folder;
    folder.write("m.mtl", kDialMaterials);
    LoadOptions options;
    options.up = UpAxis::z;
    options.parts = parts;
    std::vector<std::string> warnings;
    return load_scene(folder.write("s.obj", obj), options, warnings);
}

// In scene units.
Vec3 corner(const Scene& scene, size_t triangle, size_t k)
{
    const std::array<float, 3> c = scene.centre();
    return scene.data().mesh.position(triangle, k) * scene.radius() + Vec3{c[0], c[1], c[2]};
}

void check_place(const Vec3& a, const Vec3& b)
{
    CHECK(length(a - b) < 1e-5f);
}

void check_part_refused(const std::vector<PartOptions>& parts, const std::string& word,
                        const std::string& obj = without_bulb())
{
    CHECK_THROWS_WITH(dial_with(parts, obj), Catch::Contains("s.obj: ") && Catch::Contains(word));
}

}  // namespace

TEST_CASE("moving parts: a part turns by the right-hand rule and leaves what shares its corners")
{
    const Scene scene = dial_with({hand(90)});
    check_place(corner(scene, 2, 0), {1, 1, 0});
    check_place(corner(scene, 2, 1), {-1, 1, 0});
    check_place(corner(scene, 2, 2), {0, 0, 0.1f});
    check_place(corner(scene, 0, 1), {1, -1, 0});
}

TEST_CASE("moving parts: one sphere holds every pose, whichever is traced, in the same light")
{
    PartOptions away = hand();
    away.pivot = {1, 0, 0};
    const Scene rest = dial_with({away});
    CHECK(rest.radius() > dial_with({}).radius() + 0.1f);
    REQUIRE(!rest.notes().empty());
    CHECK_THAT(rest.notes().front(), Catch::Contains(" times as large as the scene"));
    for (away.value = -180; away.value <= 180; away.value += 22.5) {
        const Scene scene = dial_with({away});
        CHECK(scene.radius() == rest.radius());
        CHECK(scene.centre() == rest.centre());
        CHECK(scene.data().choice.exposure == rest.data().choice.exposure);
        for (size_t k = 0; k < 3; ++k) CHECK(length(scene.data().mesh.position(2, k)) < 1);
    }
}

TEST_CASE("moving parts: a part that turns little takes little room, and one that slides reaches both ends")
{
    PartOptions away = hand();
    away.pivot = {2.5, 0, 0};
    const float round = dial_with({away}).radius();
    away.range = {-5, 5};
    const float little = dial_with({away}).radius();
    CHECK(little < 0.5f * round);
    PartOptions sliding = hand(2);
    sliding.slides = true;
    sliding.axis = {0, 2, 0};
    sliding.range = {0, 2};
    const Scene slid = dial_with({sliding});
    check_place(corner(slid, 2, 0), {1, 1, 0});
    CHECK(slid.radius() > 1.5f);
}

TEST_CASE("moving parts: each part is lit with the body, and the body alone")
{
    PartOptions other = hand();
    other.name = "dial";
    const Scene scene = dial_with({hand(), other});
    const LitScenes lit(scene.data());
    CHECK(lit.body().mesh.triangle_count() == 1);
    CHECK(lit.poses(1)[0].scene->mesh.triangle_count() == 2);
    CHECK(lit.poses(2)[0].scene->mesh.triangle_count() == 3);
    CHECK(lit.poses(2)[0].scene->radius == scene.data().radius);
    REQUIRE(lit.poses(1).size() == 4);
    const Ray ray = lit.poses(1)[1].posed({{1, 0, 0.5f}, {0, 0.6f, -0.8f}});  // by a quarter of a turn
    const Vec3 pivot = scene.data().moving.motions[0].pivot, before = Vec3{1, 0, 0.5f} - pivot;
    CHECK(length(ray.direction - Vec3{-0.6f, 0, -0.8f}) < 1e-6f);
    CHECK(length(ray.origin - pivot - Vec3{-before.y, before.x, before.z}) < 1e-5f);
    PartOptions lit_once = hand();
    lit_once.lit_at = 90;
    CHECK(LitScenes(dial_with({lit_once, other}).data()).poses(1).size() == 1);
    CHECK(dial_with({lit_once, other}).fingerprint() != scene.fingerprint());
    const Scene still = dial_with({});
    CHECK(LitScenes(still.data()).body().mesh.triangle_count() == still.data().mesh.triangle_count());
    CHECK(scene.fingerprint() != still.fingerprint());
}

TEST_CASE("moving parts: a node's own axis and origin are the part's")
{
    const auto text = [](size_t n) { return std::to_string(n); };
    GltfMaker maker;
    const size_t a = maker.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
    maker.add("\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":" + text(a) + "}}]}]");
    // The hand's x axis is the scene's y axis.
    maker.add(
        "\"nodes\":[{\"name\":\"box\",\"mesh\":0},{\"name\":\"hand\",\"mesh\":0,\"translation\":[5,0,0],"
        "\"rotation\":[0,0,0.7071067811865476,0.7071067811865476],\"scale\":[2,2,2]}]");
    maker.add("\"scenes\":[{\"nodes\":[0,1]}]");
    const ScratchFolder folder;
    LoadOptions options;
    options.up = UpAxis::z;
    options.parts = {hand(90)};
    options.parts[0].axis = {1, 0, 0};
    options.parts[0].pivot = std::nullopt;
    std::vector<std::string> warnings;
    const Scene scene = load_scene(folder.write("m.glb", maker.glb()), options, warnings);
    check_place(corner(scene, 1, 0), {5, 0, 0});
    check_place(corner(scene, 1, 1), {5, 2, 0});
    check_place(corner(scene, 1, 2), {5, 0, 2});
}

TEST_CASE("moving parts: a scene file names them, and a caller their poses")
{
    const ScratchFolder folder;
    folder.write("m.mtl", kDialMaterials);
    folder.write("s.obj", without_bulb());
    const auto scene = [&](const std::string& parts, const std::vector<PartOptions>& poses) {
        LoadOptions options;
        options.parts = poses;
        std::vector<std::string> warnings;
        return load_scene(
            folder.write("s.json", "{\"up\":\"z\",\"objects\":[{\"obj\":\"s.obj\"}],\n\"parts\":[" + parts + "]}"),
            options, warnings);
    };
    const std::string turning = "{\"name\":\"hand\",\"turn\":\"z\",\"pivot\":[0,0,0],\"from\":-10,\"to\":190}";
    PartOptions pose;
    pose.name = "hand";
    pose.value = 180;
    check_place(corner(scene(turning, {pose}), 2, 0), {-1, 1, 0});
    CHECK(scene(turning, {}).moving_parts() == std::vector<std::string>{"hand"});
    const std::string at = turning.substr(0, turning.size() - 1) + ",\"at\":90}";  // so at 0 it points 90 degrees back
    check_place(corner(scene(at, {}), 2, 0), {-1, -1, 0});
    pose.value = 90;
    check_place(corner(scene(at, {pose}), 2, 0), {1, -1, 0});
    pose.value = 200;
    const std::string lit = turning.substr(0, turning.size() - 1) + ",\"lit_at\":";
    CHECK(scene(lit + "190}", {}).data().moving.motions[0].lit_poses(4) == std::vector<double>{190});
    CHECK(scene(turning, {}).data().moving.motions[0].lit_poses(4) == std::vector<double>{15, 65, 115, 165});
    CHECK_THROWS_WITH(scene(lit + "191}", {}), Catch::Contains("'hand' moves from -10 to 190, not to 191"));
    CHECK_THROWS_WITH(scene(turning, {pose}), Catch::Contains("'hand' moves from -10 to 190, not to 200"));
    for (const auto& [text, word] : std::vector<std::pair<std::string, std::string>>{
             {"{\"name\":\"hand\"}", "s.json:2: a part has a 'turn' or a 'slide'"},
             {"{\"name\":\"hand\",\"turn\":\"w\",\"pivot\":[0,0,0]}", "'turn' must be \"x\", \"y\", \"z\" or three"},
             {"{\"name\":\"hand\",\"slide\":\"z\"}", "slides without an end"},
             {"{\"name\":\"hand\",\"slide\":\"z\",\"from\":1,\"to\":1}", "'from' is not below 'to'"},
             {"{\"name\":\"hand\",\"turn\":\"z\",\"from\":1}", "a part has no 'to'"},
             {"{\"name\":\"hand\",\"turn\":\"z\",\"pivots\":1}", "'pivots'"}})
        CHECK_THROWS_WITH(scene(text, {}), Catch::Contains(word));
}

TEST_CASE("moving parts: what cannot move is refused by name")
{
    PartOptions unknown = hand();
    unknown.name = "hands";
    check_part_refused({unknown}, "'hands' (did you mean hand?); choose among: dial, ");
    PartOptions nowhere = hand();
    nowhere.pivot = std::nullopt;
    check_part_refused({nowhere}, "'hand' has no pivot");
    PartOptions still = hand();
    still.axis = std::nullopt;
    check_part_refused({still}, "'hand' has no axis");
    still.axis = {0, 0, 0};
    check_part_refused({still}, "an axis without a length");
    PartOptions far = hand();
    far.pivot = {9, 0, 0};
    far.range = {-1, 1};
    CHECK_THROWS_WITH(dial_with({far}), Catch::Contains("'hand' turns about an axis that lies"));
    far.axis = {1, 0, 0};  // the axis itself is near
    CHECK(length(dial_with({far}).data().moving.motions[0].pivot) < 1);
    check_part_refused({hand(), hand()}, "a part cannot lie within another");
    PartOptions pane = hand();
    pane.name = "pane";
    check_part_refused({pane}, "'pane' lets light pass by its material 'pane'");
    check_part_refused({hand()}, "a body of glass ('glass')", kDialScene);
    PartOptions dial = hand();
    dial.name = "dial";
    const std::string two = kDialScene.substr(0, kDialScene.find("o pane"));
    check_part_refused({hand(), dial}, "leaves nothing that stands", two);
    std::string many;
    std::vector<PartOptions> parts;
    for (int k = 0; k < 17; ++k) {
        parts.push_back(hand());
        parts.back().name = "p" + std::to_string(k);
        many += "o " + parts.back().name + "\nf 1 2 3\n";
    }
    check_part_refused(parts, "'p16' is one more than a field holds, 16", two + many);
    parts.pop_back();
    CHECK(dial_with(parts, two + many).moving_parts().size() == 16);
}

}  // namespace lumi::baker
