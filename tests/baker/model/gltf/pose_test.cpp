// SPDX-License-Identifier: MIT
// Skins, morph targets and animations of glTF files.
#include <catch2/catch.hpp>

#include "lumi/baker/scene.h"
#include "model/readers.h"
#include "support/gltf_bytes.h"
#include "support/scratch_folder.h"

namespace lumi::baker
{
namespace
{

using testing::GltfMaker;
using testing::ScratchFolder;

SceneParts posed(const GltfMaker& maker, const std::optional<AnimationTime>& time = std::nullopt)
{
    const ScratchFolder folder;
    std::vector<std::string> warnings;
    SceneParts parts = read_gltf(folder.write("m.glb", maker.glb()), warnings, time);
    CHECK(warnings.empty());
    return parts;
}

void check_refused(const GltfMaker& maker, const std::string& word,
                   const std::optional<AnimationTime>& time = std::nullopt)
{
    const ScratchFolder folder;
    std::vector<std::string> warnings;
    CHECK_THROWS_WITH(read_gltf(folder.write("m.glb", maker.glb()), warnings, time), Catch::Contains(word));
}

void check_near(const Vec3& a, const Vec3& b)
{
    CHECK(a.x == Approx(b.x).margin(1e-6));
    CHECK(a.y == Approx(b.y).margin(1e-6));
    CHECK(a.z == Approx(b.z).margin(1e-6));
}

std::string quoted(const std::string& name, size_t value)
{
    return "\"" + name + "\":" + std::to_string(value);
}

constexpr char kTurned[] = "\"rotation\":[0,0,0.7071067811865476,0.7071067811865476]";  // by 90 degrees about z

// A triangle with normals along x whose mesh has more attributes and members; node 0 places it, `nodes` follow.
struct Triangle {
    GltfMaker maker;
    std::string attributes, primitive, mesh, nodes, node;

    Triangle()
    {
        attributes = quoted("POSITION", maker.vec3({0, 0, 0, 1, 0, 0, 0, 0, 1}));
        attributes += "," + quoted("NORMAL", maker.vec3({1, 0, 0, 1, 0, 0, 1, 0, 0}));
    }

