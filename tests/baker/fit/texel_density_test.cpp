// SPDX-License-Identifier: MIT
#include "fit/texel_density.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "fit/fit_shape.h"
#include "surface/surface_scenes.h"

namespace lumi::baker::testing
{
namespace
{

// Two squares side by side, a patch each, facing up.
PatchMesh two_squares()
{
    PatchMesh mesh;
    for (uint32_t k = 0; k < 2; ++k) {
        const float left = k == 0 ? -0.7f : 0.1f;
        const uint32_t first = 4 * k;
        mesh.positions.insert(mesh.positions.end(),
                              {{left, -0.3f, 0}, {left + 0.6f, -0.3f, 0}, {left, 0.3f, 0}, {left + 0.6f, 0.3f, 0}});
        mesh.patches.push_back({first, first + 1, first + 2, first + 3});
    }
    mesh.normals.assign(mesh.positions.size(), {0, 0, 1});
    return mesh;
}

// The left one is even, the right one has stripes.
Scene one_of_them_striped()
{
    SceneMaker maker;
    const uint32_t light = maker.add(lamp(grey(0.6f))), dark = maker.add(lamp(grey(0.1f)));
    maker.quad(light, {-0.7f, -0.3f, 0}, {-0.1f, -0.3f, 0}, {-0.1f, 0.3f, 0}, {-0.7f, 0.3f, 0});
    for (int k = 0; k < 6; ++k) {
        const float left = 0.1f + 0.1f * static_cast<float>(k), right = left + 0.1f;
        maker.quad(k % 2 == 0 ? light : dark, {left, -0.3f, 0}, {right, -0.3f, 0}, {right, 0.3f, 0}, {left, 0.3f, 0});
    }
    maker.span_unit_sphere();
    return maker.make(constant_environment(0));
}

}  // namespace

TEST_CASE("texels lie densest where colours change, and are no more in all")
{
    const Scene scene = one_of_them_striped();
    SurfaceSettings settings = tiny_surface();
    settings.texels_per_radius = 20;
    settings.fills = true;
    const ProgressCallback quiet;
    const PatchMesh mesh = two_squares();
    const std::vector<float> densities = texel_densities({{scene.data()}}, mesh, settings, quiet);
    REQUIRE(densities.size() == 2);
    CHECK(densities[0] < 15);
    CHECK(densities[1] > 24);
    CHECK(layout_of(mesh, densities).texels <= layout_of(mesh, settings.texels_per_radius).texels);
}

TEST_CASE("texels are no more than show, unless they are to fill what is allowed")
{
    SceneMaker maker;
    const uint32_t light = maker.add(lamp(grey(0.6f)));
    for (const float left : {-0.7f, 0.1f})
        maker.quad(light, {left, -0.3f, 0}, {left + 0.6f, -0.3f, 0}, {left + 0.6f, 0.3f, 0}, {left, 0.3f, 0});
    maker.span_unit_sphere();
    const Scene even = maker.make(constant_environment(0)), striped = one_of_them_striped();
    const PatchMesh mesh = two_squares();
    const ProgressCallback quiet;
    const auto texels = [&](const std::vector<DensityLight>& lights, bool fills) {
        SurfaceSettings settings = tiny_surface();
        settings.texels_per_radius = 60;
        settings.fills = fills;
        return layout_of(mesh, texel_densities(lights, mesh, settings, quiet)).texels;
    };
    const uint32_t allowed = layout_of(mesh, 60).texels;
    CHECK(texels({{even.data()}}, false) < allowed / 4);
    CHECK(texels({{even.data()}}, true) > allowed * 9 / 10);
    CHECK(texels({{striped.data()}}, false) > allowed / 2);
    CHECK(texels({{even.data()}, {striped.data()}}, false) > allowed / 2);
    CHECK(texels({{even.data()}, {striped.data(), 0.01f}}, false) < allowed / 4);
}

TEST_CASE("texels are nowhere finer than a display shows, unless they are to fill what is allowed")
{
    const Scene striped = one_of_them_striped();
    const PatchMesh mesh = two_squares();
    SurfaceSettings settings = tiny_surface();
    settings.texels_per_radius = 60;
    settings.finest_texels = 40;
    const auto finest = [&] {
        const std::vector<float> densities = texel_densities({{striped.data()}}, mesh, settings, {});
        return *std::max_element(densities.begin(), densities.end());
    };
    CHECK(finest() == 40);
    settings.fills = true;
    CHECK(finest() > 60);
}

}  // namespace lumi::baker::testing
