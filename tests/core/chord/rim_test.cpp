// SPDX-License-Identifier: MIT
#include "lumi/detail/chord/rim.h"

#include <catch2/catch.hpp>

#include "lumi/detail/stepping/outline.h"
#include "lumi/detail/chord/tile.h"
#include "own_place.h"
#include "report.h"
#include "views.h"

using namespace lumi;
using namespace lumi::test;

namespace
{

constexpr int32_t kSide = 240;

struct Counts {
    int tried = 0, taken = 0;
    Worst worst;  // distance of a pixel's coordinates from its own hit's, in cells
};

struct Rim {
    bool left;
    int32_t inner;  // column of the tiles
};

void compare_side(const SpanTrack& track, const SpanNode& node, Counts& counts, uint64_t pixel)
{
    const LatticePoint at = {track.side.u_q16, track.side.v_q16};
    const LatticePoint own = own_place(track, node, at);
    counts.worst.see(std::hypot(at.u_q16 - own.u_q16, at.v_q16 - own.v_q16) / 65536.0, pixel);
}

// Every pixel of the rim, as the beginning of a span of its own.
void compare_rows(const Rim& rim, int32_t y, const NodeEvaluator& nodes, OutlineTracker& outline, SpanRim& drawn,
                  const SpanTrack& front, const SpanTrack& back, Counts& counts)
{
    for (int32_t row = 0; row < kTileRows; ++row) {
        const RowSpan span = outline.row(y + row);
        const int32_t begin = rim.left ? span.begin : rim.inner;
        const int32_t end = rim.left ? rim.inner : span.end;
        for (int32_t x = begin; x < end; ++x) {
            const RayRow rays = nodes.row_at(x, y + row);
            drawn.begin_row(row, nodes.half_chord_q15(rays, 0));
            drawn.prepare_span(nodes.half_chord_q15(rays, 0), 1, 0);
            SpanNode node;
            nodes.evaluate(rays, 0, node);
            const auto pixel = static_cast<uint64_t>((y + row) * kSide + x);
            compare_side(front, node, counts, pixel);
            compare_side(back, node, counts, pixel);
        }
    }
}

// Sets up both rims of all rows of tiles whose outline is not too steep, up to the column where tiles may begin.
Counts count_rims(const Camera& camera, const Lattice& points)
{
    constexpr int32_t kMargin = kTileRows;
    const SpanLattice lattice(points);
    SpanTrack front(lattice, &SpanNode::front);
    SpanTrack back(lattice, &SpanNode::back);
    const NodeEvaluator nodes(camera);
    OutlineTracker outline(camera, {0, camera.width_px});
    Counts counts;
    for (int32_t y = 2 * kTileRows; y + 3 * kTileRows < camera.height_px; y += kTileRows) {
        const RowSpan edges[] = {outline.row(y), outline.row(y + kTileRows)};
        const Rim rims[] = {{true, (edges[0].begin > edges[1].begin ? edges[0].begin : edges[1].begin) + kMargin},
                            {false, (edges[0].end < edges[1].end ? edges[0].end : edges[1].end) - 1 - kMargin}};
        for (const Rim& rim : rims) {
            int32_t outer_px[2];
            for (int k = 0; k < 2; ++k) outer_px[k] = (rim.left ? edges[k].begin : edges[k].end - 1) - rim.inner;
            SpanRim drawn(front, back);
            ++counts.tried;
            if (!drawn.prepare(nodes, nodes.row_at(rim.inner, y), outer_px)) continue;
            ++counts.taken;
            compare_rows(rim, y, nodes, outline, drawn, front, back, counts);
        }
    }
    return counts;
}

}  // namespace

TEST_CASE("rims run close to each pixel's own hits", "[span]")
{
    for (const View& view : extreme_views(kSide)) {
        if (view.name != "down the pole" && view.name != "generic") continue;
        Camera camera;
        REQUIRE(make_camera(view.pose, view.image, camera) == CameraError::none);
        for (const int points : {1024, 4096}) {
            const Counts counts = count_rims(camera, Lattice(static_cast<uint32_t>(points)));
            std::printf("%s, %d points: %d of %d rims taken; %.4f of a cell off at %d\n", view.name.c_str(), points,
                        counts.taken, counts.tried, counts.worst.error, static_cast<int>(counts.worst.where));
            CHECK(counts.taken > counts.tried * 3 / 4);
            CHECK(counts.worst.error < 0.3);
        }
    }
}
