// SPDX-License-Identifier: MIT
#include "guided/traced_chart.h"

#include "util/byte_stream.h"

namespace lumi::baker
{
namespace
{

constexpr uint64_t kRowBytes = 8, kRowsHeadBytes = 8;
constexpr uint64_t kTexelBytes = 13;  // three floats and whether they are known
constexpr uint64_t kPointBytes = 24, kCountBytes = 4;

uint64_t rows_bytes(const ChartRows& rows)
{
    return kRowsHeadBytes + kRowBytes * rows.rows.size();
}

void put_rows(ByteWriter& out, const ChartRows& rows)
{
    out.put32(rows.first_v);
    out.put32(static_cast<uint32_t>(rows.rows.size()));
    for (const ChartRows::Row& row : rows.rows) {
        out.put32(row.first_u);
        out.put32(row.count);
    }
}

void put_levels(ByteWriter& out, const Levels& levels)
{
    for (const float v : {levels.r, levels.g, levels.b}) {
        out.put_float(v);
    }
}

Levels get_levels(ByteReader& in)
{
    Levels levels;
    for (float* v : {&levels.r, &levels.g, &levels.b}) {
        *v = in.get_float();
    }
    return levels;
}

// Nothing where rows would reach beyond any chart.
std::optional<ChartRows> get_rows(ByteReader& in)
{
    ChartRows rows;
    rows.first_v = in.get32();
    const uint32_t count = in.get32();
    if (rows.first_v > format::kMaxChart || count > format::kMaxChart) {
        return std::nullopt;
    }
    for (uint32_t k = 0; k < count; ++k) {
        const uint32_t first_u = in.get32(), texels = in.get32();
        if (first_u > format::kMaxChart || texels > format::kMaxChart) {
            return std::nullopt;
        }
        rows.rows.push_back({first_u, texels, rows.texel_count});
        rows.texel_count += texels;
    }
    return rows;
}

}  // namespace

uint64_t chart_bytes(const ChartRows& rows, const ChartRows& occluded)
{
    return rows_bytes(rows) + rows_bytes(occluded) + kTexelBytes * rows.texel_count + occluded.texel_count;
}

std::vector<uint8_t> encode(const TracedChart& chart)
{
    ByteWriter out;
    put_rows(out, chart.rows);
    put_rows(out, chart.occluded.rows);
    for (const Levels& levels : chart.colours.levels) {
        put_levels(out, levels);
    }
    for (const uint8_t known : chart.colours.known) {
        out.put8(known);
    }
    for (const uint8_t depth : chart.occluded.texels) {
        out.put8(depth);
    }
    return out.bytes();
}

std::optional<TracedChart> decode_chart(const std::vector<uint8_t>& bytes)
{
    ByteReader in(bytes.data(), bytes.size());
    const std::optional<ChartRows> rows = get_rows(in);
    const std::optional<ChartRows> occluded = rows ? get_rows(in) : std::nullopt;
    if (!occluded || chart_bytes(*rows, *occluded) != bytes.size()) {
        return std::nullopt;
    }
    TracedChart chart = {*rows, {}, {*occluded, {}}};
    chart.colours.levels.resize(rows->texel_count);
    for (Levels& levels : chart.colours.levels) {
        levels = get_levels(in);
    }
    chart.colours.known.resize(rows->texel_count);
    for (uint8_t& known : chart.colours.known) {
        known = in.get8();
    }
    chart.occluded.texels.resize(occluded->texel_count);
    for (uint8_t& depth : chart.occluded.texels) {
        depth = in.get8();
    }
    return chart;
}

uint64_t points_bytes(uint64_t count)
{
    return kCountBytes + kPointBytes * count;
}

std::vector<uint8_t> encode(const std::vector<ColourAtPoint>& points)
{
    ByteWriter out;
    out.put32(static_cast<uint32_t>(points.size()));
    for (const ColourAtPoint& point : points) {
        for (const float v : {point.x.x, point.x.y, point.x.z}) {
            out.put_float(v);
        }
        put_levels(out, point.colour);
    }
    return out.bytes();
}

std::optional<std::vector<ColourAtPoint>> decode_points(const std::vector<uint8_t>& bytes)
{
    ByteReader in(bytes.data(), bytes.size());
    const uint32_t count = in.get32();
    if (points_bytes(count) > bytes.size()) {
        return std::nullopt;
    }
    std::vector<ColourAtPoint> points(count);
    for (ColourAtPoint& point : points) {
        for (float* v : {&point.x.x, &point.x.y, &point.x.z}) {
            *v = in.get_float();
        }
        point.colour = get_levels(in);
    }
    return points;
}

std::vector<uint8_t> encode(const std::vector<FieldSection>& sections)
{
    ByteWriter out;
    for (const FieldSection& section : sections) {
        out.put32(section.type);
        out.put32(static_cast<uint32_t>(section.bytes.size()));
        for (const uint8_t b : section.bytes) {
            out.put8(b);
        }
    }
    return out.bytes();
}

std::optional<std::vector<FieldSection>> decode_sections(const std::vector<uint8_t>& bytes)
{
    constexpr size_t kSectionHeadBytes = 8;
    std::vector<FieldSection> sections;
    for (size_t at = 0; at < bytes.size();) {
        ByteReader in(bytes.data() + at, bytes.size() - at);
        const uint32_t type = in.get32(), size = in.get32();
        if (bytes.size() - at < kSectionHeadBytes || size > bytes.size() - at - kSectionHeadBytes) {
            return std::nullopt;
        }
        const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(at + kSectionHeadBytes);
        sections.push_back({type, {begin, begin + size}});
        at += kSectionHeadBytes + size;
    }
    return sections;
}

}  // namespace lumi::baker
