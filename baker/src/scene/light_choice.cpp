// SPDX-License-Identifier: MIT
#include "scene/light_choice.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lumi::baker
{
namespace
{

// Of white, after the tone curve: what clay shows in the studio.
constexpr float kMiddleTone = 0.44f;
constexpr int kStepsPerStop = 3;

class LightChooser
{
public:
    LightChooser(const StatedLight& stated, const LitShape& shape)
        : stated_(stated),
          shape_(shape),
          shines_(std::any_of(shape.materials.begin(), shape.materials.end(),
                              [](const Material& material) { return material.emits(); }))
    {
    }

    LightChoice choose()
    {
        choice_.environment = stated_.environment ? *stated_.environment : open_environment();
        const bool dark_sky = is_dark(choice_.environment);
        if (dark_sky && stated_.fixtures.empty() && !shines_)
            choice_.warnings.emplace_back(
                "the scene has no light, so it is black; give it a light, such as --sky studio");
        choice_.exposure = stated_.exposure.value_or(1);
        const bool in_any_unit = choice_.environment.picture || !stated_.fixtures.empty() || (dark_sky && shines_);
        if (!stated_.exposure && in_any_unit) choose_exposure();
        return std::move(choice_);
    }

private:
    static bool is_dark(const Environment& environment) { return !(Sky(environment).power() > 0); }

    std::vector<float> metered(const Environment& environment) const
    {
        return meter(shape_,
                     LightSet(shape_.mesh, shape_.materials, shape_.textures, environment, stated_.fixtures, 1));
    }

    // By the median of all that is seen: a display lights nothing but itself, a lamp most of what is around it.
    bool shines_enough() const
    {
        constexpr float kEnough = kMiddleTone / 16;
        const std::vector<float> own = metered(constant_environment(0));
        return !own.empty() && own[own.size() / 2] >= kEnough;
    }

    Environment open_environment()
    {
        if (!stated_.fixtures.empty() || (shines_ && shines_enough())) return constant_environment(0);
        choice_.notes.emplace_back(shines_ ? "the studio lights the scene, too, because what shines in it lights less "
                                             "than half of it; --sky black leaves the studio out"
                                           : "the studio lights the scene, which has no light of its own; --sky "
                                             "chooses another");
        return studio_environment();
    }

    // In steps of a third of a stop, from 0.
    int steps_to_middle(float lit) const
    {
        constexpr int kMost = static_cast<int>(kMostStops) * kStepsPerStop;
        const auto shown = [&](int step) {
            return luminance(toned(stated_.tone, grey(lit * std::exp2(static_cast<float>(step) / kStepsPerStop))));
        };
        int step = -kMost;
        while (step < kMost && shown(step + 1) <= kMiddleTone) ++step;
        return step < kMost && shown(step + 1) - kMiddleTone < kMiddleTone - shown(step) ? step + 1 : step;
    }

    void choose_exposure()
    {
        const std::vector<float> values = metered(choice_.environment);
        const float lit = middle_of_lit(values);
        if (!(lit > 0)) {
            if (!values.empty())
                choice_.warnings.emplace_back(
                    "no lamp lights what is seen, so it is black; move the lamps, or add --sky studio");
            return;
        }
        const int steps = steps_to_middle(lit);
        if (std::abs(steps) <= kStepsPerStop) return;
        choice_.exposure = std::exp2(static_cast<float>(steps) / kStepsPerStop);
        char text[120];
        std::snprintf(text, sizeof text,
                      "the exposure is set to %+.2f stops, by the light on the scene; --exposure "
                      "sets another",
                      static_cast<double>(steps) / kStepsPerStop);
        choice_.notes.emplace_back(text);
    }

    const StatedLight& stated_;
    const LitShape& shape_;
    const bool shines_;
    LightChoice choice_;
};

}  // namespace

LightChoice choose_light(const StatedLight& stated, const LitShape& shape)
{
    return LightChooser(stated, shape).choose();
}

}  // namespace lumi::baker
