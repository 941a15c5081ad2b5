// SPDX-License-Identifier: MIT
// How far the mean of a texel's light paths may still be off, in steps of the 8-bit scale that it will be stored in.
//
// The standard error of the mean of independent paths, carried through tone curve and encoding. Our paths are
// stratified, so it is an upper estimate. A texel that happened to miss a rare bright path looks quieter than it is,
// and a rule that stops at quiet moments would darken pictures: so one path more is assumed, kUnseen times as bright as
// the brightest so far. What is left of that bias is measured in docs/log/speed.md.
#pragma once

#include "image/tone.h"
#include "lumi/color.h"
#include "trace/path_tracer.h"

namespace lumi::baker
{

// Collects the samples of one texel or pixel.

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

class ErrorGauge
{
public:
    static constexpr uint32_t kFirstLook = 16;  // paths before which no texel ends: coverage is not known better
    static constexpr uint32_t kBatch = 8;       // paths between two looks

    void add(const PathResult& path);

    uint32_t paths() const { return paths_; }
    // Whether the texel needs no further path: all paths agree on its coverage, and every channel's error is below
    // `max_levels`. Asks only where a batch ends.
    bool settled(ToneCurve tone, float max_levels) const;
    // The largest channel's standard error, of 255. Needs a covered path.
    float error_levels(ToneCurve tone) const;

private:
    struct Channel {
        double sum = 0, squares = 0, brightest = 0;
    };

    float standard_error(const Channel& channel) const;

    uint32_t paths_ = 0, hits_ = 0;
    Channel channels_[3];
};

}  // namespace lumi::baker
