// SPDX-License-Identifier: MIT
#include "light/sky.h"

#include <ImfArray.h>
#include <ImfRgbaFile.h>

#include <catch2/catch.hpp>

#include "lumi/baker/scene.h"
#include "math/sampler.h"
#include "math/warp.h"
#include "support/direction_bins.h"
#include "support/scratch_folder.h"
#include "support/statistics.h"

namespace lumi::baker
{
namespace
{

using testing::chi2_score;
using testing::kSigmas;

// Dark but for a sun and a faint band.
std::shared_ptr<RadiancePicture> sunny()
{
    auto picture = std::make_shared<RadiancePicture>();
    picture->width = 16;
    picture->height = 8;
    picture->pixels.resize(16 * 8);
    picture->pixels[2 * 16 + 5] = {50, 40, 30};
    for (size_t x = 0; x < 16; ++x) picture->pixels[6 * 16 + x] = {0.1f, 0.2f, 0.4f};
    return picture;
}

constexpr int kPictureHeights = 24, kPictureTurns = 32;

size_t picture_bin(const Vec3& d)
{
    return testing::direction_bin(d, kPictureHeights, kPictureTurns);
}

}  // namespace

TEST_CASE("sky picture: the pdf integrates to one, samples follow it, and go where light is brighter than the mean")
{
    constexpr uint32_t kSamples = 100000;
    constexpr int kFine = 16;
    const SkyPicture sky(sunny(), 0.1f, 2);
    std::vector<double> expected(kPictureHeights * kPictureTurns), counts(kPictureHeights * kPictureTurns);
    double total = 0, light = 0;
    for (int h = 0; h < kPictureHeights * kFine; ++h) {
        for (int t = 0; t < kPictureTurns * kFine; ++t) {
            const float z = (static_cast<float>(h) + 0.5f) / (kPictureHeights * kFine) * 2 - 1;
            const Vec3 d = direction_at(z, (static_cast<float>(t) + 0.5f) / (kPictureTurns * kFine));
            const double share = static_cast<double>(sky.at(d).pdf) * 4 * static_cast<double>(kPi) /
                                 (kPictureHeights * kFine * kPictureTurns * kFine);
            expected[picture_bin(d)] += share * kSamples;
            total += share;
            const SkyLight seen = sky.at(d);
            if (seen.pdf > 0)
                light += static_cast<double>(seen.radiance.r) / (kPictureHeights * kFine * kPictureTurns * kFine);
            REQUIRE((max_component(seen.radiance) < 4 || seen.pdf > 0));
        }
    }
    CHECK(total == Approx(1).epsilon(0.01));  // the grid cuts through pixels
    testing::Mean estimate;
    for (uint32_t k = 0; k < kSamples; ++k) {
        Sampler sampler(1, k, 0);
        const LightSample sample = sky.sample(sampler.next_2d());
        ++counts[picture_bin(sample.direction)];
        REQUIRE(sample.pdf == Approx(sky.at(sample.direction).pdf).epsilon(1e-3));
        estimate.add(static_cast<double>(sample.radiance.r / sample.pdf) / (4 * static_cast<double>(kPi)));
    }
    // Bins at the picture's pixel edges hold the grid's error too.
    CHECK(chi2_score(counts, expected) < 2 * kSigmas);
    CHECK(estimate.value() == Approx(light).margin(kSigmas * estimate.error() + 2e-3 * light));
}

TEST_CASE("sky picture: its middle lies at azimuth 0, its right at smaller azimuths, and it turns counterclockwise")
{
    auto picture = std::make_shared<RadiancePicture>();
    picture->width = 4;
    picture->height = 2;
    picture->pixels = {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {5, 0, 0}, {6, 0, 0}, {7, 0, 0}, {8, 0, 0}};
    // Pixel centres of the upper row lie at 135, 45, -45 and -135 degrees, 45 degrees up.
    const auto red = [&](float degrees, float turns) {
        return SkyPicture(picture, turns, 1).at(direction_at(std::sqrt(0.5f), degrees / 360)).radiance.r;
    };
    CHECK(static_cast<double>(red(45, 0)) == Approx(2).epsilon(1e-4));
    CHECK(static_cast<double>(red(-45, 0)) == Approx(3).epsilon(1e-4));
    CHECK(static_cast<double>(red(0, 0)) == Approx(2.5).epsilon(1e-4));
    CHECK(static_cast<double>(red(135, 0.25f)) == Approx(2).epsilon(1e-4));
    CHECK(static_cast<double>(SkyPicture(picture, 0, 3).at({0, 0, -1}).radiance.r) > 15);
}

TEST_CASE("sky picture: an EXR file is read, numbers that are none are named and negative ones are 0")
{
    const testing::ScratchFolder folder;
    Imf::Array2D<Imf::Rgba> pixels(2, 3);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x) pixels[y][x] = Imf::Rgba(static_cast<float>(x), static_cast<float>(y), 0.5f, 1);
    pixels[1][2].r = half::qNan();
    pixels[0][0].r = -1;
    const std::string file = folder.at("e.exr").string();
    {
        Imf::RgbaOutputFile out(file.c_str(), 3, 2, Imf::WRITE_RGBA);
        out.setFrameBuffer(&pixels[0][0], 1, 3);
        out.writePixels(2);
    }
    std::vector<std::string> warnings;
    const RadiancePicture picture = read_radiance_picture(file, warnings);
    REQUIRE(picture.width == 3);
    REQUIRE(picture.height == 2);
    CHECK(picture.at(1, 0).r == 1);
    CHECK(picture.at(1, 1).g == 1);
    CHECK(picture.at(1, 1).b == 0.5f);
    CHECK(picture.at(0, 0).r == 0);
    CHECK(is_black(picture.at(2, 1)));
    REQUIRE(warnings.size() == 1);
    CHECK_THAT(warnings[0], Catch::Contains("e.exr: 1 pixel(s)") && Catch::Contains("column 2, row 1"));
}

TEST_CASE("sky picture: an EXR header that claims a part longer than the file is refused before memory is taken")
{
    const testing::ScratchFolder folder;
    const auto file = folder.write(
        "e.exr", std::string("\x76\x2f\x31\x01\x02\0\0\0", 8) + "note" + '\0' + "of mine" + '\0' + "\xF0\xFF\xFF\x6F");
    std::vector<std::string> warnings;
    CHECK_THROWS_WITH(read_radiance_picture(file, warnings),
                      Catch::Contains("a part of its header is longer than the file"));
}

TEST_CASE("sky picture: every truncation of an EXR and an HDR file is refused or read, never a crash")
{
    const testing::ScratchFolder folder;
    const std::string file = folder.at("e.exr").string();
    {
        Imf::Array2D<Imf::Rgba> pixels(2, 3);
        Imf::RgbaOutputFile out(file.c_str(), 3, 2, Imf::WRITE_RGBA);
        out.setFrameBuffer(&pixels[0][0], 1, 3);
        out.writePixels(2);
    }
    const std::string exr = testing::read_bytes(file);
    for (size_t size = 0; size < exr.size(); ++size) {
        std::vector<std::string> warnings;
        try {
            read_radiance_picture(folder.write("t.exr", exr.substr(0, size)), warnings);
        } catch (const SceneError& e) {
            CHECK_THAT(e.what(), Catch::Contains("t.exr: ") && Catch::Contains("; "));
        }
    }
}

}  // namespace lumi::baker
