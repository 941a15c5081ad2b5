// SPDX-License-Identifier: MIT
#include "guided/chart_palettes.h"

#include "image/k_means.h"

namespace lumi::baker
{
namespace
{

constexpr double kMaxPaletteShare = 0.03;  // of the texels' bytes
constexpr uint64_t kSeed = 0x72657364;
constexpr size_t kFitPoints = 16384;  // that a palette is fitted to

ColourPoint to_point(const Levels& c)
{
    return {c.r, c.g, c.b, 0};
}

class Group
{
public:
    Group(const std::vector<ChartColours>& charts, size_t first, size_t end) : charts_(charts), first_(first), end_(end)
    {
    }

    void fit(size_t entries, bool differences)
    {
        std::vector<ColourPoint> points;
        for_each_known([&](const Levels& c) { points.push_back(to_point(c)); });
        const size_t step = points.size() / kFitPoints + 1;
        std::vector<ColourPoint> chosen;
        for (size_t k = 0; k < points.size(); k += step) {
            chosen.push_back(points[k]);
        }
        centres_ = k_means(chosen, {}, entries - 1, kSeed);
        const float low = differences ? -128 : 0, high = differences ? 127 : 255;
        for (ColourPoint& c : centres_) {
            for (float& channel : c) {
                channel = std::round(std::clamp(channel, low, high));
            }
        }
    }

    void put_colours(uint8_t* out) const
    {
        for (const ColourPoint& c : centres_) {
            out += format::kChartColourBytes;
            for (size_t channel = 0; channel < 3; ++channel) {
                out[channel] = static_cast<uint8_t>(static_cast<int>(c[channel]));
            }
        }
    }

    std::vector<uint8_t> texels(size_t origin) const
    {
        const ChartColours& chart = charts_[origin];
        std::vector<uint8_t> result(chart.levels.size());
        for (size_t k = 0; k < result.size(); ++k) {
            if (chart.known[k] != 0) {
                result[k] = static_cast<uint8_t>(1 + nearest_centre(centres_, to_point(chart.levels[k])).index);
            }
        }
        return result;
    }

private:
    template <class Function>
    void for_each_known(const Function& function) const
    {
        for (size_t origin = first_; origin < end_; ++origin) {
            for (size_t k = 0; k < charts_[origin].levels.size(); ++k) {
                if (charts_[origin].known[k] != 0) {
                    function(charts_[origin].levels[k]);
                }
            }
        }
    }

    const std::vector<ChartColours>& charts_;
    size_t first_, end_;
    std::vector<ColourPoint> centres_;
};

}  // namespace

uint32_t origins_per_palette(uint64_t texels, size_t origins, format::GuidedTexel texel)
{
    const double texel_bytes = texel == format::GuidedTexel::index4 ? 0.5
                               : texel == format::GuidedTexel::vq8  ? 0.25
                                                                    : 1;
    const double bytes = static_cast<double>(texels) * texel_bytes / static_cast<double>(origins);
    const double palette = static_cast<double>(format::chart_colours(texel)) * format::kChartColourBytes;
    const double group = bytes > 0 ? std::ceil(palette / (kMaxPaletteShare * bytes)) : 1;
    return static_cast<uint32_t>(std::clamp(group, 1.0, static_cast<double>(origins)));
}

Palettes palettes_of(const std::vector<ChartColours>& charts, format::GuidedTexel texel, bool differences, Job& job)
{
    const size_t entries = format::chart_colours(texel);
    uint64_t texels = 0;
    for (const ChartColours& chart : charts) {
        texels += chart.levels.size();
    }
    Palettes result;
    result.origins_per_palette = origins_per_palette(texels, charts.size(), texel);
    const size_t per_group = result.origins_per_palette, groups = (charts.size() + per_group - 1) / per_group;
    result.colours.resize(groups * entries * format::kChartColourBytes);
    result.texels.resize(charts.size());
    job.run(static_cast<uint32_t>(groups), [&](uint32_t g) {
        const size_t first = g * per_group, end = std::min(charts.size(), first + per_group);
        Group group(charts, first, end);
        group.fit(entries, differences);
        group.put_colours(&result.colours[g * entries * format::kChartColourBytes]);
        for (size_t origin = first; origin < end; ++origin) {
            result.texels[origin] = group.texels(origin);
        }
    });
    return result;
}

}  // namespace lumi::baker
