// SPDX-License-Identifier: MIT
#include "picture.h"

#include <lumi/chord/render.h>

namespace
{

constexpr int32_t kWidth = 64;
constexpr int32_t kHeight = 40;  // an odd number of stripes
constexpr int32_t kStripeHeight = 8;
constexpr uint32_t kStride = kWidth * lumi::PixelRgb565Swapped::kBytes;
constexpr uint32_t kFieldOfView = 0x20000000;  // an eighth of a turn

uint8_t stripes[2][kStride * kStripeHeight];
int current;  // goes on from frame to frame, as the display does

}  // namespace

const char* draw_picture(const uint8_t* file, size_t file_bytes, Flush flush, void* context)
{
    lumi::Field field;
    const lumi::FieldError field_error = lumi::open_field(file, file_bytes, field);
    if (field_error != lumi::FieldError::none) return lumi::describe(field_error);
    lumi::Camera camera;
    const lumi::CameraError camera_error =
        lumi::make_camera(lumi::detail::orbit(0, 0, 3 * lumi::kOneQ20), {kWidth, kHeight, kFieldOfView}, camera);
    if (camera_error != lumi::CameraError::none) return lumi::describe(camera_error);
    for (int32_t y = 0; y < kHeight; y += kStripeHeight, current ^= 1) {
        const lumi::Stripe stripe = {stripes[current], 0, y, kWidth, kStripeHeight, kStride};
        if (lumi::render<lumi::Linear, lumi::TexelRgb565, lumi::PixelRgb565Swapped>(
                field, camera, lumi::OverColour{{0, 0, 0}}, stripe) != lumi::RenderError::none)
            return "this picture is drawn from RGB565 texels only";
        flush(context, stripes[current], sizeof(stripes[current]));
    }
    return nullptr;
}
