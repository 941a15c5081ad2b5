// SPDX-License-Identifier: MIT
// Lamps in watts, lux and candela, by the table of docs/blender.md, over a diffuse floor: light has closed forms.
#include <catch2/catch.hpp>

#include "support/gltf_bytes.h"
#include "support/scratch_folder.h"
#include "support/statistics.h"
#include "trace/path_tracer.h"

namespace lumi::baker
{
namespace
{

constexpr double kPi2 = 2 * 3.14159265358979323846, kWatts = 100, kStrength = 3, kHeight = 2, kAlbedo = 0.6;
constexpr double kLumensPerWatt = 683;

// A floor of half a metre through the origin, in a sphere of a metre; y is up.
const std::string kFloor = "v -0.25 0 -0.25\nv -0.25 0 0.25\nv 0.25 0 0.25\nv 0.25 0 -0.25\nf 1 2 3 4\n";
const std::string kSphere = R"("sphere": {"centre": [0, 0, 0], "radius": 1}, "exposure": 0)";

// Divides what the middle of the floor shows by what it would show of an irradiance of 1.
testing::Mean irradiance_of(const Scene& scene)
{
    const PathTracer tracer(scene.data());
    testing::Mean mean;
    for (uint32_t k = 0; k < 20000; ++k) {
        Sampler sampler(5, k, 0);
        const Vec3 eye = {0.3f, 0.2f, 0.5f};
        const double seen = static_cast<double>(tracer.trace({eye, normalized(-eye)}, sampler).radiance.g);
        mean.add(seen * kPi2 / 2 / kAlbedo);
    }
    return mean;
}

void check_irradiance(const Scene& scene, double expected)
{
    const testing::Mean mean = irradiance_of(scene);
    INFO(mean.value() << " for " << expected);
    CHECK(mean.value() == Approx(expected).margin(testing::kSigmas * mean.error() + 1e-3 * expected));
}

Scene scene_with(const std::string& light)
{
    const testing::ScratchFolder folder;
    folder.write("floor.obj", kFloor);
    std::vector<std::string> warnings;
    return load_scene(
        folder.write("s.json", R"({"objects": [{"obj": "floor.obj"}], "lights": [)" + light + "], " + kSphere + "}"),
        {}, warnings);
}

// The floor and a lamp two metres above it that shines down.
Scene model_with(const std::string& lamp)
{
    testing::GltfMaker maker;
    const size_t corners = maker.vec3({-0.25f, 0, -0.25f, -0.25f, 0, 0.25f, 0.25f, 0, 0.25f, 0.25f, 0, -0.25f});
    const size_t order = maker.indices({0, 1, 2, 0, 2, 3});
    maker.add("\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":" + std::to_string(corners) +
              "},\"indices\":" + std::to_string(order) +
              "}]}],\"nodes\":[{\"mesh\":0},{\"translation\":[0,2,0],\"rotation\":[-0.70710678,0,0,0.70710678],"
              "\"extensions\":{\"KHR_lights_punctual\":{\"light\":0}}}],\"scenes\":[{\"nodes\":[0,1]}],"
              "\"extensions\":{\"KHR_lights_punctual\":{\"lights\":[" +
              lamp + "]}}");
    const testing::ScratchFolder folder;
    std::vector<std::string> warnings;
    LoadOptions options;
    options.exposure_stops = 0;
    return load_scene(folder.write("m.glb", maker.glb()), options, warnings);
}

std::string text(double value)
{
    return std::to_string(value);
}

}  // namespace

TEST_CASE("lamps: watts of a point, a spot and a square, and the strength of a sun, as the table converts them")
{
    const double intensity = kWatts / (2 * kPi2), at_floor = intensity / (kHeight * kHeight);
    check_irradiance(scene_with(R"({"type": "point", "position": [0, 2, 0], "intensity": )" + text(intensity) + "}"),
                     at_floor);
    check_irradiance(
        scene_with(R"({"type": "spot", "position": [0, 2, 0], "target": [0, 0, 0], "angle": 30, "intensity": )" +
                   text(intensity) + "}"),
        at_floor);
    check_irradiance(
        scene_with(R"({"type": "directional", "direction": [0, -1, 0], "irradiance": )" + text(kStrength) + "}"),
        kStrength);
    check_irradiance(scene_with(R"({"type": "sphere", "position": [0, 2, 0], "radius": 0.1, "radiance": )" +
                                text(kWatts / (kPi2 * kPi2 * 0.1 * 0.1)) + "}"),
                     at_floor);
    // A small square is a point whose intensity straight down is radiance times area: P/4, and not P/4π.
    const double side = 0.01;
    check_irradiance(
        scene_with(
            R"({"type": "rectangle", "position": [0, 2, 0], "target": [0, 0, 0], "size": [0.01, 0.01], "radiance": )" +
            text(kWatts / (4 * side * side)) + "}"),
        kWatts / 4 / (kHeight * kHeight));
}

TEST_CASE("lamps: candela and lux of a glTF file, as Blender's exporter writes watts and strengths")
{
    const double candela = kWatts * kLumensPerWatt / (2 * kPi2), at_floor = kWatts / (2 * kPi2) / (kHeight * kHeight);
    check_irradiance(model_with("{\"type\":\"point\",\"intensity\":" + text(candela) + "}"), at_floor);
    check_irradiance(
        model_with("{\"type\":\"spot\",\"intensity\":" + text(candela) + ",\"spot\":{\"outerConeAngle\":0.5}}"),
        at_floor);
    check_irradiance(model_with("{\"type\":\"directional\",\"intensity\":" + text(kStrength * kLumensPerWatt) + "}"),
                     kStrength);
}

}  // namespace lumi::baker
