// SPDX-License-Identifier: MIT
// What the samples of one texel or pixel say together.
#pragma once

#include "image/srgb.h"
#include "image/tone.h"
#include "lumi/color.h"
#include "trace/path_tracer.h"

namespace lumi::baker
{

class Estimate
{
public:
    explicit Estimate(ToneCurve tone = ToneCurve::srgb) : tone_(tone) {}

    void add(const PathResult& path)
    {
        ++samples_;
        if (path.covered) {
            ++hits_;
            sum_ = sum_ + path.radiance;
        }
    }

    uint32_t samples() const { return samples_; }
    // At least half of the rays meet the scene.
    bool mostly_covered() const { return hits_ != 0 && 2 * hits_ >= samples_; }
    // The mean of those that do, through the tone curve, encoded.
    Rgb8 colour() const { return srgb_encode(toned(tone_, sum_ * (1 / static_cast<float>(std::max(hits_, 1u))))); }
    // Linear light of all samples: already multiplied by the share of those that meet the scene.
    Rgb covered_radiance() const { return sum_ * (1 / static_cast<float>(std::max(samples_, 1u))); }
    float coverage() const { return static_cast<float>(hits_) / static_cast<float>(std::max(samples_, 1u)); }
    // Premultiplied by the share of those that do.
    detail::Rgba8 covered_colour() const
    {
        const Rgb8 c = colour();
        return {share_of(c.r), share_of(c.g), share_of(c.b), share_of(255)};
    }

private:
    uint8_t share_of(uint32_t value) const
    {
        return static_cast<uint8_t>(
            samples_ == 0 ? 0 : (uint64_t{value} * hits_ * 2 + samples_) / (uint64_t{samples_} * 2));
    }

    ToneCurve tone_;
    uint32_t samples_ = 0, hits_ = 0;
    Rgb sum_;
};

}  // namespace lumi::baker
