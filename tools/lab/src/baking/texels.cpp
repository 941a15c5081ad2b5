// SPDX-License-Identifier: MIT
#include "baking/texels.h"

#include <cmath>
#include <cstdio>

namespace lumi::baker::bench
{

Scene load(const char* file)
{
    std::vector<std::string> warnings;
    Scene scene = load_scene(file, {}, warnings);
    for (const std::string& warning : warnings) std::fprintf(stderr, "lumi-lab: warning: %s\n", warning.c_str());
    return scene;
}

Difference difference(const Colours& found, const Colours& truth)
{
    double squares = 0, sum = 0;
    size_t count = 0;
    for (size_t k = 0; k < found.size(); ++k) {
        const auto &a = found[k], &b = truth[k];
        if (!a || !b) continue;
        for (const int d : {a->r - b->r, a->g - b->g, a->b - b->b}) {
            squares += d * d;
            sum += d;
            ++count;
        }
    }
    const double n = static_cast<double>(count);
    return {std::sqrt(squares / n), sum / n};
}

}  // namespace lumi::baker::bench
