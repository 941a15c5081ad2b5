// SPDX-License-Identifier: MIT
#include "planner/chord_work.h"

#include <algorithm>
#include <cstdint>

#include "lattice/lattice_query.h"
#include "lattice/local_distances.h"
#include "lattice/polar.h"
#include "lumi/chord/detail/both_sides.h"
#include "lumi/chord/detail/stepper.h"
#include "lumi/chord/render.h"
#include "lumi/chord/render_spans.h"

namespace lumi::planner
{

namespace
{

// Tells which spans core had to shorten: a longer one came too near a pole, left its zone's map or turned too far,
// which took as many instructions as a span that is drawn. It is told of all pieces of a stripe, in their order.
class SpanTries
{
public:
    explicit SpanTries(int span_log2) : lengths_(1 << span_log2) {}

    void begin_scanline(const detail::Piece& scanline)
    {
        covered_[row_of(scanline)] = {scanline.x, scanline.x + scanline.width};
        tile_x_ = INT32_MIN;
    }
    void begin_tile(const detail::Piece& tile) { tile_x_ = tile.x; }

    // Counts of a span or a checked piece.
    bool is_shortened(const detail::Piece& span) const
    {
        const detail::Extent& covered = covered_[row_of(span)];
        const int32_t from_right = covered.end - 1 - span.x;
        if (from_right <= 0) return false;
        // Spans left of the last tile fill the gap before it.
        const int32_t end = span.x < tile_x_ ? std::min(tile_x_, covered.end) : covered.end;
        const int32_t length = std::min(span.width, from_right);  // the last pixel is the last span's end
        return length < lengths_.length(span.x - covered.begin, from_right, end - span.x);
    }

private:
    static size_t row_of(const detail::Piece& piece)
    {
        return static_cast<size_t>(piece.y & (detail::kTileHeight - 1));
    }

    detail::SpanLengths lengths_;
    detail::Extent covered_[detail::kTileHeight] = {};  // how far the band's scanlines are covered
    int32_t tile_x_ = INT32_MIN;                        // the band's last tile so far
};

constexpr int32_t kTilePx = 8;  // spans are drawn in tiles of 8 × 8 pixels, exact pixels in rows
constexpr uint32_t kFewPoints = 64;

class ChordCounter
{
public:
    ChordCounter(const Field& field, const Camera& camera, bool by_spans, const host::ScreenSize& screen)
        : field_(field),
          camera_(camera),
          by_spans_(by_spans),
          screen_(screen),
          is_checked_(static_cast<size_t>(screen.width_px) * static_cast<size_t>(screen.height_px))
    {
        frame[ChordItem::frame] = 1;
        frame[ChordItem::image_px] = 1.0 * screen.width_px * screen.height_px;
    }

    template <class Reconstruction>
    void read_pixels()
    {
        const int32_t width = by_spans_ ? kTilePx : screen_.width_px, height = by_spans_ ? kTilePx : 1;
        for (int32_t top = 0; top < screen_.height_px; top += height)
            for (int32_t left = 0; left < screen_.width_px; left += width)
                for (int32_t y = top; y < std::min(top + height, screen_.height_px); ++y)
                    for (int32_t x = left; x < std::min(left + width, screen_.width_px); ++x)
                        read_pixel<Reconstruction>(x, y);
    }

    void count_pieces(int span_log2)
    {
        for (int32_t y = 0; y < screen_.height_px; y += screen_.stripe_rows()) {
            const int32_t rows = std::min(screen_.stripe_rows(), screen_.height_px - y);
            detail::ChordStepper stepper(field_, camera_, {nullptr, 0, y, screen_.width_px, rows, 0}, span_log2);
            frame[ChordItem::made_zone] += made_zones(field_.origins) + made_zones(field_.directions);
            count_stripe(stepper, SpanTries(span_log2));
        }
    }

    void count_scanlines()
    {
        for (int32_t y = 0; y < screen_.height_px; ++y) {
            const detail::Extent covered = detail::covered_extent(camera_, y, 0, screen_.width_px);
            if (covered.begin < covered.end) frame[ChordItem::scanline] += 1;
        }
    }

    ChordWork frame;
    std::vector<Read> reads;

private:
    // Those down to the equator's.
    static int32_t made_zones(const detail::Lattice& lattice)
    {
        const detail::LatticeZones zones(lattice);
        int32_t count = 1;
        while (count < detail::kSpanZones && zones.zone[count - 1].begin_z_q30 != 0) ++count;
        return count;
    }

