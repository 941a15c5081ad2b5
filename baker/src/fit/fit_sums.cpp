// SPDX-License-Identifier: MIT
#include "fit/fit_sums.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lumi/baker/bake.h"

namespace lumi::baker
{
namespace
{

constexpr float kWhite = 255;
constexpr float kMostOff = 600;  // levels between target and expectation (docs/log/surface.md)

std::array<int64_t, 3> fixed(const LevelColour& levels)
{
    constexpr float kPerLevel = 64, kMost = 32767 * kPerLevel;
    const auto step = [](float v) { return int64_t{std::lround(std::clamp(v * kPerLevel, -kMost, +kMost))}; };
    return {step(levels[0]), step(levels[1]), step(levels[2])};
}

std::array<int64_t, 3> fixed(const Rgb& radiance)
{
    static constexpr double kMost = (1 << 20) / kLightUnit;
    const auto step = [](float v) {
        return int64_t{std::llround(std::min(static_cast<double>(v) / kLightUnit, kMost))};
    };
    return {step(radiance.r), step(radiance.g), step(radiance.b)};
}

constexpr float kWeightStep = 1.0f / 4096;

LevelColour sum_of(const LevelColour& a, const LevelColour& b, float weight)
{
    return {a[0] + weight * b[0], a[1] + weight * b[1], a[2] + weight * b[2]};
}

uint64_t square(int64_t difference)
{
    const int64_t off = difference >> kScatterShift;
    return static_cast<uint64_t>(off * off);
}

// The difference from what is expected keeps its hue: a channel that is cut alone would tint.
LevelColour cut(const LevelColour& target, const LevelColour& expected)
{
    float most = 0;
    for (size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(target[c] - expected[c]));
    if (most <= kMostOff) return target;
    LevelColour result;
    for (size_t c = 0; c < 3; ++c) result[c] = expected[c] + kMostOff / most * (target[c] - expected[c]);
    return result;
}

// The area that a patch's texels lie on; those of a lone triangle go on beyond it.
double rectangle_area(const FitShape& shape, uint32_t patch)
{
    const auto area = [&](uint32_t triangle) {
        const Vec3& first = shape.position(triangle, 0);
        return static_cast<double>(
                   length(cross(shape.position(triangle, 1) - first, shape.position(triangle, 2) - first))) /
               2;
    };
    const bool is_alone = shape.vertex(patch, 3) == PatchMesh::kNone;
    return area(2 * patch) + area(2 * patch + (is_alone ? 0 : 1));
}

}  // namespace

int64_t& NodePairs::sum_after(uint16_t key)
{
    const size_t mask = keys_.size() - 1;
    for (size_t k = first_place(key);; k = (k + 1) & mask) {
        if (keys_[k] == key) return sums_[k];
        if (keys_[k] == kEmpty) {
            if (4 * (used_ + 1) > 3 * keys_.size()) {
                grow();
                return sum(key);
            }
            ++used_;
            keys_[k] = key;
            return sums_[k];
        }
    }
}

void NodePairs::grow()
{
    NodePairs larger;
    larger.keys_.assign(2 * keys_.size(), kEmpty);
    larger.sums_.assign(2 * keys_.size(), 0);
    each([&](uint32_t a, uint32_t b, int64_t value) { larger.sum(key_of(a, b)) = value; });
    *this = std::move(larger);
}

void NodePairs::sort()
{
    std::vector<std::pair<uint16_t, int64_t>> all;
    each([&](uint32_t a, uint32_t b, int64_t value) { all.push_back({key_of(a, b), value}); });
    std::sort(all.begin(), all.end());
    NodePairs ordered;
    ordered.keys_.assign(keys_.size(), kEmpty);
    ordered.sums_.assign(keys_.size(), 0);
    for (const auto& [key, value] : all) ordered.sum(key) = value;
    *this = std::move(ordered);
}

TexelSums scatter_of(const PatchSums& patch)
{
    TexelSums all;
    for (const TexelSums& texel : patch.texels) {
        all.count += texel.count;
        all.scatter += texel.scatter;
    }
    return all;
}

FitSums::FitSums(const FitShape& shape, const EncodedTone& tone, const FitModel& expected, White white)
    : shape_(shape), tone_(tone), expected_(expected), white_(white), patches_(shape.mesh.patches.size())
{
    for (size_t p = 0; p < patches_.size(); ++p) {
        const uint32_t texels = shape.layout.rectangles[p].size();
        patches_[p].texels.resize(texels);
        patches_[p].crossed.resize(size_t{texels} * kPatchNodes);
        patches_[p].targets.resize(kPatchNodes);
    }
}

void require_few_enough(uint32_t texel_samples)
{
    if (texel_samples >= kMaxTexelSamples)
        throw BakeError("a texel got a million light paths, more than sums can hold; choose fewer --paths");
}

LevelColour FitSums::target_of(const Rgb& radiance, const LevelColour& expected) const
{
    LevelColour target = tone_.line_at(expected)(radiance);
    for (size_t c = 0; c < 3; ++c) target[c] = white_ == White::clips && expected[c] > kWhite ? kWhite : target[c];
    return target;
}

void FitSums::add_target(PatchSums& sums, const std::vector<LevelColour>& nodes, const FitSample& sample,
                         const SampleTaps& taps) const
{
    const uint32_t patch = sample.triangle / 2;
    const LevelColour shown = predicted(expected_, nodes, sample, taps);
    const LevelColour mirrored =
        shape_.mirrored(sample.triangle, {kWeightStep * sample.second_q12, kWeightStep * sample.third_q12}, sample.eye);
    const LevelColour expected = sum_of(shown, mirrored, 1);
    const Rgb off = sample.matt - expected_.matt[sample.texel];
    const LevelColour calm = target_of(sample.radiance - off, expected), near = cut(calm, expected),
                      all = target_of(sample.radiance, expected);
    const LevelColour fitted = cut(target_of(sample.radiance - off * expected_.alike[patch], expected), expected);
    const std::array<int64_t, 3> target = fixed(sum_of(fitted, mirrored, -1)), p = fixed(shown),
                                 whole = fixed(sum_of({all[0] - calm[0] + near[0], all[1] - calm[1] + near[1],
                                                       all[2] - calm[2] + near[2]},
                                                      mirrored, -1));
    TexelSums& texel = sums.texels[texel_in(patch, sample)];
    for (size_t c = 0; c < 3; ++c) {
        texel.target[c] += target[c];
        texel.predicted[c] += p[c];
        texel.cut_off[c] += whole[c] - target[c];
        texel.scatter += square(target[c] - p[c]);
        texel.whole_scatter += square(whole[c] - p[c]);
    }
    for (uint32_t i = 0; i < taps.count; ++i)
        for (size_t c = 0; c < 3; ++c) sums.targets[taps.taps[i].node][c] += taps.taps[i].weight_q12 * target[c];
}

void FitSums::weigh(const std::vector<uint32_t>& lines)
{
    double paths = 0, area = 0;
    for (uint32_t p = 0; p < patches_.size(); ++p) {
        const double drawn = static_cast<double>(lines[p]) * shape_.layout.rectangles[p].size();
        patches_[p].weight = drawn > 0 ? rectangle_area(shape_, p) / drawn : 0;
        area += rectangle_area(shape_, p);
        paths += drawn;
    }
    for (PatchSums& patch : patches_) patch.weight *= area > 0 ? paths / area : 1;
}

void FitSums::add(uint32_t patch, const FitSample* begin, const FitSample* end)
{
    if (begin == end) return;
    PatchSums& sums = patches_[patch];
    const std::vector<LevelColour> nodes = patch_nodes(shape_, expected_, patch);
    for (const FitSample* s = begin; s != end; ++s) {
        const SampleTaps taps = taps_of(shape_, *s, expected_.viewed);
        const uint32_t texel = texel_in(patch, *s);
        uint32_t* crossed = &sums.crossed[size_t{texel} * kPatchNodes];
        require_few_enough(++sums.texels[texel].count);
        const std::array<int64_t, 3> light = fixed(s->radiance);
        for (size_t c = 0; c < 3; ++c) sums.texels[texel].light[c] += light[c];
        for (uint32_t i = 0; i < taps.count; ++i) {
            const SampleTaps::Tap& a = taps.taps[i];
            crossed[a.node] += static_cast<uint32_t>(a.weight_q12);
            for (uint32_t j = i; j < taps.count; ++j)
                sums.pairs.add(a.node, taps.taps[j].node, int64_t{a.weight_q12} * taps.taps[j].weight_q12);
        }
        add_target(sums, nodes, *s, taps);
    }
}

void FitSums::add_again(uint32_t patch, const FitSample* begin, const FitSample* end)
{
    PatchSums& sums = patches_[patch];
    for (TexelSums& texel : sums.texels) {
        const TexelSums before = std::exchange(texel, {});
        texel.count = before.count;
        texel.light = before.light;
    }
    sums.targets.assign(kPatchNodes, {});
    const std::vector<LevelColour> nodes = patch_nodes(shape_, expected_, patch);
    for (const FitSample* s = begin; s != end; ++s) add_target(sums, nodes, *s, taps_of(shape_, *s, expected_.viewed));
}

}  // namespace lumi::baker
