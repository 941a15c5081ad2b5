// SPDX-License-Identifier: MIT
// What is traced of a guided field, origin by origin, and its bytes in checkpoints and shards.
#pragma once

#include <optional>

#include "guided/chart_palettes.h"
#include "guided/guided_tracer.h"
#include "guided/guided_writer.h"

namespace lumi::baker
{

struct TracedChart {
    ChartRows rows;
    ChartColours colours;
    PackedChart occluded;  // without rows where the field has no occlusion
};

uint64_t chart_bytes(const ChartRows& rows, const ChartRows& occluded);
std::vector<uint8_t> encode(const TracedChart& chart);  // chart_bytes() long
// Nothing if these are no bytes of a chart.
std::optional<TracedChart> decode_chart(const std::vector<uint8_t>& bytes);

uint64_t points_bytes(uint64_t count);
std::vector<uint8_t> encode(const std::vector<ColourAtPoint>& points);  // points_bytes() long
// Bytes after the points are passed over.
std::optional<std::vector<ColourAtPoint>> decode_points(const std::vector<uint8_t>& bytes);

std::vector<uint8_t> encode(const std::vector<FieldSection>& sections);
std::optional<std::vector<FieldSection>> decode_sections(const std::vector<uint8_t>& bytes);

}  // namespace lumi::baker
