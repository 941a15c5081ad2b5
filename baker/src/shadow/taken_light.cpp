// SPDX-License-Identifier: MIT
#include "shadow/taken_light.h"

#include <algorithm>
#include <cmath>

#include "math/sampler.h"

namespace lumi::baker
{

TakenLight taken_light(const Ray& ray, const PathTracer& with, const PathTracer& without, const PathNumbers& numbers)
{
    float lit = 0, all = 0;
    for (uint32_t path = 0; path < numbers.paths; ++path) {
        Sampler first(numbers.seed, numbers.place, 0), second(numbers.seed, numbers.place, 0);
        first.start(path);
        second.start(path);
        lit += luminance(with.trace(ray, first).radiance);
        all += luminance(without.trace(ray, second).radiance);
    }
    return {all > 0 ? std::clamp(1 - lit / all, 0.0f, 1.0f) : 0, all / static_cast<float>(numbers.paths)};
}

uint8_t passed_share(const EncodedTone& tone, float light, float rest)
{
    const auto levels = [&](float l) { return std::min(tone.encoded(grey(l))[1], 255.0f); };
    const float share = levels(light) > 0 ? levels(light * rest) / levels(light) : 1;
    return static_cast<uint8_t>(std::lround(255 * std::clamp(share, 0.0f, 1.0f)));
}

}  // namespace lumi::baker
