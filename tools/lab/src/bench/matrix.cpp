// SPDX-License-Identifier: MIT
#include "bench/matrix.h"

#include <algorithm>

namespace lumi::bench
{

Matrix quick_matrix()
{
    return {{"m0plus", "m4"},     {"nearest", "linear", "one-sample", "antialiased", "2x2"},
            {"rgb565", "rgb888"}, {"generic"},
            {"rgb565"},           {16}};
}

const Result* find_result(const Results& results, const std::string& core, const std::string& mode,
                          const std::string& texel, int span, const std::string& view)
{
    const auto fits = [&](const Result& result) {
        return result.core == core && result.mode == mode && result.texel == texel && result.count.span == span &&
               result.count.view == view;
    };
    const auto found = std::find_if(results.begin(), results.end(), fits);
    return found == results.end() ? nullptr : &*found;
}

const SurfaceResult* find_result(const SurfaceResults& surface, const std::string& core, const std::string& mode,
                                 const std::string& pixel, const std::string& view)
{
    const auto fits = [&](const SurfaceResult& result) {
        return result.core == core && result.count.mode == mode && result.pixel == pixel && result.count.view == view;
    };
    const auto found = std::find_if(surface.results.begin(), surface.results.end(), fits);
    return found == surface.results.end() ? nullptr : &*found;
}

}  // namespace lumi::bench
