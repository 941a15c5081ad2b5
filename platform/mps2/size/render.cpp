// SPDX-License-Identifier: MIT
// One reconstruction and one texel format, named by the build: LUMI_SIZE_RECONSTRUCTION, LUMI_SIZE_TEXEL.
#include "lumi/chord/render.h"

#include "probe.h"

int main(int, char**)
{
    using namespace lumi;
    static uint8_t pixels[240 * PixelRgb565::kBytes];
    Field field;
    Camera camera;
    if (!size::open(field, camera)) return 1;
    const Stripe stripe = {pixels, 0, 0, 240, 1, sizeof(pixels)};
    return render<LUMI_SIZE_RECONSTRUCTION, LUMI_SIZE_TEXEL, PixelRgb565>(field, camera, OverColour{{0, 0, 0}},
                                                                          stripe) == RenderError::none
               ? 0
               : 1;
}
