// SPDX-License-Identifier: MIT
// Brushed metal and paint: facets that spread wider along the tangent than across it.
#include <catch2/catch.hpp>
#include <map>

#include "material/material.h"
#include "math/warp.h"
#include "support/bsdf_checks.h"
#include "support/scratch_folder.h"
#include "trace/hit_point.h"

namespace lumi::baker
{
namespace
{

using testing::Named;
using testing::plain_values;
using testing::short_text;

constexpr float kAnisotropies[] = {0.3f, 0.6f, 1.0f};

// The lobes look different along, across and between the axes.
std::vector<Vec3> viewers()
{
    std::vector<Vec3> all;
    for (const float turns : {0.0f, 0.13f, 0.25f}) {
        const std::vector<Vec3> more = testing::views(turns);
        all.insert(all.end(), more.begin(), more.end());
    }
    return all;
}

const Material& brushed(bool metal, float alpha, float anisotropy)
{
    static std::map<std::tuple<bool, float, float>, Material> materials;  // BSDFs borrow their tables
    const auto [entry, fresh] = materials.try_emplace({metal, alpha, anisotropy});
    Material& m = entry->second;
    if (fresh) {
        m.base = grey(1);
        m.metalness = metal ? 1 : 0;
        m.specular = true;
        m.alpha = alpha;
        m.anisotropy = anisotropy;
        m.finish();
    }
    return m;
}

std::vector<Named> white_brushed(const std::vector<float>& alphas)
{
    std::vector<Named> all;
    for (const bool metal : {true, false}) {
        for (const float alpha : alphas) {
            for (const float anisotropy : kAnisotropies) {
                const Material& m = brushed(metal, alpha, anisotropy);
                all.push_back({(metal ? "metal " : "plastic ") + short_text(alpha) + ", " + short_text(anisotropy),
                               m.bsdf(plain_values(m), 0)});
            }
        }
    }
    return all;
}

double value(const Bsdf& bsdf, const Vec3& wo, const Vec3& wi)
{
    return static_cast<double>(bsdf.eval(wo, wi).g);
}

// Looking straight down, the light's fall-off as it leans the same way along x and along y.
double stretch(const HitPoint& point, const Vec3& along, const Vec3& across)
{
    const Bsdf bsdf = point.material->bsdf(point.values, 0);
    const auto lit_from = [&](const Vec3& towards) {
        const Vec3 wi = point.frame.to_local(normalized(towards * 0.5f + point.frame.normal));
        return value(bsdf, {0, 0, 1}, wi);
    };
    return lit_from(along) / lit_from(across);
}

constexpr char kSquare[] = "mtllib m.mtl\nusemtl x\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n";
constexpr char kMapped[] = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";
// u grows along y.
constexpr char kTurned[] = "vt 0 1\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3 4/4\n";
constexpr char kUpright[] = "mtllib m.mtl\nusemtl x\nv -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nf 1 2 3 4\n";

Scene brushed_square(const std::string& obj, const std::string& mtl)
{
    const testing::ScratchFolder folder;
    folder.write("m.mtl", "newmtl x\nKd 0.8 0.8 0.8\nPr 0.5\nPm 1\n" + mtl);
    LoadOptions options;
    options.up = UpAxis::z;
    std::vector<std::string> warnings;
    Scene scene = load_scene(folder.write("s.obj", obj), options, warnings);
    REQUIRE(warnings.empty());
    return scene;
}

HitPoint seen(const Scene& scene, const Vec3& from)
{
    const Ray ray = {from * 0.9f, -from};
    const std::optional<Hit> hit = scene.data().accelerator.closest(ray);
    REQUIRE(hit);
    return hit_point_at(scene.data(), ray, *hit);
}

constexpr Vec3 kX = {1, 0, 0}, kY = {0, 1, 0}, kZ = {0, 0, 1};
constexpr double kClear = 3;  // a clear difference between along and across at aniso 0.8

}  // namespace

TEST_CASE("anisotropy: pdf integrates to one minus the samples that are lost, and samples follow it")
{
    constexpr int kFine = 16;  // cells for the narrow side of the lobe
    for (const Named& named : white_brushed({0.3f, 1.0f})) {
        check_density(named,
                      {direction_at(1, 0), direction_at(0.6f, 0), direction_at(0.6f, 0.25f), direction_at(0.1f, 0.13f)},
                      kFine);
    }
}

TEST_CASE("anisotropy: a sample's weight and pdf are those of its direction")
{
    for (const Named& named : white_brushed({0.01f, 0.05f, 0.2f, 0.5f, 1.0f})) check_weights(named, viewers());
}

TEST_CASE("anisotropy: reciprocal")
{
    for (const Named& named : white_brushed({0.01f, 0.05f, 0.2f, 0.5f, 1.0f})) check_reciprocal(named);
}

TEST_CASE("anisotropy: a white furnace neither gains nor loses energy")
{
    for (const Named& named : white_brushed({0.01f, 0.05f, 0.2f, 0.5f, 1.0f})) {
        const double loss = checked_loss(named, viewers());
        INFO(named.name << " loses " << loss);
        CHECK(loss < 0.01);
    }
}

// Smith's condition, what ties shadowing to the distribution: ∫ D(m)·<w·m> dm = cos θ / G1(w).
TEST_CASE("anisotropy: the facets that a direction sees cover what it sees of the surface")
{
    constexpr int kSteps = 700;
    const GgxOf<Anisotropic> facets({0.6f, 0.25f});
    for (const Vec3& w : viewers()) {
        double seen = 0;
        for (int h = 0; h < kSteps; ++h) {
            for (int t = 0; t < kSteps; ++t) {
                const Vec3 m =
                    direction_at((static_cast<float>(h) + 0.5f) / kSteps, (static_cast<float>(t) + 0.5f) / kSteps);
                seen += static_cast<double>(facets.density(m) * std::max(0.0f, dot(w, m)));
            }
        }
        seen *= 2 * static_cast<double>(kPi) / kSteps / kSteps;
        INFO("height " << w.z << ", x " << w.x);
        CHECK(seen == Approx(static_cast<double>(w.z / facets.masking(w))).epsilon(2e-3));
    }
}

TEST_CASE("anisotropy: with equal widths the facets are the isotropic ones")
{
    const Ggx round(0.3f);
    const GgxOf<Anisotropic> oval({0.3f, 0.3f});
    for (const Vec3& wo : viewers()) {
        for (const Vec3& wi : viewers()) {
            const Vec3 half = normalized(wo + wi);
            CHECK(oval.density(half) == round.density(half));
            CHECK(static_cast<double>(oval.masking_shadowing(wo, wi)) ==
                  Approx(static_cast<double>(round.masking_shadowing(wo, wi))).epsilon(1e-5));
        }
        const Vec3 a = oval.sample_half(wo, {0.3f, 0.8f}), b = round.sample_half(wo, {0.3f, 0.8f});
        CHECK((a.x == b.x && a.y == b.y && a.z == b.z));
    }
}

TEST_CASE("anisotropy: 0 is exactly the isotropic material, and glass knows none")
{
    const Material& m = brushed(true, 0.3f, 0);
    CHECK_FALSE(m.brushed());
    REQUIRE(m.facets.size() == 1);
    const Conductor plain(m.base, *m.facets[0]);
    for (const Vec3& wi : viewers())
        CHECK(m.bsdf(plain_values(m), 0).eval({0, 0.6f, 0.8f}, wi).g == plain.eval({0, 0.6f, 0.8f}, wi).g);
    Material pane = m;
    pane.glass = true;
    pane.anisotropy = 0.7f;
    pane.finish();
    CHECK_FALSE(pane.brushed());
}

TEST_CASE("anisotropy: highlights stretch along u, whichever side is seen, and turn with anisor")
{
    for (const Vec3& side : {kZ, -kZ}) {
        const auto measured = [&](const char* uvs, const char* mtl) {
            const Scene scene = brushed_square(std::string(kSquare) + uvs, mtl);
            return stretch(seen(scene, side), kX, kY);
        };
        INFO("from z " << side.z);
        CHECK(measured(kMapped, "aniso 0.8\n") > kClear);
        CHECK(measured(kTurned, "aniso 0.8\n") < 1 / kClear);
        CHECK(measured(kMapped, "aniso 0.8\nanisor 0.25\n") < 1 / kClear);
        CHECK(measured(kMapped, "aniso 0.8\nanisor 0.5\n") > kClear);
        CHECK(measured(kMapped, "aniso 0.8\nanisor 0.125\n") == Approx(1).epsilon(0.01));
        CHECK(measured(kMapped, "") == Approx(1).epsilon(1e-4));
    }
}

TEST_CASE("anisotropy: anisor turns counterclockwise as seen from the front")
{
    const Scene scene = brushed_square(std::string(kSquare) + kMapped, "aniso 0.8\nanisor 0.125\n");
    const Vec3 rising = normalized(kX + kY), falling = normalized(kX - kY);
    CHECK(stretch(seen(scene, kZ), rising, falling) > kClear);
    CHECK(stretch(seen(scene, -kZ), rising, falling) > kClear);
}

TEST_CASE("anisotropy: without texture coordinates highlights stretch level, around the vertical axis")
{
    const Scene upright = brushed_square(kUpright, "aniso 0.8\n");
    for (const Vec3& side : {kY, -kY}) CHECK(stretch(seen(upright, side), kX, kZ) > kClear);
    const Scene flat = brushed_square(std::string(kSquare) + "f 1 2 3 4\n", "aniso 0.8\n");
    const Frame frame = seen(flat, kZ).frame;  // any tangent will do, but there must be one
    CHECK(static_cast<double>(length(frame.tangent)) == Approx(1));
    CHECK(static_cast<double>(dot(frame.tangent, frame.normal)) == Approx(0).margin(1e-6));
}

}  // namespace lumi::baker
