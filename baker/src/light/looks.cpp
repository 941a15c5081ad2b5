// SPDX-License-Identifier: MIT
// The skies that have names. A product is lit by soft boxes: panels of light, here so far away that all of the scene
// sees them in the same directions.
#include <cmath>
#include <memory>
#include <vector>

#include "image/radiance_picture.h"
#include "lumi/baker/scene.h"
#include "math/vec3.h"
#include "math/warp.h"

namespace lumi::baker
{

namespace
{

constexpr int kHeight = 128, kWidth = 2 * kHeight;  // of a painted sky: 1.4 degrees a pixel
constexpr float kFalloff = 0.3f;                    // by this share a soft box is dimmer at its corners

// A rectangle that faces the scene. Lengths are in shares of its distance.
struct SoftBox {
    float azimuth, elevation;  // of its middle, in degrees
    float half_width, half_height;
    float edge;    // it fades over this length
    Rgb radiance;  // of its middle; added to what is behind it
};

float smooth(float x)
{
    const float t = std::clamp(x, 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

// The share of the box's radiance that comes from a direction.
float share_of(const SoftBox& box, const Vec3& direction)
{
    const float turns = box.azimuth / 360;
    const Vec3 middle = direction_at(std::sin(box.elevation * kPi / 180), turns),
               right = direction_at(0, turns + 0.25f);
    const float ahead = dot(direction, middle);
    if (!(ahead > 0)) return 0;
    const float x = std::abs(dot(direction, right)) / ahead;
    const float y = std::abs(dot(direction, cross(middle, right))) / ahead;
    const float u = x / box.half_width, v = y / box.half_height;
    return smooth((box.half_width - x) / box.edge) * smooth((box.half_height - y) / box.edge) *
           (1 - kFalloff / 2 * (u * u + v * v));
}

// The boxes before a gradient.
Environment painted(const Environment& gradient, const std::vector<SoftBox>& boxes)
{
    const auto rgb = [](const std::array<float, 3>& c) { return Rgb{c[0], c[1], c[2]}; };
    auto picture = std::make_shared<RadiancePicture>(RadiancePicture{kWidth, kHeight, {}});
    for (int k = 0; k < kWidth * kHeight; ++k) {
        const float down = (static_cast<float>(k / kWidth) + 0.5f) / kHeight;
        const float height = std::cos(down * kPi), slope = std::abs(height);
        const Vec3 direction = direction_at(height, 1.5f - (static_cast<float>(k % kWidth) + 0.5f) / kWidth);
        Rgb light = rgb(gradient.horizon) * (1 - slope) + rgb(height > 0 ? gradient.zenith : gradient.nadir) * slope;
        for (const SoftBox& box : boxes) light = light + box.radiance * share_of(box, direction);
        picture->pixels.push_back(light);
    }
    Environment environment = gradient;
    environment.picture = std::move(picture);
    environment.needs_exposure = false;
    return environment;
}

// The sun is a broad bright spot in the clouds.
Environment overcast()
{
    return painted({{0.9f, 0.95f, 1.04f}, {0.56f, 0.59f, 0.63f}, {0.27f, 0.26f, 0.245f}},
                   {{-40, 50, 1.2f, 1.2f, 1.2f, {1.24f, 1.22f, 1.17f}}});
}

// A low sun behind a curtain, its glow along the horizon, and a window to the blue sky behind.
Environment evening()
{
    return painted({{0.27f, 0.345f, 0.54f}, {0.59f, 0.48f, 0.455f}, {0.295f, 0.246f, 0.22f}},
                   {{-68, 16, 0.32f, 0.34f, 0.1f, {11, 6.6f, 3.1f}},
                    {-68, 5, 2.6f, 0.7f, 0.7f, {1.23f, 0.68f, 0.345f}},
                    {130, 30, 0.3f, 0.55f, 0.2f, {1.48f, 2.1f, 3.3f}}});
}

}  // namespace

Environment constant_environment(float radiance)
{
    return constant_environment({radiance, radiance, radiance});
}

Environment constant_environment(const std::array<float, 3>& radiance)
{
    return {radiance, radiance, radiance};
}

Environment gradient_environment()
{
    // Light from above weighs 1.2: a white of 0.8 facing up stays just below clipping.
    return {{1.55f, 1.58f, 1.65f}, {0.5f, 0.5f, 0.52f}, {0.16f, 0.15f, 0.14f}};
}

// A large box above and a little behind, the key light at the left front, a strip at the right behind, a light floor.
// The other sides are dark. White of 0.8 stays just below clipping wherever it faces.
Environment studio_environment()
{
    return painted({{0.2f, 0.2f, 0.2f}, {0.15f, 0.15f, 0.15f}, {0.5f, 0.5f, 0.5f}},
                   {{175, 78, 0.66f, 0.42f, 0.1f, grey(3.5f)},
                    {-54, 17, 0.32f, 0.5f, 0.1f, grey(5)},
                    {138, 14, 0.14f, 0.6f, 0.1f, grey(6.8f)}});
}

std::optional<Environment> named_environment(const std::string& name)
{
    if (name == "studio") return studio_environment();
    if (name == "gradient") return gradient_environment();
    if (name == "overcast") return overcast();
    if (name == "evening") return evening();
    if (name == "black") return constant_environment(0);
    return std::nullopt;
}

}  // namespace lumi::baker
