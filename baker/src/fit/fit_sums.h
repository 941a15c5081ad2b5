// SPDX-License-Identifier: MIT
// The normal equations of a surface field's fit, summed over samples as integers: the same sums in any order.
//
// A sample's target is (texel) + Σ weight · (node). Rare bright paths would tint tables, so targets are cut near what
// is expected. Texels get back what was cut off diffuse light, which all sides see: light through a small hole is kept.
//
// With 12 bits of weight and targets in 1/64 level, below 2^15 levels, 64-bit sums hold 2^30 samples a patch, and the
// 32-bit ones below 2^20 samples a texel. Radiance counts as 2^20 at most.
#pragma once

#include "fit/fit_model.h"
#include "fit/sample_tracer.h"

namespace lumi::baker
{

inline constexpr uint32_t kMaxTexelSamples = uint32_t{1} << 20;
inline constexpr double kWeightUnit = 1.0 / 4096, kLevelUnit = 1.0 / 64;
inline constexpr double kLightUnit = 1.0 / (1 << 20);
inline constexpr int kScatterShift = 3;  // differences are shifted right by so many bits before they are squared
inline constexpr double kScatterUnit = kLevelUnit * kLevelUnit * (1 << (2 * kScatterShift));

struct TexelSums {
    uint32_t count = 0;
    std::array<int64_t, 3> target{}, predicted{};
    std::array<int64_t, 3> cut_off{};  // of targets of diffuse light
    std::array<int64_t, 3> light{};    // radiance, in kLightUnit
    // Squares of target - prediction, all channels, in kScatterUnit; without and with what was cut off.
    uint64_t scatter = 0, whole_scatter = 0;

    // The variance of one sample's channel, levels².
    double variance() const { return count == 0 ? 0 : kScatterUnit * static_cast<double>(scatter) / (3.0 * count); }
};

// Sums of products of two nodes' weights: few of a patch's pairs are ever seen together.
class NodePairs
{
public:
    NodePairs() : keys_(kFirstSize, kEmpty), sums_(kFirstSize, 0) {}

    // Wraps, as sums of a damaged shard may.
    void add(uint16_t a, uint16_t b, int64_t product)
    {
        int64_t& s = sum(key_of(a < b ? a : b, a < b ? b : a));
        s = static_cast<int64_t>(static_cast<uint64_t>(s) + static_cast<uint64_t>(product));
    }

    // f(a, b, sum) with a <= b, in no particular order.
    template <class Function>
    void each(Function f) const
    {
        for (size_t k = 0; k < keys_.size(); ++k)
            if (keys_[k] != kEmpty) f(keys_[k] / kPatchNodes, keys_[k] % kPatchNodes, sums_[k]);
    }
    // In the order of keys, so that what is computed from it does not depend on the order of samples.
    void sort();

private:
    static constexpr uint16_t kEmpty = UINT16_MAX;
    static constexpr size_t kFirstSize = 256;

    static uint16_t key_of(uint32_t a, uint32_t b) { return static_cast<uint16_t>(a * kPatchNodes + b); }
    size_t first_place(uint16_t key) const
    {
        constexpr uint32_t kScatter = 40503;  // 2^16/Φ
        return (key * kScatter >> 4) & (keys_.size() - 1);
    }
    int64_t& sum(uint16_t key)
    {
        const size_t first = first_place(key);
        return keys_[first] == key ? sums_[first] : sum_after(key);
    }
    int64_t& sum_after(uint16_t key);
    void grow();

    std::vector<uint16_t> keys_;
    std::vector<int64_t> sums_;
    size_t used_ = 0;
};

struct PatchSums {
    std::vector<TexelSums> texels;
    std::vector<uint32_t> crossed;                // kPatchNodes a texel: sums of weights
    std::vector<std::array<int64_t, 3>> targets;  // by node: sums of weight · target
    NodePairs pairs;
    double weight = 1;  // of a path in what is fitted; sums hold all paths alike
};

// Count and scatter of all texels together, without what was cut off.
TexelSums scatter_of(const PatchSums& patch);

// Light above white shows as white: a fit may count it as that, once it is known well what is.
enum class White : uint8_t { goes_on, clips };

// Throws BakeError where sums cannot hold so many.
void require_few_enough(uint32_t texel_samples);

class FitSums
{
public:
    // Borrows all.
    FitSums(const FitShape& shape, const EncodedTone& tone, const FitModel& expected, White white);

    // Adds samples whose targets are linear around what `expected` shows. Thread-safe for different patches. Throws
    // BakeError where a texel got too many.
    void add(uint32_t patch, const FitSample* begin, const FitSample* end);
    // Where `expected` has changed since: the same samples again, and no others. What targets do not change is kept,
    // and that is most of the work.
    void add_again(uint32_t patch, const FitSample* begin, const FitSample* end);

    // Makes paths count by the area that each stands for, 1 in the mean, where texels of a patch get so many lines: a
    // picture shows areas, however many paths were drawn there.
    void weigh(const std::vector<uint32_t>& lines);

    const FitShape& shape() const { return shape_; }
    std::vector<PatchSums>& patches() { return patches_; }
    const std::vector<PatchSums>& patches() const { return patches_; }

private:
    LevelColour target_of(const Rgb& radiance, const LevelColour& expected) const;
    void add_target(PatchSums& sums, const std::vector<LevelColour>& nodes, const FitSample& sample,
                    const SampleTaps& taps) const;
    uint32_t texel_in(uint32_t patch, const FitSample& sample) const
    {
        return sample.texel - shape_.layout.rectangles[patch].begin;
    }

    const FitShape& shape_;
    const EncodedTone& tone_;
    const FitModel& expected_;
    const White white_;
    std::vector<PatchSums> patches_;
};

}  // namespace lumi::baker
