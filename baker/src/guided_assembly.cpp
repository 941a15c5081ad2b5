// SPDX-License-Identifier: MIT
#include "guided_assembly.h"

namespace lumi::baker
{

std::vector<uint8_t> assembled_field(std::vector<FieldSection> base, std::vector<TracedChart> charts,
                                     const GuidedSettings& settings, Job& job)
{
    if (settings.texel == format::GuidedTexel::none) {
        return guided_file(base);
    }
    std::vector<ChartColours> colours;
    for (TracedChart& chart : charts) {
        colours.push_back(std::move(chart.colours));
    }
    Palettes palettes = palettes_of(colours, settings.texel, settings.mean_resolution != 0, job);
    GuidedParts parts;
    parts.texel = settings.texel;
    parts.colours = std::move(palettes.colours);
    for (size_t i = 0; i < charts.size(); ++i) {
        parts.charts.push_back({std::move(charts[i].rows), std::move(palettes.texels[i])});
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
