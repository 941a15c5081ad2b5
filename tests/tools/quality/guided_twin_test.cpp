// SPDX-License-Identifier: MIT
// The double-precision twin of guided fields, against closed forms.
#include <array>
#include <catch2/catch.hpp>
#include <vector>

#include "lumi/guided/guided_chart.h"
#include "lumi/host/camera.h"
#include "lumi/reference/guided_picture.h"

using namespace lumi;

namespace
{

// A guided field in memory: a square plate at height z, mean colours affine in X, if wanted a chart of one colour.
class PlateField
{
public:
    static constexpr uint32_t kOrigins = 64, kChart = 64, kMean = 8;

    explicit PlateField(uint16_t height = 2048)
    {
        put_triples(vertices_,
                    {{1024, 1024, height}, {3072, 1024, height}, {3072, 3072, height}, {1024, 3072, height}});
        put_triples(triangles_, {{0, 1, 2}, {0, 2, 3}});
        field.origins = Lattice(kOrigins);
        field.used_origins = kOrigins;
        field.chart_size = kChart;
        field.proxy = {vertices_.data(), triangles_.data(), 4, 2, false};
    }

    // Node colours r = 16x, g = 16y, b = 100 in node numbers: palette entry (x, y).
    void add_mean()
    {
        palette_.resize(256 * 4);
        for (uint32_t k = 0; k < 256; ++k) {
            palette_[4 * k] = static_cast<uint8_t>(16 * (k % 16));
            palette_[4 * k + 1] = static_cast<uint8_t>(16 * (k / 16));
            palette_[4 * k + 2] = 100;
        }
        for (uint32_t brick = 0; brick < 27; ++brick) {
            index_.push_back(static_cast<uint8_t>(brick));
            index_.push_back(0);
            for (uint32_t n = 0; n < format::kBrickNodes; ++n)
                bricks_.push_back(static_cast<uint8_t>((brick % 3 * 4 + n % 4) + 16 * (brick / 3 % 3 * 4 + n / 4 % 4)));
        }
        field.mean = {palette_.data(),
                      index_.data(),
                      bricks_.data(),
                      kMean,
                      format::MeanFormat::palette8,
                      {0, 0, 0},
                      {3, 3, 3},
                      27};
    }

    // Every texel of every origin is colour 1.
    void add_chart(std::array<uint8_t, 3> colour)
    {
        constexpr uint32_t kSide = 2 * kChart;
        fill_table(field.chart, chart_, kSide, std::vector<uint8_t>(kSide * kSide / 2, 0x11), kSide * kSide);
        colours_ = {0, 0, 0, 0, colour[0], colour[1], colour[2], 0};
        colours_.resize(16 * 4);
        field.texel = format::GuidedTexel::index4;
        field.origins_per_palette = kOrigins;
        field.colours = colours_.data();
    }

    void add_occlusion(uint8_t depth)
    {
        constexpr uint32_t kSide = 2 * kChart / 8;
        fill_table(field.occlusion, occlusion_, kSide, std::vector<uint8_t>(kSide * kSide, depth), kSide * kSide);
    }

    GuidedField field;

private:
    struct Table {
        std::vector<uint8_t> directory, rows, texels;
    };

    static void put_triples(std::vector<uint8_t>& bytes, const std::vector<std::array<uint16_t, 3>>& triples)
    {
        bytes.assign(format::triples_bytes(static_cast<uint32_t>(triples.size())) + 9, 0);
        size_t bit = 0;
        for (const auto& triple : triples)
            for (const uint16_t value : triple)
                for (int k = 0; k < 12; ++k, ++bit)
                    bytes[bit / 8] = static_cast<uint8_t>(bytes[bit / 8] | (value >> k & 1) << bit % 8);
    }

    // All origins share one square of texels.
    static void fill_table(ChartTable& table, Table& bytes, uint32_t side, std::vector<uint8_t> texels, uint32_t count)
    {
        for (uint32_t i = 0; i < kOrigins; ++i) {
            bytes.directory.resize(bytes.directory.size() + format::chart::kEntryBytes);
            bytes.directory[bytes.directory.size() - 2] = static_cast<uint8_t>(side);
        }
        for (uint32_t v = 0; v < side; ++v) {
            bytes.rows.push_back(static_cast<uint8_t>(v * side));
            bytes.rows.push_back(static_cast<uint8_t>(v * side >> 8));
        }
        bytes.texels = std::move(texels);
        table = {bytes.directory.data(), bytes.rows.data(), bytes.texels.data(), side, count};
    }

    std::vector<uint8_t> vertices_, triangles_, palette_, index_, bricks_, colours_;
    Table chart_, occlusion_;
};

const Image kImage = host::make_image(40, 40, 40);

reference::GuidedPicture drawn(const PlateField& plate, double elevation_deg, bool antialiased)
{
    return reference::draw_guided(plate.field, host::make_pose({10, elevation_deg, 3}), kImage, {antialiased, {}},
                                  {7, 8, 9});
}

const reference::Colour& middle_of(const reference::GuidedPicture& picture)
{
    return picture.colours[20 * 40 + 20];
}

}  // namespace

