// SPDX-License-Identifier: MIT
#include "fit/texel_lines.h"

#include <catch2/catch.hpp>

#include "fit/path_plan.h"

namespace lumi::baker::testing
{
namespace
{

constexpr uint32_t kPilotLines = 32;  // to each texel of a small field
constexpr float kDensity = 8;         // texels a radius

// Two squares side by side, and a lone triangle.
FitShape shape_of_three()
{
    PatchMesh mesh;
    mesh.positions = {{-0.5f, -0.5f, 0}, {0, -0.5f, 0},   {0.5f, -0.5f, 0}, {-0.5f, 0.5f, 0},
                      {0, 0.5f, 0},      {0.5f, 0.5f, 0}, {0, 0.8f, 0}};
    mesh.normals = std::vector<Vec3>(7, Vec3{0, 0, 1});
    mesh.patches = {{0, 1, 3, 4}, {1, 2, 4, 5}, {3, 5, 6, PatchMesh::kNone}};
    return FitShape(mesh, {kDensity, kDensity, kDensity});
}

// Light of levels that differ by up to `noise`, `paths` of it to each texel of a patch.
void add_light(FitSums& sums, uint32_t patch, uint32_t paths, float noise)
{
    const PatchRectangle& r = sums.shape().layout.rectangles[patch];
    std::vector<FitSample> samples;
    Sampler sampler(1, patch, 0);
    for (uint32_t k = 0; k < paths * r.size(); ++k) {
        sampler.start(k);
        const float light = 0.2f + noise * (sampler.next_1d() - 0.5f);
        samples.push_back({2 * patch, r.begin + k % r.size(), 1000, 1000, {0, 0, 12288}, {light, light, light}, {}});
    }
    sums.add(patch, samples.data(), samples.data() + samples.size());
}

// Returns the lines to a texel, by patch. So many lines of the pilot brought light to the first square, as noisy as
// `noise`. The settings allow texels of `density`, and vertices have view tables if `viewed` is not 0.
std::vector<uint32_t> planned_lines(uint32_t paths, float noise, float others = 0.1f, float density = kDensity,
                                    uint8_t viewed = 1)
{
    const FitShape shape = shape_of_three();
    const EncodedTone tone(ToneCurve::srgb);
    FitModel model = empty_model(shape);
    for (LevelColour& texel : model.texels) texel = {124, 124, 124};
    FitSums sums(shape, tone, model, White::goes_on);
    add_light(sums, 0, paths, noise);
    add_light(sums, 1, kPilotLines, others);
    SurfaceSettings settings;
    settings.paths_per_texel = 60;
    settings.texels_per_radius = density;
    return PathPlan(settings, Shard{}, shape).lines(sums, std::vector<uint8_t>(shape.mesh.positions.size(), viewed));
}

}  // namespace

TEST_CASE("a place in a texel is one that the texel shows", "[fit]")
{
    for (const PatchRectangle& r : {PatchRectangle{7, 1, 1}, {0, 2, 5}, {100, 9, 4}}) {
        for (uint32_t texel = 0; texel < r.size(); ++texel) {
            for (const Vec2& within : {Vec2{0.01f, 0.01f}, {0.99f, 0.5f}, {0.3f, 0.98f}}) {
                const Vec2 weights = place_in(r, texel, within);
                CHECK(weights.x >= 0);
                CHECK(weights.y <= 1);
                const bool second = weights.x + weights.y > 1;
                const float x = second ? 1 - weights.x : weights.x, y = second ? 1 - weights.y : weights.y;
                CHECK(texel_at(r, second, x, y) == r.begin + texel);
            }
        }
    }
}

TEST_CASE("a texel's lines come from the sphere, meet its surface from in front, and fall on all of it alike", "[fit]")
{
    const FitShape shape = shape_of_three();
    for (uint32_t patch = 0; patch < 3; ++patch) {
        uint32_t drawn = 0;
        Vec3 sum;
        for (uint32_t texel = 0; texel < shape.layout.rectangles[patch].size(); ++texel) {
            Sampler sampler(1, patch, 0);
            for (uint32_t k = 0; k < 16; ++k) {
                sampler.start(16 * texel + k);
                const std::optional<Ray> ray = texel_line(shape, patch, texel, sampler);
                if (!ray) continue;
                CHECK(length(ray->origin) == Approx(1));
                CHECK(ray->direction.z < 0);
                sum = sum + ray->origin - ray->direction * (ray->origin.z / ray->direction.z);
                ++drawn;
            }
        }
        CAPTURE(patch, drawn);
        const Vec3 middle = patch == 2 ? Vec3{0, 0.6f, 0} : Vec3{patch == 0 ? -0.25f : 0.25f, 0, 0};
        CHECK(length(sum * (1.0f / static_cast<float>(drawn)) - middle) < 0.02f);
        const uint32_t all = 16 * shape.layout.rectangles[patch].size();
        if (patch == 2)
            CHECK(drawn == Approx(all / 2.0).epsilon(0.1));  // half of its texels' area lies beyond the triangle
        else
            CHECK(drawn == all);
    }
}

TEST_CASE("more lines go where light is noisy, or where few lines bring any", "[fit]")
{
    const std::vector<uint32_t> alike = planned_lines(kPilotLines, 0.1f), noisy = planned_lines(kPilotLines, 0.3f),
                                hidden = planned_lines(kPilotLines / 4, 0.1f);
    CHECK(alike[0] == Approx(alike[1]).epsilon(0.1));
    for (const uint32_t lines : noisy) CHECK(lines >= kPilotLines);  // the pilot's are among them
    CHECK(noisy[0] > 2 * noisy[1]);
    CHECK(hidden[0] > hidden[1] * 3 / 2);
    CHECK(planned_lines(1, 10, 0)[0] <= 32 * 60);  // however little noise there is elsewhere
    for (const uint32_t lines : planned_lines(kPilotLines, 0, 0)) CHECK(lines <= 64);  // more would tell nothing new
}

TEST_CASE("texels that are spared leave their lines to view tables, and to nothing else", "[fit]")
{
    const uint32_t usual = planned_lines(kPilotLines, 0.1f)[0];
    CHECK(planned_lines(kPilotLines, 0.1f, 0.1f, 2 * kDensity)[0] == Approx(4 * usual).epsilon(0.1));
    CHECK(planned_lines(kPilotLines, 0.1f, 0.1f, 2 * kDensity, 0)[0] <= usual);
}

}  // namespace lumi::baker::testing
