// SPDX-License-Identifier: MIT
#include "lumi/guided/guided_origin.h"

#include "field/sections.h"
#include "lumi/detail/chord/sums.h"

namespace lumi
{

using container::load_u16, container::load_u32;

ChartRows chart_rows(const ChartTable& table, uint32_t origin)
{
    const uint8_t* entry = table.directory + origin * format::chart::kEntryBytes;
    const uint32_t row_base = load_u32(entry + format::chart::kRowBaseAt);
    const uint32_t texel_base = load_u32(entry + format::chart::kTexelBaseAt);
    const uint32_t rest = table.texel_count - texel_base;
    const uint32_t row_count = load_u16(entry + format::chart::kRowCountAt);
    return {table.rows + 2 * row_base,
            static_cast<int32_t>(load_u16(entry + format::chart::kFirstRowAt)),
            row_count,
            row_count == 0 ? 0 : row_count - 1,
            texel_base,
            rest < 65536 ? rest : 65536};
}

DepthRows depth_rows(const ChartTable& table, uint32_t origin)
{
    const ChartRows c = chart_rows(table, origin);
    return {c.rows, c.first_row, c.row_count, c.texel_span, table.texels + c.texel_base};
}

namespace
{

void pack_palette(const uint8_t* colours, bool differences, PackedPalette& out)
{
    const uint32_t bias = differences ? 0x00808080u : 0;
    out.colour[0] = {0, 0};
#pragma GCC unroll 5
    for (uint32_t k = 1; k < 16; ++k) {
        const uint32_t rgb = load_aligned<uint32_t>(colours + k * format::kChartColourBytes) ^ bias;
        out.colour[k] = {even_bytes(rgb), (rgb >> 8 & 0xFFu) | 1u << 16};
    }
}

}  // namespace

const OriginCharts::Frame& OriginCharts::frame(int32_t index)
{
    Frame& f = frame_[static_cast<uint32_t>(index) % kFrames];
    if (f.origin != index) {
        const Vec3q30 p = point(field_.origins, static_cast<uint32_t>(index));
        const auto q14 = [](int32_t v_q30) { return static_cast<int16_t>((v_q30 + (1 << 15)) >> 16); };
        f = {static_cast<int16_t>(index), {{q14(p.x), q14(p.y), q14(p.z)}}, chart_frame(p)};
    }
    return f;
}

void OriginCharts::make(int32_t index, OriginChart& out)
{
    const uint32_t origin = static_cast<uint32_t>(index);
    out.origin = index;
    out.seen = {};
    if (origin >= field_.used_origins) {
        out.texels = {};
        out.occlusion = {};
        return;
    }
    const Frame& f = frame(index);
    out.axes = chart_axes(f.p, f.frame, field_.chart_size);
    if (field_.chart.texel_count != 0) {
        const bool narrow = field_.texel == format::GuidedTexel::index4;
        const uint32_t group_bytes = format::chart_colours(field_.texel) * format::kChartColourBytes;
        const uint8_t* colours = field_.colours + (origin / field_.origins_per_palette) * group_bytes;
        if (narrow && out.colours != colours) pack_palette(colours, field_.mean.resolution != 0, out.packed);
        out.colours = colours;
        out.texels = chart_rows(field_.chart, origin);
    }
    if (field_.occlusion.texel_count != 0) out.occlusion = depth_rows(field_.occlusion, origin);
}

void OriginCharts::hold(const int32_t (&index)[3])
{
    // Corners that stay keep their slot; the others take the slots that are left.
    constexpr int kNowhere = 3;
    int place[3];
    uint32_t taken = 0;
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) {
        const int32_t origin = index[k];
        place[k] = slot_[0].origin == origin   ? 0
                   : slot_[1].origin == origin ? 1
                   : slot_[2].origin == origin ? 2
                                               : kNowhere;
        taken |= 1u << place[k];
    }
    for (int k = 0; k < 3; ++k) {
        if (place[k] == kNowhere) {
            place[k] = (taken & 1) == 0 ? 0 : (taken & 2) == 0 ? 1 : 2;
            taken |= 1u << place[k];
            make(index[k], slot_[place[k]]);
        }
        chart_[k] = &slot_[place[k]];
    }
}

void OriginCharts::hold_one(int32_t index)
{
    make(index, slot_[0]);
    chart_[0] = &slot_[0];
}

}  // namespace lumi
