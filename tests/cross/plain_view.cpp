// SPDX-License-Identifier: MIT
// A firmware that draws a field without view tables, for a test of what it links. Never run.
#include "lumi/surface/view.h"

using namespace lumi;

extern const uint8_t product[];
alignas(8) const uint8_t product[8] = {};

static View<SurfaceDrawing<100, 100, SurfaceMode::antialiased, 0, 0>, Screen<48, 37, 8>> view;
static uint8_t pixels[2 * 48 * 8];

int main()
{
    const Stripe stripe = {pixels, 0, 0, 48, 8, 96};
    ViewError error = view.open(product, sizeof product);
    if (error == ViewError::none) error = view.look(Orbit{degrees(30), degrees(20), radii(3)});
    return error == ViewError::none ? static_cast<int>(view.draw(stripe)) : static_cast<int>(error);
}
