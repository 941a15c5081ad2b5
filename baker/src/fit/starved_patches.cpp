// SPDX-License-Identifier: MIT
#include "fit/starved_patches.h"

namespace lumi::baker
{
namespace
{

constexpr float kFewPaths = 2;    // paths a texel, in the mean
constexpr float kForce = 0.5f;    // weight, in light paths, of what is drawn from the patches around
constexpr int kMostDistance = 8;  // patches that far from any light that was traced

struct Mean {
    LevelColour sum{};
    float paths = 0;

    void add(const LevelColour& colour, float weight)
    {
        paths += weight;
        for (size_t c = 0; c < 3; ++c) sum[c] += weight * colour[c];
    }
    LevelColour colour() const { return {sum[0] / paths, sum[1] / paths, sum[2] / paths}; }
};

class StarvedPatches
{
public:
    StarvedPatches(const FitShape& shape, const std::vector<uint32_t>& counts, std::vector<LevelColour>& texels)
        : shape_(shape), counts_(counts), texels_(texels), fitted_(texels)
    {
        for (const PatchRectangle& r : shape.layout.rectangles) {
            Mean mean;
            for (uint32_t t = r.begin; t < r.begin + r.size(); ++t) mean.add(texels[t], static_cast<float>(counts[t]));
            means_.push_back(mean);
            was_met_.push_back(mean.paths > 0);
        }
    }

    void fill()
    {
        for (int round = 0; round < kMostDistance; ++round) {
            const std::vector<Mean> around = vertex_means();
            for (uint32_t p = 0; p < means_.size(); ++p)
                if (means_[p].paths < enough(p)) draw_to(around, p);
        }
    }

private:
    float enough(uint32_t patch) const
    {
        return kFewPaths * static_cast<float>(shape_.layout.rectangles[patch].size());
    }

    template <class Function>
    void each_vertex(uint32_t patch, Function f) const
    {
        for (uint32_t corner = 0; corner < 4; ++corner)
            if (const uint32_t v = shape_.vertex(patch, corner); v != PatchMesh::kNone) f(v);
    }

    std::vector<Mean> vertex_means() const
    {
        std::vector<Mean> result(shape_.mesh.positions.size());
        for (uint32_t p = 0; p < means_.size(); ++p) {
            if (means_[p].paths > 0) {
                const LevelColour colour = means_[p].colour();
                const float trust = std::min(1.0f, means_[p].paths / enough(p));
                each_vertex(p, [&](uint32_t v) { result[v].add(colour, trust); });
            }
        }
        return result;
    }

    void draw_to(const std::vector<Mean>& around, uint32_t patch)
    {
        Mean all;
        each_vertex(patch, [&](uint32_t v) {
            if (around[v].paths > 0) all.add(around[v].colour(), around[v].paths);
        });
        if (all.paths == 0) return;
        const LevelColour colour = all.colour();
        const float filled = was_met_[patch] ? kForce : 0;  // from within the patch
        const PatchRectangle& r = shape_.layout.rectangles[patch];
        for (uint32_t t = r.begin; t < r.begin + r.size(); ++t) {
            Mean drawn;
            drawn.add(fitted_[t], counts_[t] != 0 ? static_cast<float>(counts_[t]) : filled);
            drawn.add(colour, kForce);
            texels_[t] = drawn.colour();
        }
        if (means_[patch].paths == 0) means_[patch].add(colour, kForce);
    }

    const FitShape& shape_;
    const std::vector<uint32_t>& counts_;
    std::vector<LevelColour>& texels_;
    const std::vector<LevelColour> fitted_;
    std::vector<Mean> means_;    // by patch
    std::vector<bool> was_met_;  // by any path
};

}  // namespace

void fill_starved_patches(const FitShape& shape, const std::vector<uint32_t>& counts, std::vector<LevelColour>& texels)
{
    StarvedPatches(shape, counts, texels).fill();
}

}  // namespace lumi::baker
