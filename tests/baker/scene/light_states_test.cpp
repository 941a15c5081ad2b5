// SPDX-License-Identifier: MIT
#include "scene/light_states.h"

#include <catch2/catch.hpp>

#include "lumi/baker/reference.h"
#include "lumi/orbit.h"
#include "support/scratch_folder.h"

namespace lumi::baker::testing
{
namespace
{

// A grey floor below a lamp and beside a panel that shines. More members of the lamp, the panel and the sky.
std::filesystem::path written(const ScratchFolder& folder, const std::string& lamp, const std::string& panel,
                              const std::string& sky = "")
{
    folder.write("s.mtl", "newmtl grey\nKd 0.5 0.5 0.5\nnewmtl panel\nKd 0 0 0\nKe 0.5 1 2\n");
    folder.write("s.obj",
                 "mtllib s.mtl\nv -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -1 1 -1\nv 1 1 -1\nusemtl grey\n"
                 "f 4 3 2 1\nusemtl panel\nf 1 2 6 5\n");
    const std::string objects = R"({"objects": [{"obj": "s.obj"}], "exposure": 0, )";
    const std::string environment = R"("environment": {"zenith": 0.2, "horizon": 0.1, "nadir": 0.3)" + sky + "}, ";
    const std::string lights = R"("lights": [{"type": "point", "position": [0, 2, 1], "intensity": [3, 2, 1])";
    return folder.write("s.json",
                        objects + environment + lights + lamp + R"(}], "materials": {"panel": {)" + panel + "}}}");
}

Scene loaded(const std::filesystem::path& file, const std::vector<StateOption>& states = {})
{
    std::vector<std::string> warnings;
    LoadOptions options;
    options.states = states;
    return load_scene(file, options, warnings);
}

// The light of a picture from above.
std::array<double, 3> light_of(const Scene& scene)
{
    Camera camera;
    const Pose pose = pose_of(Orbit{degrees(20), degrees(50), radii(3)});
    REQUIRE(make_camera(pose, {24, 24, degrees(45)}, camera) == CameraError::none);
    const RadianceImage image = trace_radiance(scene, camera, {256, 1, 1});
    std::array<double, 3> sum{};
    for (size_t k = 0; k < image.rgba.size(); ++k)
        if (k % 4 != 3) sum[k % 4] += static_cast<double>(image.rgba[k]);
    return sum;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("light states: labels of a scene file and names make states, and all else is base")
{
    const ScratchFolder folder;
    const std::filesystem::path file = written(folder, R"(, "state": "lamp")", R"("state": "lamp")");
    CHECK(loaded(file).light_states() == Names{"base", "lamp"});
    CHECK(loaded(file, {{"sky"}}).light_states() == Names{"base", "lamp", "sky"});
    CHECK(loaded(written(folder, "", "")).light_states().empty());
    CHECK(loaded(written(folder, "", ""), {{"panel"}}).light_states() == Names{"base", "panel"});
    CHECK(loaded(written(folder, "", "", R"(, "state": "day")")).light_states() == Names{"base", "day"});
}

TEST_CASE("light states: names without a light, and labels that say nothing, are refused")
{
    const ScratchFolder folder;
    const auto told = [&](const std::vector<StateOption>& states, const std::filesystem::path& scene) {
        try {
            loaded(scene, states);
        } catch (const SceneError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK_THAT(told({{"pane"}}, written(folder, R"(, "state": "lamp")", "")),
               Catch::Contains("s.json") && Catch::Contains("did you mean panel?") &&
                   Catch::Contains("choose among: sky, lamp, panel"));
    CHECK_THAT(told({}, written(folder, "", R"("emission": 0, "state": "a")")), Catch::Contains("does not shine"));
    CHECK_THAT(told({}, written(folder, R"(, "state": "")", "")), Catch::Contains("'state' is empty"));
    CHECK_THAT(told({}, written(folder, R"(, "state": ")" + std::string(29, 'n') + "\"", "")),
               Catch::Contains("longer than 28 bytes"));
}

TEST_CASE("light states: the light of all states is the sum of each alone, and weights scale it")
{
    const ScratchFolder folder;
    const Scene scene = loaded(written(folder, R"(, "state": "lamp")", R"("state": "panel")"));
    const std::vector<LitState> states = lit_states(scene.data());
    REQUIRE(states.size() == 3);
    CHECK((states[0].name == "base" && states[1].name == "lamp" && states[2].name == "panel"));
    CHECK((states[0].scale == 1 && states[1].scale == 1 && states[2].scale == 2));  // the panel's brightest channel
    const std::array<double, 3> all = light_of(scene), panel = light_of(states[2].scene);
    std::array<double, 3> sum{};
    for (const LitState& state : states)
        for (size_t c = 0; c < 3; ++c) sum[c] += static_cast<double>(state.scale) * light_of(state.scene)[c];
    const std::array<double, 3> dimmed = light_of(loaded(folder.at("s.json"), {{"panel", {0.5f, 0, 1}}}));
    const double lost[] = {0.5, 1, 0};
    for (size_t c = 0; c < 3; ++c) {
        CHECK(sum[c] == Approx(all[c]).epsilon(0.03));
        CHECK(all[c] - dimmed[c] == Approx(lost[c] * 2 * panel[c]).margin(0.03 * all[c]));
    }
    CHECK(lit_states(loaded(written(folder, "", ""), {{"sky"}}).data())[0].scale == 2);  // base has the panel
}

TEST_CASE("light states: the weight of base, where nothing else is named, dims all light")
{
    const ScratchFolder folder;
    const std::filesystem::path file = written(folder, "", "");
    const std::array<double, 3> all = light_of(loaded(file)),
                                dimmed = light_of(loaded(file, {{"base", {0.5f, 0.25f, 0}}}));
    const double left[] = {0.5, 0.25, 0};
    for (size_t c = 0; c < 3; ++c) CHECK(dimmed[c] == Approx(left[c] * all[c]).margin(0.01 * all[c]));
}

TEST_CASE("light states: a base without light is left out, unless one state would be alone")
{
    const ScratchFolder folder;
    folder.write("l.mtl", "newmtl grey\nKd 0.5 0.5 0.5\nnewmtl lamp\nKd 0 0 0\nKe 9 9 9\n");
    folder.write("l.obj",
                 "mtllib l.mtl\nv -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -1 1 -1\nv 1 1 -1\nusemtl grey\n"
                 "f 4 3 2 1\nusemtl lamp\nf 1 2 6 5\n");
    const std::filesystem::path file_of_lamp =
        folder.write("l.json", R"({"objects": [{"obj": "l.obj"}], "environment": "black"})");
    const std::vector<LitState> alone = lit_states(loaded(file_of_lamp, {{"lamp"}}).data());
    REQUIRE(alone.size() == 2);
    CHECK((alone[0].name == "base" && alone[0].scene.data().lights.empty() && alone[1].name == "lamp"));
    const std::filesystem::path file =
        written(folder, R"(, "state": "lamp")", R"("state": "panel")", R"(, "state": "day")");
    const std::vector<LitState> states = lit_states(loaded(file).data());
    REQUIRE(states.size() == 3);
    CHECK(states[0].name == "day");
}

}  // namespace lumi::baker::testing
