// SPDX-License-Identifier: MIT
// Exits with 0 if the object is in the picture.
#include <lumi/chord/view.h>

#include <algorithm>

#include "consumer_field.h"

namespace
{

constexpr int32_t kWidth = 64, kHeight = 40;
lumi::View<lumi::ChordDrawing<lumi::TexelRgb565>, lumi::Screen<kWidth, kHeight, kHeight>> view;
alignas(4) uint8_t pixels[view.kStripeBytes];

}  // namespace

int main()
{
    const bool is_drawn = view.open(consumer_field, consumer_field_size()) == lumi::ViewError::none &&
                          view.look(lumi::Orbit{}) == lumi::ViewError::none &&
                          view.draw({pixels, 0, 0, kWidth, kHeight, 2 * kWidth}) == lumi::ViewError::none;
    return is_drawn && std::any_of(pixels, pixels + sizeof pixels, [](uint8_t byte) { return byte != 0; }) ? 0 : 1;
}