    void count_stripe(detail::ChordStepper& stepper, SpanTries tries)
    {
        detail::Piece scanline = {}, before = {};
        for (detail::Piece piece; stepper.next(piece); before = piece)
            if (piece.kind == detail::Piece::Kind::scanline) {
                tries.begin_scanline(piece);
                count_scanline(piece, scanline);
                scanline = piece;
            } else {
                count_try(piece, tries);
                count_piece(piece, before, stepper.origins(), stepper.directions());
            }
    }

    void count_scanline(const detail::Piece& piece, const detail::Piece& above)
    {
        const bool follows = above.width > 0;
        if (!follows || piece.width <= 0) frame[ChordItem::searched] += 1;
        if (piece.width <= 0) return;
        frame[ChordItem::scanline] += 1;
        if (!follows || piece.y % kTilePx == 0) frame[ChordItem::band] += 1;
    }

    void count_try(const detail::Piece& piece, SpanTries& tries)
    {
        if (piece.tile != nullptr)
            tries.begin_tile(piece);
        else if (tries.is_shortened(piece))
            frame[ChordItem::shortened] += 1;
    }

    void count_piece(const detail::Piece& piece, const detail::Piece& before, const detail::LatticeLine& origins,
                     const detail::LatticeLine& directions)
    {
        if (field_.used_origins != field_.origins.size()) frame[ChordItem::capped] += 1;
        const int32_t over_pole = origins.over_pole + directions.over_pole;
        frame[ChordItem::polar_side] += over_pole;
        count_zone(origins, zones_[0]);
        count_zone(directions, zones_[1]);
        if (piece.tile == nullptr) {
            const bool follows = before.kind != detail::Piece::Kind::scanline && before.tile == nullptr &&
                                 before.y == piece.y && before.x + before.width == piece.x;
            if (!follows) frame[ChordItem::gap] += 1;
            if (piece.width == 1) frame[ChordItem::lone] += 1;
        }
        if (piece.kind == detail::Piece::Kind::checked) {
            frame[ChordItem::checked] += 1;
            frame[ChordItem::cell_pixel] += piece.width * (2 - over_pole);
            frame[ChordItem::pole_pixel] += piece.width * over_pole;
            std::fill_n(is_checked_.begin() + piece.y * screen_.width_px + piece.x, piece.width, true);
            return;
        }
        const int32_t lines = piece.tile != nullptr ? piece.tile->count : 1;
        const int32_t pixels = piece.width * lines;
        if (piece.tile != nullptr) {
            frame[ChordItem::tile] += 1;
            count_tile(piece);
            frame[ChordItem::tile_line] += lines;
            frame[ChordItem::tile_pixel] += pixels;
        } else {
            frame[ChordItem::span] += 1;
            frame[ChordItem::span_pixel] += pixels;
        }
        count_lines(piece, origins, directions);
        if (!origins.cells.uniform || !directions.cells.uniform) {
            frame[ChordItem::mixed] += 1;
            frame[ChordItem::mixed_line] += lines;
            frame[ChordItem::mixed_pixel] += pixels;
        }
    }

    // Scanline by scanline: how a tile's lines change.
    void count_lines(const detail::Piece& piece, detail::LatticeLine origins, detail::LatticeLine directions)
    {
        const bool is_tile = piece.tile != nullptr;
        const bool is_at_once =
            is_tile && detail::BothSidesScanlines::can_follow(origins.cells, piece.tile->origins, piece.width) &&
            detail::BothSidesScanlines::can_follow(directions.cells, piece.tile->directions, piece.width);
        for (int32_t line = 0; line < (is_tile ? piece.tile->count : 1); ++line) {
            if (!is_at_once) {
                if (!detail::can_follow(origins.cells, directions.cells, piece.width))
                    frame[ChordItem::steep_pixel] += piece.width;
                else if (is_tile)
                    frame[ChordItem::lone_line] += 1;
            }
            if (!is_tile) return;
            origins.cells.move_down(piece.tile->origins, 1);
            directions.cells.move_down(piece.tile->directions, 1);
        }
    }

    void count_tile(const detail::Piece& piece)
    {
        constexpr int32_t kWide = 2 * kTilePx;
        if (piece.width == kWide)
            frame[ChordItem::wide_tile] += 1;
        else if (piece.x % kWide == 0)
            frame[ChordItem::narrow_tile] += 1;
        if (piece.y == tile_y_) frame[ChordItem::missed_tile] += (piece.x - tile_end_) / kTilePx;
        tile_y_ = piece.y;
        tile_end_ = piece.x + piece.width;
    }

