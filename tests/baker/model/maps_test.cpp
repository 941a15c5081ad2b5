// SPDX-License-Identifier: MIT
// Pictures of every kind on a square, from MTL to light.
#include <catch2/catch.hpp>

#include "image/tone.h"
#include "model/readers.h"
#include "support/brute_force.h"
#include "support/picture_bytes.h"
#include "support/scratch_folder.h"

namespace lumi::baker
{
namespace
{

using testing::kSigmas;
using testing::Mean;

// A square of side 2 in the plane z = 0; the picture's lower left corner lies at (-1,-1).
constexpr char kSquare[] =
    "mtllib m.mtl\nusemtl x\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "f 1/1 2/2 3/3 4/4\n";

Scene square(const std::string& mtl, const std::array<uint8_t, 6>& bytes, const Environment& environment)
{
    const testing::ScratchFolder folder;
    folder.write("m.mtl", "newmtl x\n" + mtl);
    folder.write("t.png", testing::rgb_png(2, {bytes.begin(), bytes.end()}));  // side by side
    LoadOptions options;
    options.up = UpAxis::z;
    options.environment = environment;
    options.exposure_stops = 0;
    std::vector<std::string> warnings;
    Scene scene = load_scene(folder.write("s.obj", kSquare), options, warnings);
    INFO((warnings.empty() ? "" : warnings[0]));
    REQUIRE(warnings.empty());
    return scene;
}

// Looking straight down at the middle of the left (x = -1/2) or right pixel, in units of the scene.
Ray down_at(const Scene& scene, float x)
{
    return {{x / scene.radius(), 0, 0.9f}, {0, 0, -1}};
}

HitPoint point_below(const Scene& scene, float x)
{
    const Ray ray = down_at(scene, x);
    const std::optional<Hit> hit = scene.data().accelerator.closest(ray);
    REQUIRE(hit);
    return hit_point_at(scene.data(), ray, *hit);
}

double coverage(const Scene& scene, float x)
{
    const PathTracer tracer(scene.data());
    Mean mean;
    for (uint32_t k = 0; k < 2000; ++k) {
        Sampler sampler(1, k, 0);
        mean.add(tracer.trace(down_at(scene, x), sampler).covered ? 1 : 0);
    }
    return mean.value();
}

}  // namespace

TEST_CASE("maps: map_Ke shines where the picture does, and is found by aiming and by looking alike")
{
    const Scene scene = square("Kd 0 0 0\nKe 2 2 2\nmap_Ke t.png\n", {255, 255, 255, 0, 0, 0}, constant_environment(0));
    CHECK(static_cast<double>(point_below(scene, -0.5f).emission.g) == Approx(2));
    CHECK(static_cast<double>(point_below(scene, 0.5f).emission.g) == Approx(0).margin(1e-6));
    const Vec3 from = {0.1f, 0.05f, 0.3f};
    Mean aimed, looked;
    for (uint32_t k = 0; k < 100000; ++k) {
        Sampler sampler(2, k, 0);
        const Vec2 choice = sampler.next_2d();
        double arrived = 0;
        scene.data().lights.sample(from, {choice, sampler.next_2d()}, [&](const LightSample& s, float) {
            if (s.pdf > 0) arrived = static_cast<double>(s.radiance.g / s.pdf);
        });
        aimed.add(arrived);
        const Ray ray = {from, square_to_sphere(sampler.next_2d())};
        const std::optional<Hit> hit = scene.data().accelerator.closest(ray);
        const double seen = hit ? static_cast<double>(hit_point_at(scene.data(), ray, *hit).emission.g) : 0;
        looked.add(seen * 4 * static_cast<double>(kPi));
    }
    CHECK(std::abs(aimed.value() - looked.value()) < kSigmas * std::hypot(aimed.error(), looked.error()));
    CHECK(aimed.error() < looked.error());
}

TEST_CASE("maps: map_d cuts out, for the eye and for light")
{
    const Scene scene = square("Kd 1 1 1\nmap_d t.png\n", {255, 255, 255, 0, 0, 0}, constant_environment(1));
    CHECK(coverage(scene, -0.5f) > 0.99);
    CHECK(coverage(scene, 0.5f) < 0.01);
    CHECK(transmittance(scene.data(), down_at(scene, -0.5f)).g < 1e-3f);
    CHECK(transmittance(scene.data(), down_at(scene, 0.5f)).g > 0.999f);
}

TEST_CASE("maps: map_Pr and map_Pm multiply their numbers, read as plain bytes")
{
    const Scene scene = square("Kd 1 1 1\nPr 1\nPm 0.5\nmap_Pr t.png\nmap_Pm t.png\n", {255, 255, 255, 51, 51, 51},
                               gradient_environment());
    CHECK(static_cast<double>(point_below(scene, 0.5f).values.roughness) == Approx(0.2));
    CHECK(static_cast<double>(point_below(scene, 0.5f).values.metalness) == Approx(0.1));
    CHECK(static_cast<double>(point_below(scene, -0.5f).values.metalness) == Approx(0.5));
    // The rougher side spreads a mirror's light further.
    const Vec3 wo = normalized(Vec3{0.3f, 0, 1}), mirror = {-wo.x, -wo.y, wo.z};
    const Material& m = *point_below(scene, 0.5f).material;
    const auto peak = [&](float x) { return m.bsdf(point_below(scene, x).values, 0).eval(wo, mirror).g; };
    CHECK(peak(0.5f) > 20 * peak(-0.5f));
}

TEST_CASE("maps: Ps, aniso and anisor are read, and map_Ps multiplies Ps or stands alone")
{
    const Scene scene = square("Kd 1 1 1\nPr 0.5\nPs 0.5\nmap_Ps t.png\naniso 0.6\nanisor 0.25\n",
                               {255, 255, 255, 51, 51, 51}, gradient_environment());
    const HitPoint left = point_below(scene, -0.5f), right = point_below(scene, 0.5f);
    CHECK(left.material->anisotropy == 0.6f);
    CHECK(left.material->anisotropy_turns == 0.25f);
    CHECK(left.material->brushed());
    CHECK(static_cast<double>(left.values.sheen) == Approx(0.5 / 6));
    CHECK(static_cast<double>(right.values.sheen) == Approx(0.1 / 6));
    const Scene alone = square("Kd 0 0 0\nmap_Ps t.png\n", {255, 255, 255, 0, 0, 0}, gradient_environment());
    CHECK(static_cast<double>(point_below(alone, -0.5f).values.sheen) == Approx(1.0 / 6));
    const HitPoint bald = point_below(alone, 0.5f);
    const float sent = bald.material->bsdf(bald.values, 0).eval({0, 0.6f, 0.8f}, {0, 0.8f, 0.6f}).g;
    CHECK(static_cast<double>(sent) == Approx(0).margin(1e-6));
}

TEST_CASE("maps: a normal map bends towards u and v on either side, a flat one not at all")
{
    const Scene scene = square("Kd 1 1 1\nnorm t.png\n", {128, 128, 255, 218, 128, 218}, gradient_environment());
    CHECK(static_cast<double>(point_below(scene, -0.5f).frame.normal.z) == Approx(1).epsilon(1e-3));
    const Vec3 bent = point_below(scene, 0.5f).frame.normal;
    CHECK(static_cast<double>(bent.x) == Approx(std::sqrt(0.5)).epsilon(0.01));
    CHECK(static_cast<double>(bent.y) == Approx(0).margin(0.01));
    const Ray up = {{0.5f / scene.radius(), 0, -0.9f}, {0, 0, 1}};
    const HitPoint below = hit_point_at(scene.data(), up, *scene.data().accelerator.closest(up));
    CHECK(static_cast<double>(below.frame.normal.x) == Approx(static_cast<double>(-bent.x)).margin(1e-4));
    CHECK(below.frame.normal.z < 0);
}

TEST_CASE("maps: a grey bump map is a height map whose slopes face downhill")
{
    Texture heights{4, 1, {}, false};
    for (const uint8_t h : std::array<uint8_t, 4>{0, 32, 64, 32}) heights.rgb.insert(heights.rgb.end(), 3, h);
    REQUIRE(is_grey(heights));
    const Texture normals = normals_from_heights(heights, 1);
    // Pixel 1 climbs 32 steps a pixel to the right: 45 degrees, facing left.
    CHECK(static_cast<int>(normals.rgb[3]) == Approx(127.5 - 127.5 * std::sqrt(0.5)).margin(1));
    CHECK(static_cast<int>(normals.rgb[3 + 2]) == Approx(127.5 + 127.5 * std::sqrt(0.5)).margin(1));
    CHECK(static_cast<int>(normals.rgb[6]) == Approx(127.5).margin(1));
    CHECK(static_cast<int>(normals_from_heights(heights, 0).rgb[3]) == Approx(127.5).margin(1));
}

TEST_CASE("maps: MTL's scale and offset move a picture, with as many numbers as are given")
{
    for (const char* options : {"-s 0.25 1 1 -o 0.5 0 0", "-s 0.25 -o 0.5", "-clamp off -s 0.25 1 -mm 0 1 -o 0.5 0"}) {
        CAPTURE(options);
        const Scene scene = square("Kd 1 1 1\nmap_Kd " + std::string(options) + " t.png\n", {255, 0, 0, 0, 255, 0},
                                   gradient_environment());
        // u runs from 0.5 to 0.75: the right pixel's left half.
        CHECK(point_below(scene, 0.98f).values.base.g > 0.95f);
        CHECK(point_below(scene, -0.98f).values.base.g == Approx(0.5).margin(0.05));
    }
}

TEST_CASE("maps: what MTL calls glass is glass, and thin paint is not")
{
    const auto material = [](const std::string& mtl) {
        const testing::ScratchFolder folder;
        folder.write("m.mtl", "newmtl x\nKd 0.5 0.5 0.5\n" + mtl);
        std::vector<std::string> warnings;
        const std::string body =
            "mtllib m.mtl\nusemtl x\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
        return load_scene(folder.write("s.obj", body), {}, warnings).data().materials[0];
    };
    for (const char* mtl :
         {"illum 7\nNi 1.5\n", "illum 6\nNi 1.5\nd 0.5\n", "illum 4\nNi 1.5\n", "illum 9\nNi 1.5\nd 0.5\nTf 1 1 1\n"}) {
        INFO(mtl);
        CHECK(material(mtl).glass);
        CHECK(material(mtl).opacity == 1);
    }
    for (const char* mtl : {"illum 2\nNi 1.5\n", "illum 4\nNi 1\nTf 1 1 1\n", "illum 9\nNi 1.5\nd 0.5\n",
                            "illum 7\nNi 1.5\nTf 0 0 0\n"}) {
        INFO(mtl);
        CHECK_FALSE(material(mtl).glass);
    }
    // As Blender writes transmission; without Pr, many exporters write Tf 1 1 1 for what is opaque.
    CHECK(material("Ni 1.45\nillum 2\nPr 0\nTf 1 1 1\n").glass);
    CHECK(material("Ni 1.45\nillum 2\nPr 0.4\nTf 1 1 1\n").frosts.at(0));
    CHECK_FALSE(material("Ni 1.45\nillum 2\nTf 1 1 1\n").glass);
    CHECK_FALSE(material("Ni 1.45\nillum 2\nPr 0\nTf 0.1 0.1 0.1\n").glass);
    const Material frosted = material("illum 7\nNi 1.33\nPr 0.5\nTf 0.5 1 1\n");
    REQUIRE(frosted.frosts.at(0));
    CHECK(static_cast<double>(frosted.frosts.at(0)->alpha()) == Approx(0.25));
    const Material coated = material("Pc 0.5\nPcr 0.3\n");
    CHECK(coated.coat == 0.125f);
    CHECK(static_cast<double>(coated.coat_alpha) == Approx(0.09));
    CHECK_FALSE(material("Pr 0.2\n").coat_skin);
}

TEST_CASE("maps: a sheet of MTL's glass is a pane that colours once, with a warning")
{
    const testing::ScratchFolder folder;
    folder.write("m.mtl", "newmtl x\nillum 7\nNi 1.5\nTf 0.5 1 0.25\n");
    std::vector<std::string> warnings;
    const Material pane = read_obj(folder.write("s.obj", kSquare), warnings).materials[0];
    CHECK(pane.thin);
    CHECK_FALSE(pane.glass);
    CHECK(pane.tint.b == 0.25f);
    REQUIRE(warnings.size() == 1);
    CHECK_THAT(warnings[0], Catch::Contains("thin panes"));
}

TEST_CASE("maps: Pr 0 is smooth, also without Ns")
{
    const testing::ScratchFolder folder;
    folder.write("m.mtl", "newmtl x\nKd 0.5 0.5 0.5\nKs 0.5 0.5 0.5\nPr 0.000000\nPm 0\n");
    std::vector<std::string> warnings;
    const Scene scene = load_scene(folder.write("s.obj", kSquare), {}, warnings);
    CHECK(scene.data().materials[0].alpha == kMinAlpha);
    CHECK(scene.data().materials[0].specular);
}

TEST_CASE("tone: the named curves have their values")
{
    CHECK(toned(ToneCurve::srgb, grey(3)).g == 3);
    CHECK(static_cast<double>(toned(ToneCurve::reinhard, grey(3)).g) == Approx(0.75));
    CHECK(static_cast<double>(toned(ToneCurve::aces, grey(0)).g) == 0);
    for (const ToneCurve curve : {ToneCurve::srgb, ToneCurve::reinhard, ToneCurve::aces, ToneCurve::agx})
        for (const float none : {-0.01f, -1.0f, -100.0f}) CHECK(toned(curve, grey(none)).g <= 0);
    CHECK(static_cast<double>(toned(ToneCurve::aces, grey(1)).g) == Approx(2.54 / 3.16));
    // Hue stays under Reinhard's curve of luminance.
    const Rgb c = toned(ToneCurve::reinhard, {2, 1, 0.5f});
    CHECK(static_cast<double>(c.r / c.b) == Approx(4));
}

TEST_CASE("tone: AgX keeps greys and middle grey, never clips light, and lets a strong red fade to white")
{
    const auto agx = [](const Rgb& c) { return toned(ToneCurve::agx, c); };
    CHECK(is_black(agx({})));
    CHECK(agx(grey(0.18f)).g == Approx(0.18).epsilon(0.005));
    float before = 0;
    for (float light = 1e-4f; light < 1e4f; light *= 2) {
        const Rgb c = agx(grey(light));
        CHECK(c.r == Approx(c.b).epsilon(1e-5));
        CHECK(c.g > before);
        CHECK(c.g < 1);
        before = c.g;
    }
    float green = 0;
    for (const float light : {0.5f, 2.0f, 8.0f, 32.0f, 1000.0f}) {
        const Rgb red = agx({light, 0.1f * light, 0.1f * light});
        CHECK(red.r > red.g);
        CHECK(red.g > green);
        green = red.g;
    }
    CHECK(green > 0.95f);
}

}  // namespace lumi::baker
