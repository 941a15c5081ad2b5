// SPDX-License-Identifier: MIT
// The colour of a surface point: the reconstruction of guided_format.h in 32-bit integers.
//
// GuidedPolicy names what is read; what it does not name is not linked. Steps down from the best that a field offers
// keep its texel and mean formats and change the rest: fewer origins, one tap, no occlusion, or NoChart, the mean
// alone.
#pragma once

#include "lumi/color.h"
#include "lumi/guided/guided_mean.h"
#include "lumi/guided/guided_texels.h"

namespace lumi
{

enum class OcclusionUse : uint8_t { ignored, read };

template <class OriginsPolicy, class TapsPolicy, class TexelPolicy, class MeanPolicy, OcclusionUse kUse>
struct GuidedPolicy {
    using Origins = OriginsPolicy;  // ThreeOrigins, OneOrigin
    using Taps = TapsPolicy;        // LinearTaps, NearestTap
    using Texel = TexelPolicy;      // GuidedIndex4, GuidedIndex8, GuidedVq8 (guided_vq.h), NoChart
    using Mean = MeanPolicy;        // MeanRgb565, MeanPalette8, NoMean
    static constexpr bool kChart = Texel::kFormat != format::GuidedTexel::none;
    static constexpr bool kOcclusion = kUse == OcclusionUse::read;

    // Whether a field holds what the policy reads. A field without occlusion may be drawn by one that reads it.
    static bool fits(const GuidedField& field)
    {
        if constexpr (Mean::kHasMean) {
            if (field.mean.resolution == 0 || field.mean.format != Mean::kFormat) return false;
            return !kChart || field.texel == Texel::kFormat;
        } else {
            static_assert(kChart, "a policy needs a chart or a mean");
            return field.mean.resolution == 0 && field.texel == Texel::kFormat;
        }
    }
};

// A colour and how much of it the field knows, 0 .. 256.
struct Shade {
    Rgb8 colour;
    uint32_t coverage_q8;
};

// 1/w for weights of 1 .. 2^8: 2^16/w, at most 2^16 - 1.
struct WeightReciprocals {
    uint16_t q16[257];
};
extern const WeightReciprocals kWeightReciprocals;

// The three corners of the pixel's origin triangle.
struct ThreeOrigins {
    static constexpr int kCount = 3;

    // `moved`: the corners are not the last pixel's.
    LUMI_ALWAYS_INLINE static void hold(OriginCharts& charts, const OriginTaps& taps, bool moved)
    {
        if (moved) charts.hold(taps.index);
    }
    LUMI_ALWAYS_INLINE static uint32_t weight_q8(const OriginTaps& taps, int k) { return taps.weight_q8[k]; }
};

// The heaviest corner alone.
struct OneOrigin {
    static constexpr int kCount = 1;

    LUMI_ALWAYS_INLINE static void hold(OriginCharts& charts, const OriginTaps& taps, bool)
    {
        const int first = taps.weight_q8[1] > taps.weight_q8[0] ? 1 : 0;
        const int32_t index = taps.index[taps.weight_q8[2] > taps.weight_q8[first] ? 2 : first];
        if (!charts.holds(0, index)) charts.hold_one(index);
    }
    LUMI_ALWAYS_INLINE static uint32_t weight_q8(const OriginTaps&, int) { return 256; }
};

template <class Policy>
class GuidedShader
{
public:
    explicit GuidedShader(const GuidedField& field)
        : reader_(field),
          mean_(field.mean),
          centre_q8_(static_cast<int32_t>(format::chart_centre(field.chart_size)) << 8),
          fades_(field.surface == format::GuidedSurface::focus)
    {
    }

    // `charts` hold the taps' origins. Inlined: the caller makes a function of it where it likes.
    LUMI_ALWAYS_INLINE Shade shade(const SurfacePoint& x, const OriginCharts& charts, const OriginTaps& taps) const
    {
        return shade_of(x, sum_at(x, charts, taps));
    }

    // The same in two steps.
    LUMI_ALWAYS_INLINE GuidedSum sum_at(const SurfacePoint& x, const OriginCharts& charts, const OriginTaps& taps) const
    {
        GuidedSum sum;
        if constexpr (Policy::kChart) {
            const SquaredPoint point = squared(x);
#pragma GCC unroll 3
            for (int k = 0; k < Policy::Origins::kCount; ++k) {
                const uint32_t weight_q8 = Policy::Origins::weight_q8(taps, k);
                const uint32_t own_q8 = Policy::Taps::kSingle ? weight_q8 : 1;
                const uint64_t words = words_of(charts.chart(k), point, weight_q8);
                sum.rb += static_cast<uint32_t>(words) * own_q8;
                sum.wg += static_cast<uint32_t>(words >> 32) * own_q8;
            }
        }
        return sum;
    }
    LUMI_ALWAYS_INLINE Shade shade_of(const SurfacePoint& x, const GuidedSum& sum) const
    {
        if constexpr (Policy::Mean::kHasMean) return {over_mean(mean_.at(x), sum), 256};
        const Rgb8 colour = colour_of(levels(sum));
        if (sum.weight_q8() == 0) return {{0, 0, 0}, 0};
        return {colour, fades_ ? sum.weight_q8() : 256};
    }

