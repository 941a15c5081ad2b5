// SPDX-License-Identifier: MIT
// consumer FIELD: draws one picture of an RGB565 field with two stripe buffers, as a product with a display does, and
// exits with 0 if the object is in it.
#include <lumi/render.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <vector>

namespace
{

constexpr int32_t kWidth = 64;
constexpr int32_t kHeight = 48;
constexpr int32_t kStripeRows = 8;
constexpr uint32_t kStride = kWidth * lumi::PixelRgb565Swapped::kBytes;
constexpr uint32_t kFieldOfView = 0x20000000;  // an eighth of a turn

// Stands for a display's DMA: counts the bytes that are not background.
int32_t flush(const uint8_t* pixels, uint32_t bytes)
{
    int32_t lit = 0;
    for (uint32_t k = 0; k < bytes; ++k) {
        lit += pixels[k] != 0 ? 1 : 0;
    }
    return lit;
}

int32_t draw(const lumi::Field& field, const lumi::Camera& camera)
{
    static uint8_t buffers[2][kStride * kStripeRows];
    int32_t lit = 0;
    int current = 0;
    for (int32_t y = 0; y < kHeight; y += kStripeRows, current ^= 1) {
        const lumi::Stripe stripe = {buffers[current], 0, y, kWidth, kStripeRows, kStride};
        if (lumi::render<lumi::Linear, lumi::TexelRgb565, lumi::PixelRgb565Swapped>(
                field, camera, lumi::OverColour{{0, 0, 0}}, stripe) != lumi::RenderError::none) {
            return 0;
        }
        lit += flush(buffers[current], sizeof(buffers[current]));
    }
    return lit;
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 2) {
        return 1;
    }
    std::ifstream file(argv[1], std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    lumi::Field field;
    const lumi::FieldError field_error =
        lumi::open_field(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size(), field);
    if (field_error != lumi::FieldError::none) {
        std::fprintf(stderr, "%s: %s\n", argv[1], lumi::describe(field_error));
        return 1;
    }
    lumi::Camera camera;
    const lumi::Pose pose = lumi::orbit(0, 0, 3 * lumi::kOneQ20);
    if (lumi::make_camera(pose, {kWidth, kHeight, kFieldOfView}, camera) != lumi::CameraError::none) {
        return 1;
    }
    const int32_t lit = draw(field, camera);
    std::printf("%d bytes are not background\n", static_cast<int>(lit));
    return lit > 0 ? 0 : 1;
}
