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

const Row* find_row(const Rows& rows, const std::string& core, const std::string& mode, const std::string& texel,
                    int span, const std::string& view)
{
    const auto fits = [&](const Row& row) {
        return row.core == core && row.mode == mode && row.texel == texel && row.count.span == span &&
               row.count.view == view;
    };
    const auto found = std::find_if(rows.begin(), rows.end(), fits);
    return found == rows.end() ? nullptr : &*found;
}

const SurfaceRow* find_row(const SurfaceResults& results, const std::string& core, const std::string& mode,
                           const std::string& pixel, const std::string& view)
{
    const auto fits = [&](const SurfaceRow& row) {
        return row.core == core && row.count.mode == mode && row.pixel == pixel && row.count.view == view;
    };
    const auto found = std::find_if(results.rows.begin(), results.rows.end(), fits);
    return found == results.rows.end() ? nullptr : &*found;
}

}  // namespace lumi::bench
