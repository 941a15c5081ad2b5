// SPDX-License-Identifier: MIT
// Spans at the edges of what a camera, a field and a stripe may be: under UndefinedBehaviorSanitizer no intermediate
// overflows (docs/field-format.md states ranges), and everywhere the picture is the exact one's.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "chord/drawing.h"
#include "edges.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::test;

namespace
{

#ifdef LUMI_TEST_LIGHT
constexpr uint32_t kRounds = 1;
constexpr int32_t kManyWindows = 12;
#else
constexpr uint32_t kRounds = 8;
constexpr int32_t kManyWindows = 61;
#endif
constexpr int32_t kWindow = 61;

const double kDistances[] = {1, 1.0001, 1.01, 1.3, 3, 40, 1000, 2046.99};
const double kFields[] = {1, 2, 45, 120};

// Smooth over the sphere, so that a picture tells how far hits are off: luma of the ray's ends.
OpenField smooth_luma(uint32_t origins, uint32_t directions)
{
    const TestLayout layout = layout_of(origins, directions, TexelFormat::luma8);
    const std::vector<Vec3> o = twin::points(origins);
    const std::vector<Vec3> d = twin::points(directions);
    return OpenField(layout, [&](uint32_t i, uint32_t k) {
        const Vec3& to = d[std::min(k, directions - 1)];
        return static_cast<uint8_t>(128 + 60 * std::sin(2 * o[i].x + o[i].z) + 60 * std::cos(2 * to.y - to.z));
    });
}

template <class Reconstruction>
std::vector<uint8_t> drawn(const Field& field, const Edge& edge, int32_t span_px)
{
    return drawn_window<Reconstruction, TexelLuma8, PixelGrey8>(field, camera_of(edge.pose, edge.image), OverBlack{},
                                                                span_px, edge.x, edge.y, edge.width, edge.height);
}

struct WorstPicture {
    double psnr_db = 999;
    int worst_level = 0;
    uint32_t pictures = 0, covered = 0;
    uint32_t border = 0;  // pixels at the rim that one of both covers: the outline is known to rounding only

    void see(const std::vector<uint8_t>& exact, const std::vector<uint8_t>& spans)
    {
        double sum = 0;
        uint32_t count = 0;
        for (size_t k = 0; k < exact.size(); ++k) {
            if ((exact[k] == 0) != (spans[k] == 0)) {
                ++border;
                continue;
            }
            const int d = std::abs(exact[k] - spans[k]);
            sum += d * d;
            worst_level = std::max(worst_level, d);
            count += exact[k] != 0 ? 1u : 0u;
        }
        ++pictures;
        covered += count;
        if (count > 0 && sum > 0) psnr_db = std::min(psnr_db, 10 * std::log10(255.0 * 255 * count / sum));
    }
};

}  // namespace

TEST_CASE("spans hold at every edge of the camera's range", "[span]")
{
    const OpenField open = smooth_luma(400, 700);
    const Field& field = open.field;
    Edges edges(5, kManyWindows);
    for (const int32_t span_px : {2, 8, 16}) {
        WorstPicture worst;
        for (uint32_t round = 0; round < kRounds; ++round) {
            for (const double distance : kDistances) {
                for (const double fov : kFields) {
                    const Edge edge = edges.next(distance, fov);
                    worst.see(drawn<Linear>(field, edge, 0), drawn<Linear>(field, edge, span_px));
                    (void)drawn<Nearest>(field, edge, span_px);
                }
            }
        }
        std::printf(
            "spans of %d at the camera's edges: %u pictures, %u covered pixels, lowest PSNR %.1f dB, worst pixel %d "
            "levels, %u pixels of the rim differ in coverage\n",
            static_cast<int>(span_px), static_cast<unsigned>(worst.pictures), static_cast<unsigned>(worst.covered),
            worst.psnr_db, worst.worst_level, static_cast<unsigned>(worst.border));
        CHECK(worst.covered > 1000);
        CHECK(worst.border <= 1 + worst.covered / 10000);
        CHECK(worst.psnr_db > (span_px == 16 ? 30 : 40));
    }
}

TEST_CASE("spans hold for lattices of the smallest and the largest size that they take", "[span]")
{
    // Boards have no room for the largest lattice.
#ifdef LUMI_TEST_LIGHT
    const uint32_t sizes[][2] = {{1024, kMinSpanLattice}};
#else
    const uint32_t sizes[][2] = {{kMinSpanLattice, kMaxSpanLattice}, {kMaxSpanLattice, kMinSpanLattice}};
#endif
    Edges edges(9, kWindow);
    for (const auto& size : sizes) {
        const OpenField open = smooth_luma(size[0], size[1]);
        const Field& field = open.field;
        WorstPicture worst;
        for (const double distance : kDistances) {
            for (const double fov : {2.0, 120.0}) {
                const Edge edge = edges.next(distance, fov);
                worst.see(drawn<Linear>(field, edge, 0), drawn<Linear>(field, edge, 8));
            }
        }
        std::printf("%u origins, %u directions: lowest PSNR %.1f dB, worst pixel %d levels\n",
                    static_cast<unsigned>(field.origins.size()), static_cast<unsigned>(field.directions.size()),
                    worst.psnr_db, worst.worst_level);
        CHECK(worst.psnr_db > 40);
    }
}
