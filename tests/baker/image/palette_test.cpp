// SPDX-License-Identifier: MIT
#include "image/palette.h"

#include <catch2/catch.hpp>

#include "math/sampler.h"

namespace lumi::baker
{
namespace
{

std::vector<detail::Rgba8> cloud(uint32_t count)
{
    std::vector<detail::Rgba8> colours;
    for (uint32_t k = 0; k < count; ++k) {
        Sampler sampler(1, k, 0);
        const Vec2 u = sampler.next_2d();
        const float a = sampler.next_1d() < 0.8f ? 255 : 128;
        colours.push_back({static_cast<uint8_t>(u.x * a), static_cast<uint8_t>(u.y * a),
                           static_cast<uint8_t>(u.x * u.y * a), static_cast<uint8_t>(a)});
    }
    return colours;
}

}  // namespace

TEST_CASE("palette: entry 0 is transparent, all entries are premultiplied")
{
    const Palette palette = fit_palette(cloud(5000));
    CHECK(palette[0].a == 0);
    for (const detail::Rgba8& c : palette) {
        CHECK(c.r <= c.a);
        CHECK(c.g <= c.a);
        CHECK(c.b <= c.a);
    }
    CHECK(nearest_entry(palette, {0, 0, 0, 0}) == 0);
}

TEST_CASE("palette: up to 255 colours are kept exactly")
{
    std::vector<detail::Rgba8> colours;
    for (int k = 0; k < 255; ++k)
        colours.push_back({static_cast<uint8_t>(k), static_cast<uint8_t>(255 - k), static_cast<uint8_t>(k / 2), 255});
    const Palette palette = fit_palette(colours);
    for (const detail::Rgba8& c : colours) {
        const detail::Rgba8& found = palette[nearest_entry(palette, c)];
        CHECK((found.r == c.r && found.g == c.g && found.b == c.b && found.a == c.a));
    }
}

TEST_CASE("palette: a two-dimensional cloud of colours is met within a few levels")
{
    const std::vector<detail::Rgba8> colours = cloud(20000);
    const Palette palette = fit_palette(colours);
    double squares = 0;
    for (const detail::Rgba8& c : colours) {
        const detail::Rgba8& f = palette[nearest_entry(palette, c)];
        squares += (c.r - f.r) * (c.r - f.r) + (c.g - f.g) * (c.g - f.g) + (c.b - f.b) * (c.b - f.b);
    }
    const double rms = std::sqrt(squares / 3 / static_cast<double>(colours.size()));
    INFO("rms error " << rms);
    CHECK(rms < 6);  // 256 cells on a unit square have an rms error of 255/16/√12 = 4.6 a side
}

TEST_CASE("palette: the same samples give the same palette, none give an empty one")
{
    const Palette a = fit_palette(cloud(3000)), b = fit_palette(cloud(3000));
    for (size_t k = 0; k < a.size(); ++k)
        CHECK((a[k].r == b[k].r && a[k].g == b[k].g && a[k].b == b[k].b && a[k].a == b[k].a));
    CHECK(fit_palette({})[255].a == 0);
    CHECK(fit_palette({{0, 0, 0, 0}})[1].a == 0);
}

TEST_CASE("k-means finds clusters that lie apart, and keeps fixed centres")
{
    std::vector<ColourPoint> points;
    for (int k = 0; k < 300; ++k)
        points.push_back({static_cast<float>(100 * (k % 3)), static_cast<float>(k / 3 % 5), 0, 0});
    const std::vector<ColourPoint> centres = k_means(points, {{-50, 0, 0, 0}}, 4, 1);
    REQUIRE(centres.size() == 4);
    CHECK(centres[0] == ColourPoint{-50, 0, 0, 0});
    for (const ColourPoint& p : points) CHECK(nearest_centre(centres, p).distance2 < 4.1f);
    CHECK(k_means(points, {}, 200, 1).size() == 15);  // no more than there are different points
    CHECK(k_means(std::vector<ColourPoint>(), {}, 16, 1).empty());
}

}  // namespace lumi::baker
