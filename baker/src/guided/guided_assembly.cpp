// SPDX-License-Identifier: MIT
#include "guided/guided_assembly.h"

#include "guided/chart_blocks.h"

namespace lumi::baker
{

std::vector<uint8_t> assembled_field(std::vector<FieldSection> base, std::vector<TracedChart> charts,
                                     const GuidedSettings& settings, Job& job)
{
    if (settings.texel == format::GuidedTexel::none) {
        return guided_file(base);
    }
    const bool in_blocks = settings.texel == format::GuidedTexel::vq8, differences = settings.mean_resolution != 0;
    std::vector<ChartColours> colours;
    std::vector<ChartRows> rows;
    for (TracedChart& chart : charts) {
        colours.push_back(std::move(chart.colours));
        rows.push_back(std::move(chart.rows));
    }
    Palettes palettes =
        in_blocks ? blocks_of(colours, rows, differences, job) : palettes_of(colours, settings.texel, differences, job);
    GuidedParts parts;
    parts.texel = settings.texel;
    parts.colours = std::move(palettes.colours);
    for (size_t i = 0; i < charts.size(); ++i) {
        parts.charts.push_back({in_blocks ? block_rows(rows[i]) : std::move(rows[i]), std::move(palettes.texels[i])});
        if (settings.occlusion) {
            parts.occluded.push_back(std::move(charts[i].occluded));
        }
    }
    for (FieldSection& section : chart_sections(parts)) {
        base.push_back(std::move(section));
    }
    return guided_file(base);
}

}  // namespace lumi::baker
