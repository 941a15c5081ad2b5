// SPDX-License-Identifier: MIT
// Exact pixels against brute force in double precision that shares nothing with core: rays of the pose, the plain
// quadratic equation, and a look at every point of both lattices. Texels are random: nothing shows errors more.
#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <string>

#include "field_bytes.h"
#include "lumi/chord/render.h"
#include "lumi/twin/picture.h"
#include "report.h"
#include "twin.h"
#include "views.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::test;

namespace
{

constexpr uint32_t kKernelPoints = 5;
constexpr double kMostLevels = 3;
constexpr double kLeastDb = 60;
// Distances that differ by less than this share of the spacing may be taken for each other.
constexpr double kNearTie = 1e-3;
// The camera's roundings move a hit by 2^-20, at the rim by 2^-15.6 (sphere.h).
constexpr double kHitError = 1.0 / (1 << 19), kRimHitError = 1.0 / (1 << 15);

class RandomField
{
public:
    RandomField(uint32_t origins, uint32_t directions)
        : origins_(twin::points(origins)), directions_(twin::points(directions))
    {
        TestLayout layout;
        layout.origins = layout.used_origins = origins;
        layout.directions = directions;
        layout.texel = TexelFormat::luma8;
        std::minstd_rand random(origins * 7 + directions);
        bytes_ = file_of({layout_section(layout), texel_section(layout, [&](uint32_t, uint32_t) {
                              return static_cast<uint8_t>(1 + random() % 255);
                          })});
        REQUIRE(open_field(bytes_.data(), bytes_.size(), field_) == FieldError::none);
    }

    const Field& field() const { return field_; }
    const std::vector<Vec3>& origins() const { return origins_; }
    const std::vector<Vec3>& directions() const { return directions_; }
    uint8_t texel(uint32_t i, uint32_t j) const { return field_.row(i)[j]; }

private:
    Bytes bytes_;
    Field field_;
    std::vector<Vec3> origins_, directions_;
};

// The points that a hit may read.
struct Around {
    std::vector<uint32_t> nearest;  // more than one near a tie
    twin::Weights kernel;
};

Around around(const std::vector<Vec3>& all, const Vec3& q, double hit_error)
{
    const double spacing = twin::spacing(static_cast<uint32_t>(all.size()));
    const double within = 1.2 * spacing;  // no place is farther from a point
    twin::Weights near;
    for (uint32_t i = 0; i < all.size(); ++i) {
        const Vec3 way = all[i] - q;
        const double square = twin::dot(way, way);
        if (square < within * within) near.emplace_back(i, std::sqrt(square));
    }
    std::sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    Around result;
    double sum = 0;
    for (const auto& [i, distance] : near) {
        if (distance < near[0].second + kNearTie * spacing + 2 * hit_error) result.nearest.push_back(i);
        if (result.kernel.size() == kKernelPoints || distance >= spacing) continue;
        const double inside = 1 - distance * distance / (spacing * spacing);
        result.kernel.emplace_back(i, inside * inside);
        sum += inside * inside;
    }
    for (auto& [i, weight] : result.kernel) weight /= sum;
    return result;
}

struct Errors {
    Worst levels;
    double squares = 0;
    uint32_t pixels = 0, wrong_nearest = 0;

    double db() const { return 10 * std::log10(255.0 * 255 * pixels / std::max(squares, 1e-9)); }
};

template <class Reconstruction>
std::vector<uint8_t> drawn(const Field& field, const Camera& camera)
{
    std::vector<uint8_t> pixels(static_cast<size_t>(camera.width_px() * camera.height_px()));
    const Stripe stripe = {
        pixels.data(), 0, 0, camera.width_px(), camera.height_px(), static_cast<uint32_t>(camera.width_px())};
    REQUIRE(render<Reconstruction, TexelLuma8, PixelGrey8>(field, camera, OverColour{{0, 0, 0}}, stripe) ==
            RenderError::none);
    return pixels;
}

void compare_pixel(const RandomField& scene, const twin::Hits& hit, double hit_error, uint8_t nearest, uint8_t kernel,
                   Errors& errors)
{
    const Around front = around(scene.origins(), hit.front, hit_error);
    const Around back = around(scene.directions(), hit.back, hit_error);
    double truth = 0;
    for (const auto& [i, wi] : front.kernel)
        for (const auto& [j, wj] : back.kernel) truth += wi * wj * scene.texel(i, j);
    const double error = std::fabs(std::round(truth) - kernel);  // a picture of 8 bits is the best that there is
    errors.levels.see(error, errors.pixels);
    errors.squares += error * error;
    bool right = false;
    for (const uint32_t i : front.nearest)
        for (const uint32_t j : back.nearest) right = right || scene.texel(i, j) == nearest;
    errors.wrong_nearest += !right;
    ++errors.pixels;
}

void compare(const RandomField& scene, const View& view, Errors& errors)
{
    Camera camera;
    REQUIRE(make_camera(view.pose, view.image, camera) == CameraError::none);
    const std::vector<uint8_t> nearest = drawn<Nearest>(scene.field(), camera);
    const std::vector<uint8_t> kernel = drawn<Paper<kKernelPoints>>(scene.field(), camera);
    for (int32_t y = 0; y < camera.height_px(); ++y) {
        for (int32_t x = 0; x < camera.width_px(); ++x) {
            SphereRay ray;
            if (!ray_at(camera, x, y, ray)) continue;
            const twin::Hits hit = twin::hits_of_pixel(view.pose, view.image, x, y);
            const bool rim = twin::length(hit.back - hit.front) < 0.5;
            const auto at = static_cast<size_t>(y * camera.width_px() + x);
            compare_pixel(scene, hit, rim ? kRimHitError : kHitError, nearest[at], kernel[at], errors);
        }
    }
}

struct Sizes {
    uint32_t origins, directions;
    int32_t side_px;
};

#ifdef LUMI_TEST_LIGHT
const std::vector<Sizes> kSizes = {{1, 63, 7}, {5, 64, 7}, {100, 150, 7}};
#else
const std::vector<Sizes> kSizes = {{1, 1, 9},      {2, 3, 9},      {5, 63, 25},      {64, 64, 33},   {65, 100, 33},
                                   {100, 200, 33}, {500, 377, 33}, {1024, 2048, 33}, {5, 65536, 15}, {3, 1u << 20, 7}};
#endif

// Where the sphere is seen whole, at both poles and across the seam, and from near by.
std::vector<View> views_of(int32_t side_px)
{
    std::vector<View> views;
    for (const View& view : extreme_views(side_px))
        if (view.name == "generic" || view.name == "down the pole" || view.name == "up the pole" ||
            view.name == "across the seam" || view.name == "eye at 1.01 R" || view.name == "pole close by")
            views.push_back(view);
    return views;
}

}  // namespace

TEST_CASE("exact pixels of random texels agree with brute force", "[render]")
{
    for (const Sizes& sizes : kSizes) {
        const RandomField scene(sizes.origins, sizes.directions);
        Errors errors;
        for (const View& view : views_of(sizes.side_px)) compare(scene, view, errors);
        const std::string name = std::to_string(sizes.origins) + " x " + std::to_string(sizes.directions);
        errors.levels.report((name + ", paper, levels; dB " + std::to_string(errors.db())).c_str());
        INFO(name);
        CHECK(errors.levels.error <= kMostLevels);
        CHECK(errors.db() >= kLeastDb);
        CHECK(errors.wrong_nearest == 0);
    }
}
