// SPDX-License-Identifier: MIT
#include "lumi/chord/detail/tile.h"

#include <catch2/catch.hpp>

#include "lumi/chord/detail/stepping/outline.h"
#include "own_place.h"
#include "report.h"
#include "views.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::test;

namespace
{

constexpr int32_t kSide = 240;
constexpr int kWidthLog2 = 3;
constexpr int32_t kWidth = 1 << kWidthLog2;

struct Counts {
    int tried = 0, taken = 0;
    Worst worst;  // distance of a pixel's coordinates from its own hit's, in cells or spacings

    double share() const { return taken / static_cast<double>(tried); }
};

void compare_scanlines(const Camera& camera, int32_t x, int32_t y, const HitEvaluator& nodes, LatticeTrack& track,
                       const TileWalker& tile, Worst& worst)
{
    CellLine& line = track.line.cells;
    for (int32_t scanline = 0; scanline < kTileHeight; ++scanline) {
        line.move_down(tile.down(), scanline == 0 ? 0 : 1);
        const ScanlineRays rays = nodes.rays_from(x, y + scanline);
        for (int32_t k = 0; k < kWidth; ++k) {
            HitPair node;
            nodes.evaluate(rays, k, node);
            const LatticePoint at = {line.u_q16 + k * line.du_q16, line.v_q16 + k * line.dv_q16};
            const LatticePoint own = own_place(track, node, at);
            worst.see(std::hypot(at.u_q16 - own.u_q16, at.v_q16 - own.v_q16) / 65536.0,
                      static_cast<uint64_t>((y + scanline) * camera.width_px() + x + k));
        }
    }
}

// Sets up every tile whose surroundings lie inside the outline.
Counts count_tiles(const Camera& camera, const Lattice& points, Hit HitPair::*side)
{
    const LatticeZones lattice(points);
    LatticeTrack track(lattice, side);
    TileWalker tile(track);
    const HitEvaluator nodes(camera);
    OutlineTracker outline(camera, {0, camera.width_px()});
    Counts counts;
    for (int32_t y = 0; y + kTileHeight + 4 < camera.height_px(); y += kTileHeight) {
        const Extent middle = outline.scanline(y);
        const Extent inside = outline.columns(y > 4 ? y - 4 : 0, y + kTileHeight + 4, middle, 2);
        for (int32_t x = (inside.begin + kWidth - 1) & -kWidth; x + kWidth < inside.end; x += kWidth) {
            HitPair node[5];
            const int32_t ahead[] = {0, kWidth, 0, kWidth, kWidth / 2};
            const int32_t down[] = {0, 0, kTileHeight, kTileHeight, kTileHeight / 2};
            for (int k = 0; k < 5; ++k) nodes.evaluate(nodes.rays_from(x, y + down[k]), ahead[k], node[k]);
            ++counts.tried;
            if (!tile.prepare({&node[0], &node[1], &node[2], &node[3], &node[4]}, kWidthLog2)) continue;
            ++counts.taken;
            compare_scanlines(camera, x, y, nodes, track, tile, counts.worst);
        }
    }
    return counts;
}

}  // namespace

TEST_CASE("tiles take the sphere's inside, and run close to each pixel's own hits", "[span]")
{
    for (const View& view : extreme_views(kSide)) {
        const bool pole = view.name == "down the pole";
        if (!pole && view.name != "generic") continue;
        Camera camera;
        REQUIRE(make_camera(view.pose, view.image, camera) == CameraError::none);
        for (const int points : {1024, 4096}) {
            const Counts front = count_tiles(camera, Lattice(static_cast<uint32_t>(points)), &HitPair::front);
            const Counts back = count_tiles(camera, Lattice(static_cast<uint32_t>(points)), &HitPair::back);
            for (const Counts* side : {&front, &back}) {
                std::printf("%s, %d points: %d of %d tiles taken; %.4f of a cell off\n", view.name.c_str(), points,
                            side->taken, side->tried, side->worst.error);
                CHECK(side->share() > (pole ? 0.65 : 0.9));
                CHECK(side->worst.error < 0.3);
            }
        }
    }
}