    void count_zone(const detail::LatticeLine& line, const detail::Zone*& before)
    {
        if (line.over_pole) return;
        if (line.cells.zone != before) frame[ChordItem::zone] += 1;
        before = line.cells.zone;
    }

    template <class Reconstruction>
    void read_pixel(int32_t x, int32_t y)
    {
        detail::SphereRay ray;
        if (!detail::ray_at(camera_, x, y, ray)) return;
        const detail::SphereHits hit = detail::hits(camera_, ray);
        const auto origins = Reconstruction::taps(field_.origins, hit.front);
        const auto directions = Reconstruction::taps(field_.directions, hit.back);
        frame[ChordItem::pixel] += 1;
        frame[ChordItem::row] += origins.count;
        frame.count[tap_item()] += origins.count * directions.count;
        if (!by_spans_) {
            count_side(field_.origins, hit.front);
            count_side(field_.directions, hit.back);
        }
        const bool is_checked = is_checked_[static_cast<size_t>(y * screen_.width_px + x)];
        uint32_t covered = 0;
        for (uint32_t m = 0; m < origins.count; ++m) {
            const uint8_t* const row = field_.row(origins.index[m]);
            if (row == nullptr) continue;
            if (is_checked) frame[ChordItem::checked_row] += 1;
            for (uint32_t k = 0; k < directions.count; ++k) covered += read_texel(row, directions.index[k]);
        }
        const uint32_t whole = 255 * origins.count * directions.count;
        frame[covered == 0 ? ChordItem::clear : covered == whole ? ChordItem::shown : ChordItem::half_clear] += 1;
    }

    void count_side(const detail::Lattice& side, const Vec3q30& hit)
    {
        if (side.size() < kFewPoints) {
            frame[ChordItem::few_side] += 1;
            frame[ChordItem::few_point] += side.size();
            return;
        }
        const detail::Query query = detail::make_query(side, hit);
        const auto is_below = [&](int32_t index) { return query.height_q10 < index << 10; };
        if (is_below(detail::kCapHeight)) frame[ChordItem::cap_side] += 1;
        if (is_below(detail::polar::kBlendBegin))
            frame[ChordItem::pole_side] += 1;
        else if (is_below(detail::polar::kBlendEnd))
            frame[ChordItem::blend_side] += 1;
        frame[ChordItem::zone_step] += detail::cell_of(query).zone;
    }

    // Returns its coverage.
    uint32_t read_texel(const uint8_t* row, uint32_t j)
    {
        const uint32_t bytes = detail::format::bytes_per_texel(field_.texel_format);
        const uint8_t* const texel = row + size_t{bytes} * j;
        reads.push_back({address_of(texel), bytes});
        if (field_.texel_format != TexelFormat::palette8)
            return std::any_of(texel, texel + bytes, [](uint8_t v) { return v != 0; }) ? 255 : 0;
        const uint8_t* const entry = field_.palette + 4 * *texel;
        reads.push_back({address_of(entry), 4});
        return entry[3];
    }

    // TexelFormat and the items have one order.
    size_t tap_item() const
    {
        return static_cast<size_t>(ChordItem::tap_rgb888) + static_cast<size_t>(field_.texel_format);
    }

    uint32_t address_of(const uint8_t* at) const { return static_cast<uint32_t>(at - field_.texels); }

    const Field& field_;
    const Camera& camera_;
    const bool by_spans_;
    const host::ScreenSize& screen_;
    std::vector<bool> is_checked_;  // pixels of pieces whose texels are checked
    const detail::Zone* zones_[2] = {};
    int32_t tile_y_ = -1, tile_end_ = 0;
};

}  // namespace

ChordFrame frame_of(const Field& field, tools::Mode mode, int32_t span_px, const Camera& camera,
                    const host::ScreenSize& screen)
{
    const bool by_spans = is_drawn_by_spans(field, mode, span_px);
    ChordCounter count(field, camera, by_spans, screen);
    if (by_spans)
        count.count_pieces(span_px == 4 ? 2 : span_px == 8 ? 3 : 4);
    else
        count.count_scanlines();
    if (mode == tools::Mode::paper)
        count.read_pixels<Paper<>>();
    else if (mode == tools::Mode::linear)
        count.read_pixels<Linear>();
    else
        count.read_pixels<Nearest>();
    return {count.frame, std::move(count.reads)};
}

}  // namespace lumi::planner