    const GltfMaker& finished()
    {
        maker.add("\"meshes\":[{\"primitives\":[{\"attributes\":{" + attributes + "}" + primitive + "}]" + mesh + "}]");
        maker.add("\"scenes\":[{\"nodes\":[0,1]}],\"nodes\":[{\"mesh\":0" + node + "}" + nodes + "]");
        return maker;
    }
};

// Each vertex hangs on two joints, in two sets: all on the first but for `of_second` on the last one.
Triangle skinned(float of_second, const std::string& more_joints, const std::string& last = "1")
{
    Triangle t;
    const std::vector<uint8_t> first = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    const std::vector<uint8_t> second = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    std::vector<float> weights(12, 0.0f), others(12, 0.0f);
    for (size_t k = 0; k < 12; k += 4) weights[k] = 1 - of_second, others[k] = of_second;
    t.attributes += "," + quoted("JOINTS_0", t.maker.numbers(first, 5121, "VEC4", 3));
    t.attributes += "," + quoted("WEIGHTS_0", t.maker.numbers(weights, 5126, "VEC4", 3));
    t.attributes += "," + quoted("JOINTS_1", t.maker.numbers(second, 5121, "VEC4", 3));
    t.attributes += "," + quoted("WEIGHTS_1", t.maker.numbers(others, 5126, "VEC4", 3));
    // Both joints are bound one unit up.
    std::vector<float> bound;
    for (int k = 0; k < 2; ++k) bound.insert(bound.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1});
    t.maker.add("\"skins\":[{\"name\":\"arm\",\"joints\":[2," + last + "]," +
                quoted("inverseBindMatrices", t.maker.numbers(bound, 5126, "MAT4", 2)) + "}]");
    t.node = ",\"skin\":0,\"translation\":[9,9,9]";
    t.nodes = ",{\"translation\":[0,1,0],\"children\":[2]},{" + more_joints + "}";
    return t;
}

TEST_CASE("glTF: a skin goes with its joints and not with its node, up to eight a vertex")
{
    Triangle t = skinned(0, kTurned);
    const SceneParts parts = posed(t.finished());
    // (x, y - 1) turned by 90 degrees and moved up by 1.
    check_near(parts.mesh.positions[0], {1, 1, 0});
    check_near(parts.mesh.positions[1], {1, 2, 0});
    check_near(parts.mesh.normals[0], {0, 1, 0});
    CHECK(parts.notes.empty());
    Triangle half = skinned(0.5f, "\"translation\":[4,0,0]");
    check_near(posed(half.finished()).mesh.positions[1], {3, 0, 0});
}

TEST_CASE("glTF: what a skin bends is refused as a part that moves")
{
    Triangle t = skinned(0, kTurned);
    t.node += ",\"name\":\"sleeve\"";
    const ScratchFolder folder;
    const std::string file = folder.write("m.glb", t.finished().glb());
    LoadOptions options;
    PartOptions part;
    part.name = "sleeve";
    part.axis = {0, 0, 1};
    options.parts = {part};
    std::vector<std::string> warnings;
    CHECK_THROWS_WITH(load_scene(file, options, warnings), Catch::Contains("'sleeve' is bent by a skin"));
    const std::string scene = folder.write("s.json", "{\"objects\": [{\"obj\": \"m.glb\"}, {\"obj\": \"m.glb\"}]}");
    CHECK_THROWS_WITH(load_scene(scene, options, warnings), Catch::Contains("'sleeve' is bent by a skin"));
}

TEST_CASE("glTF: a skin that cannot be posed is refused by its name")
{
    Triangle no_joint = skinned(0, "", "7");
    check_refused(no_joint.finished(), "joint 7");
    Triangle short_list = skinned(0, "", "1,1");
    check_refused(short_list.finished(), "'arm' has fewer inverse bind matrices");
    Triangle far_joint = skinned(0.5f, "");
    std::vector<uint8_t> beyond(12, 200);
    const std::string joints = std::to_string(far_joint.maker.numbers(beyond, 5121, "VEC4", 3));
    far_joint.attributes.replace(far_joint.attributes.find("JOINTS_0") + 10, 1, joints);
    check_refused(far_joint.finished(), "joint 200");
}

Triangle morphing(const std::string& mesh, const std::string& node)
{
    Triangle t;
    const std::string up = std::to_string(t.maker.vec3({0, 2, 0, 0, 2, 0, 0, 2, 0}));
    const std::string over = std::to_string(t.maker.vec3({-1, 1, 0, -1, 1, 0, -1, 1, 0}));
    t.primitive = ",\"targets\":[{\"POSITION\":" + up + "},{\"NORMAL\":" + over + "}]";
    t.mesh = mesh;
    t.node = node;
    t.nodes = ",{}";
    return t;
}

TEST_CASE("glTF: morph targets count by the node's weights, or else by the mesh's")
{
    Triangle by_mesh = morphing(",\"weights\":[0.5,1]", "");
    const SceneParts parts = posed(by_mesh.finished());
    check_near(parts.mesh.positions[1], {1, 1, 0});
    check_near(parts.mesh.normals[1], {0, 1, 0});
    Triangle by_node = morphing(",\"weights\":[0.5,1]", ",\"weights\":[2,0]");
    check_near(posed(by_node.finished()).mesh.positions[1], {1, 4, 0});
    Triangle unmoved = morphing("", "");
    check_near(posed(unmoved.finished()).mesh.positions[1], {1, 0, 0});
}

// Node 0 moves from x = 0 at 1 s to x = 8 at 3 s; it turns by 90 degrees meanwhile.
Triangle moving(const std::string& interpolation, const std::vector<float>& moves)
{
    Triangle t = morphing("", "");
    const size_t times = t.maker.numbers(std::vector<float>{1, 3}, 5126, "SCALAR", 2);
    const float half = std::sqrt(0.5f);
    const size_t turns = t.maker.numbers(std::vector<float>{0, 0, 0, 1, 0, 0, half, half}, 5126, "VEC4", 2);
    const size_t weights = t.maker.numbers(std::vector<float>{0, 0, 1, 0}, 5126, "SCALAR", 4);
    const auto sampler = [&](size_t output, const std::string& kind) {
        return "{" + quoted("input", times) + "," + quoted("output", output) + ",\"interpolation\":\"" + kind + "\"}";
    };
    const auto channel = [](int number, const std::string& path) {
        return "{\"sampler\":" + std::to_string(number) + ",\"target\":{\"node\":0,\"path\":\"" + path + "\"}}";
    };
    t.maker.add("\"animations\":[{\"name\":\"walk\",\"samplers\":[" + sampler(t.maker.vec3(moves), interpolation) +
                "," + sampler(turns, "LINEAR") + "," + sampler(weights, "LINEAR") + "],\"channels\":[" +
                channel(0, "translation") + "," + channel(1, "rotation") + "," + channel(2, "weights") + "]}]");
    return t;
}

TEST_CASE("glTF: a time of an animation moves, turns and morphs, and holds beyond its ends")
{
    Triangle t = moving("LINEAR", {0, 0, 0, 8, 0, 0});
    const GltfMaker maker = t.finished();
    const SceneParts resting = posed(maker);
    CHECK_THAT(resting.notes.at(0), Catch::Contains("'walk'") && Catch::Contains("--animation"));
    check_near(resting.mesh.positions[1], {1, 0, 0});
    check_near(posed(maker, AnimationTime{"walk", 0}).mesh.positions[1], {1, 0, 0});
    // Turned by 45 degrees, after it is morphed by 1.
    const float s = std::sqrt(0.5f);
    check_near(posed(maker, AnimationTime{"walk", 2}).mesh.positions[1], {4 + s - s, s + s, 0});
    const SceneParts end = posed(maker, AnimationTime{"walk", 99});
    check_near(end.mesh.positions[0], {8 - 2, 0, 0});
    CHECK(end.notes.empty());
    Triangle stepping = moving("STEP", {0, 0, 0, 8, 0, 0});
    check_near(posed(stepping.finished(), AnimationTime{"walk", 2.9}).mesh.positions[0],
               {-2 * 0.95f * std::sin(0.95f * kPi / 2), 2 * 0.95f * std::cos(0.95f * kPi / 2), 0});
    // In and out tangents of 0: halfway is the mean.
    Triangle cubic = moving("CUBICSPLINE", {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 8, 0, 0, 0, 0, 0});
    check_near(posed(cubic.finished(), AnimationTime{"walk", 2}).mesh.positions[0], {4 - s, s, 0});
}

TEST_CASE("glTF: an animation that is not there, or moves what cannot be posed, is refused by its name")
{
    Triangle t = moving("LINEAR", {0, 0, 0, 8, 0, 0});
    const GltfMaker maker = t.finished();
    check_refused(maker, "choose among: 'walk'", AnimationTime{"run", 0});
    Triangle still = morphing("", "");
    check_refused(still.finished(), "no animation 'run'", AnimationTime{"run", 0});
    Triangle few = moving("LINEAR", {0, 0, 0});
    check_refused(few.finished(), "keys without values", AnimationTime{"walk", 1});
}

TEST_CASE("an animation's time is read behind the last @")
{
    CHECK(animation_time("a@b@1.5")->name == "a@b");
    CHECK(animation_time("a@b@1.5")->seconds == 1.5);
    CHECK(animation_time("walk")->seconds == 0);
    CHECK_FALSE(animation_time("walk@soon"));
}

}  // namespace
}  // namespace lumi::baker
