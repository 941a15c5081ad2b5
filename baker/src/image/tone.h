// SPDX-License-Identifier: MIT
// Tone curves: from mean linear radiance to what is sRGB-encoded.
#pragma once

#include <cstdint>

#include "math/vec3.h"

namespace lumi::baker
{

enum class ToneCurve : uint8_t {
    srgb,      // none: radiance above 1 clips
    reinhard,  // luminance L becomes L/(1+L): Reinhard et al., "Photographic Tone Reproduction for Digital Images",
               // SIGGRAPH 2002, equation 3; hue stays
    aces,      // a fit of the ACES filmic curve per channel: K. Narkowicz, "ACES Filmic Tone Mapping Curve", 2016
    agx,  // like AgX (T. Sobotka, github.com/sobotka/AgX, 2022; Blender's default since 4.0): strong colours fade to
          // white as they get brighter; agx.h
};
inline constexpr ToneCurve kLastToneCurve = ToneCurve::agx;

// Still linear; values above 1 clip later, and so do those below 0 that AgX gives to dark, strong colours. Light below
// 0, as fits to noise may have it, is shown as none.
Rgb toned(ToneCurve curve, const Rgb& radiance);

}  // namespace lumi::baker