TEST_CASE("the twin shows the mean colour of the point that a ray meets")
{
    PlateField plate;
    plate.add_mean();
    const Pose pose = host::make_pose({10, 90, 3});
    const auto picture = drawn(plate, 90, false);
    const auto hits = reference::proxy_hits(plate.field.proxy, pose, kImage, false);
    int covered = 0;
    for (size_t i = 0; i < hits.size(); ++i) {
        if (!hits[i].hit) continue;
        ++covered;
        CHECK(hits[i].x.z == Approx(0).margin(1e-9));
        CHECK(picture.colours[i].r == Approx(16 * 4 * (hits[i].x.x + 1)).margin(1e-6));
        CHECK(picture.colours[i].g == Approx(16 * 4 * (hits[i].x.y + 1)).margin(1e-6));
        CHECK(picture.colours[i].b == Approx(100));
    }
    CHECK(covered > 200);
}

TEST_CASE("the twin's ray hits agree with the plate's plane at a slant")
{
    const PlateField plate;
    const Pose pose = host::make_pose({33, 25, 2});
    const auto hits = reference::proxy_hits(plate.field.proxy, pose, kImage, true);
    int covered = 0;
    for (const auto& hit : hits) {
        if (!hit.hit) continue;
        ++covered;
        CHECK(std::fabs(hit.x.z) < 1e-9);
        CHECK(std::max(std::fabs(hit.x.x), std::fabs(hit.x.y)) <= 0.5 + 1e-9);
    }
    CHECK(covered > 500);
}

TEST_CASE("the twin culls back faces unless the proxy is two-sided")
{
    PlateField plate;
    plate.add_mean();
    CHECK(middle_of(drawn(plate, -90, true)).b == 9);
    plate.field.proxy.two_sided = true;
    CHECK(middle_of(drawn(plate, -90, true)).b == Approx(100));
}

TEST_CASE("the twin adds chart differences to the mean, and takes chart colours without one")
{
    PlateField plate;
    plate.add_chart({30, 250, 60});  // as a difference: 30, -6, 60
    CHECK(middle_of(drawn(plate, 70, false)).g == Approx(250));
    plate.add_mean();
    const auto with = drawn(plate, 70, false);
    plate.field.texel = format::GuidedTexel::none;
    const auto without = drawn(plate, 70, false);
    CHECK(middle_of(with).r - middle_of(without).r == Approx(30));
    CHECK(middle_of(with).g - middle_of(without).g == Approx(-6));
    CHECK(middle_of(with).b - middle_of(without).b == Approx(60));
}

TEST_CASE("the twin leaves out origins from which the surface is hidden")
{
    PlateField plate;
    plate.add_chart({30, 250, 60});
    plate.add_occlusion(64);  // half a radius
    CHECK(middle_of(drawn(plate, 70, false)).g == 8);
    plate.add_occlusion(255);
    CHECK(middle_of(drawn(plate, 70, false)).g == Approx(250));
}

TEST_CASE("the twin's coverage is the share of a pixel's samples, blended in encoded values")
{
    PlateField plate;
    plate.add_mean();
    const auto picture = drawn(plate, 90, true);
    int partly = 0;
    for (size_t i = 0; i < picture.coverage.size(); ++i) {
        const double a = picture.coverage[i];
        CHECK(4 * a == std::round(4 * a));
        if (a > 0 && a < 1) ++partly;
        CHECK(picture.colours[i].b == Approx(a * 100 + (1 - a) * 9));
    }
    CHECK(partly > 20);
}

TEST_CASE("the twin's chart is centred on the ray through the sphere's centre and uniform in area")
{
    const PlateField plate;
    for (const uint32_t origin : {0u, 17u, 63u}) {
        const auto centre = reference::chart_place(plate.field, origin, {0, 0, 0});
        const double c = format::chart_centre(PlateField::kChart);
        CHECK(std::hypot(centre.u - c, centre.v - c) < 0.02);
        // A point whose ray leaves the sphere's centre line by half a right angle: a² + b² = 1/2.
        const auto p = reference::point(PlateField::kOrigins, origin);
        const ChartFrame frame = chart_frame(point(plate.field.origins, origin));
        const int16_t* tangent = frame.tangent_q14;
        const auto t = reference::decoded(Vec3q30{tangent[0] * 65536, tangent[1] * 65536, tangent[2] * 65536});
        const auto aside = reference::chart_place(plate.field, origin, 0.5 * (t - p) + p);
        CHECK(aside.u - c == Approx(std::sqrt(0.5) * PlateField::kChart / 2).margin(0.02));
        CHECK(aside.v - c == Approx(0).margin(0.02));
    }
}