    // Without a mean: whether a sum covers all of its pixel, and its colour as 5, 6 and 5 bits.
    LUMI_ALWAYS_INLINE bool is_whole(const GuidedSum& sum) const
    {
        return sum.weight_q8() != 0 && !fades_;
    }
    LUMI_ALWAYS_INLINE static uint16_t packed565(const GuidedSum& sum)
    {
        const LevelsQ16 level = levels(sum);
        return pack_rgb565_q16(level.r, level.g, level.b);
    }

private:
    struct LevelsQ16 {
        uint32_t r, g, b;
    };

    struct NoReader {
        explicit NoReader(const GuidedField&) {}
    };
    struct NoMeanReader {
        explicit NoMeanReader(const MeanColours&) {}
    };
    template <bool kChart, class P>
    struct Readers {
        using Chart = ChartReader<typename P::Texel, P::Mean::kHasMean>;
    };
    template <class P>
    struct Readers<false, P> {
        using Chart = NoReader;
    };
    template <class Mean, bool kHas>
    struct MeanOf {
        using Type = MeanReader<Mean>;
    };
    template <class Mean>
    struct MeanOf<Mean, false> {
        using Type = NoMeanReader;
    };

    // What an origin adds to the sum, as two words, which stay in registers across the call. Of a single tap: its
    // colour.
    __attribute__((noinline)) uint64_t words_of(const OriginChart& chart, const SquaredPoint& point,
                                                [[maybe_unused]] uint32_t weight_q8) const
    {
        const ChartPlace place = chart_place(chart.axes, point, centre_q8_);
        if constexpr (Policy::kOcclusion) {
            if (is_hidden(chart, place)) return 0;
        }
        GuidedSum sum;
        if constexpr (Policy::Taps::kSingle) {
            Policy::Taps::add(reader_, chart, place.u_q8, place.v_q8, 1, sum);
        } else {
            if (!Policy::Taps::add(reader_, chart, place.u_q8, place.v_q8, weight_q8, sum))
                return words_at_border(chart, point, weight_q8);
        }
        return words(sum);
    }

    // The same of an origin that sees X next to its chart's border. All over again: so nothing has to be kept for it.
    __attribute__((noinline)) uint64_t words_at_border(const OriginChart& chart, const SquaredPoint& point,
                                                       uint32_t weight_q8) const
    {
        const ChartPlace place = chart_place(chart.axes, point, centre_q8_);
        GuidedSum sum;
        Policy::Taps::add_at_border(reader_, chart, place.u_q8, place.v_q8, weight_q8, sum);
        return words(sum);
    }

    static uint64_t words(const GuidedSum& sum)
    {
        return static_cast<uint64_t>(sum.wg) << 32 | sum.rb;
    }

    static uint8_t level(int32_t value_q8)
    {
        const int32_t value = (value_q8 + 128) >> 8;
        return static_cast<uint8_t>(value < 0 ? 0 : value > 255 ? 255 : value);
    }

    // The mean and the differences' mean, which fades below a weight of 1/4. Sums within ±2^15 times at most 2^10.
    LUMI_ALWAYS_INLINE static Rgb8 over_mean(const LevelsQ8& mean, const GuidedSum& sum)
    {
        if constexpr (!Policy::kChart) return {level(mean.r), level(mean.g), level(mean.b)};
        constexpr uint32_t kFullQ8 = 64;
        const uint32_t weight_q8 = sum.weight_q8();
        const int32_t scale_q16 = kWeightReciprocals.q16[weight_q8 < kFullQ8 ? kFullQ8 : weight_q8];
        const int32_t bias = static_cast<int32_t>(weight_q8 << 7);
        const auto channel = [&](int32_t mean_q8, int32_t sum_q8) {
            return level(mean_q8 + (((sum_q8 - bias) * scale_q16) >> 8));
        };
        return {channel(mean.r, sum.r_q8()), channel(mean.g, sum.g_q8()), channel(mean.b, sum.b_q8())};
    }

    // A sum's mean, and half a level to round it by; below 256.
    LUMI_ALWAYS_INLINE static LevelsQ16 levels(const GuidedSum& sum)
    {
        const uint32_t scale_q16 = kWeightReciprocals.q16[sum.weight_q8()];
        const auto level = [&](int32_t sum_q8) { return static_cast<uint32_t>(sum_q8) * scale_q16 + 0x8000u; };
        return {level(sum.r_q8()), level(sum.g_q8()), level(sum.b_q8())};
    }

    static Rgb8 colour_of(const LevelsQ16& levels)
    {
        const auto rounded = [](uint32_t v_q16) { return static_cast<uint8_t>(v_q16 >> 16); };
        return {rounded(levels.r), rounded(levels.g), rounded(levels.b)};
    }

    typename Readers<Policy::kChart, Policy>::Chart reader_;
    typename MeanOf<typename Policy::Mean, Policy::Mean::kHasMean>::Type mean_;
    int32_t centre_q8_;
    bool fades_;  // weights missing are coverage missing
};

}  // namespace lumi
