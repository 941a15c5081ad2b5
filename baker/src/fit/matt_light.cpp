// SPDX-License-Identifier: MIT
#include "fit/matt_light.h"

#include <algorithm>

namespace lumi::baker
{
namespace
{

using detail::format::kViewNodes;

constexpr double kChance = 0.4;  // by so much the ratio of variances exceeds 1 by chance alone

struct Group {
    Rgb sum;
    double count = 0;
};

double square(const Rgb& c)
{
    return static_cast<double>(c.r * c.r + c.g * c.g + c.b * c.b);
}

// The node of the first corner's view table that lies nearest to the eye.
uint32_t nearest_node(const FitShape& shape, uint32_t patch, const FitSample& sample)
{
    const detail::ViewTaps taps = shape.taps(shape.vertex(patch, 0), sample.eye);
    return taps.node[std::max_element(taps.weight_q8, taps.weight_q8 + 3) - taps.weight_q8];
}

void set_means(const PatchRectangle& r, const FitSample* begin, const FitSample* end, std::vector<Rgb>& matt)
{
    std::vector<Group> texels(r.size());
    Group all;
    for (const FitSample* s = begin; s != end; ++s) {
        for (Group* g : {&texels[s->texel - r.begin], &all}) {
            g->sum = g->sum + s->matt;
            g->count += 1;
        }
    }
    for (size_t t = 0; t < texels.size(); ++t) {
        const Group& known = texels[t].count > 0 ? texels[t] : all;
        matt[r.begin + t] = known.sum * static_cast<float>(1 / std::max(known.count, 1.0));
    }
}

}  // namespace

void learn_matt_light(const FitShape& shape, uint32_t patch, const FitSample* begin, const FitSample* end,
                      double more_paths, FitModel& model)
{
    set_means(shape.layout.rectangles[patch], begin, end, model.matt);
    std::array<Group, kViewNodes> views;
    double squares = 0;
    for (const FitSample* s = begin; s != end; ++s) {
        const Rgb off = s->matt - model.matt[s->texel];
        Group& view = views[nearest_node(shape, patch, *s)];
        view.sum = view.sum + off;
        view.count += 1;
        squares += square(off);
    }
    double groups = 0, between = 0;
    for (const Group& view : views) {
        if (view.count == 0) continue;
        ++groups;
        between += square(view.sum) / view.count;
    }
    const auto paths = static_cast<double>(end - begin);
    // The variance of views' means over what chance makes it, as in an analysis of variance.
    const double ratio = groups > 0 && squares > 0 ? between / groups / (squares / paths) : 1;
    // Weighs the noise that is taken away against the difference that is lost.
    const double differs = std::max(0.0, ratio - 1 - kChance);
    model.alike[patch] = static_cast<float>(1 / (1 + more_paths * differs));
}

}  // namespace lumi::baker
