// SPDX-License-Identifier: MIT
#include "trace/error_gauge.h"

#include "image/tone.h"

namespace lumi::baker
{
namespace
{

constexpr double kUnseen = 1.5;

// Half the width of what [low, high] becomes on the stored scale.
float half_width(ToneCurve tone, const Rgb& low, const Rgb& high)
{
    const Rgb a = toned(tone, low), b = toned(tone, high);
    const auto width = [](float from, float to) { return srgb_encode_unit(to) - srgb_encode_unit(from); };
    return 255 * 0.5f * std::max({width(a.r, b.r), width(a.g, b.g), width(a.b, b.b)});
}

}  // namespace

void ErrorGauge::add(const PathResult& path)
{
    ++paths_;
    if (!path.covered) return;
    ++hits_;
    const float values[3] = {path.radiance.r, path.radiance.g, path.radiance.b};
    for (size_t k = 0; k < 3; ++k) {
        const double v = static_cast<double>(values[k]);
        channels_[k].sum += v;
        channels_[k].squares += v * v;
        channels_[k].brightest = std::max(channels_[k].brightest, v);
    }
}

float ErrorGauge::standard_error(const Channel& channel) const
{
    const double n = hits_, mean = channel.sum / n;
    const double unseen = kUnseen * channel.brightest - mean;
    const double spread = std::max(0.0, channel.squares - channel.sum * mean) + unseen * unseen * n / (n + 1);
    return static_cast<float>(std::sqrt(spread) / n);
}

float ErrorGauge::error_levels(ToneCurve tone) const
{
    const double scale = 1.0 / hits_;
    const Rgb mean = {static_cast<float>(channels_[0].sum * scale), static_cast<float>(channels_[1].sum * scale),
                      static_cast<float>(channels_[2].sum * scale)};
    const Rgb error = {standard_error(channels_[0]), standard_error(channels_[1]), standard_error(channels_[2])};
    const Rgb low = mean - error;
    return half_width(tone, {std::max(low.r, 0.0f), std::max(low.g, 0.0f), std::max(low.b, 0.0f)}, mean + error);
}

bool ErrorGauge::settled(ToneCurve tone, float max_levels) const
{
    if (paths_ < kFirstLook || paths_ % kBatch != 0) return false;
    return hits_ == 0 || (hits_ == paths_ && error_levels(tone) < max_levels);
}

}  // namespace lumi::baker
