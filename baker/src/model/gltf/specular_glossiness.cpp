// SPDX-License-Identifier: MIT
#include "model/gltf/specular_glossiness.h"

#include <algorithm>
#include <cmath>

#include "image/tone.h"

namespace lumi::baker
{
namespace
{

constexpr float kDielectric = 0.04f;  // most plastics

// Perceived, as the extension weighs it.
float brightness(const Rgb& c)
{
    return std::sqrt(0.299f * c.r * c.r + 0.587f * c.g * c.g + 0.114f * c.b * c.b);
}

Rgb colour_at(const FactoredPicture& from, int x, int y, int width, int height)
{
    if (!from.picture) return from.factor;
    const Texture& t = *from.picture;
    const size_t column = static_cast<size_t>(int64_t{x} * t.width / width);
    const size_t row = static_cast<size_t>(int64_t{y} * t.height / height);
    const uint8_t* p = &t.rgb[3 * (row * static_cast<size_t>(t.width) + column)];
    return from.factor * Rgb{srgb_decode(p[0]), srgb_decode(p[1]), srgb_decode(p[2])};
}

uint8_t as_byte(float unit)
{
    return static_cast<uint8_t>(std::lround(std::clamp(unit, 0.0f, 1.0f) * 255));
}

uint8_t encoded(float linear)
{
    return as_byte(srgb_encode_unit(linear));
}

}  // namespace

Metallic metallic_of(const Rgb& diffuse, const Rgb& specular, float f0)
{
    const float through = 1 - std::min(max_component(specular), 1.0f);
    const float d = brightness(diffuse), s = brightness(specular);
    if (s <= f0) return {diffuse, 0};
    const float b = d * through / (1 - f0) + s - 2 * f0, c = f0 - s;
    const float metal = std::clamp((-b + std::sqrt(std::max(b * b - 4 * f0 * c, 0.0f))) / (2 * f0), 0.0f, 1.0f);
    constexpr float kLeast = 1e-4f;
    const Rgb of_body = diffuse * (through / (1 - f0) / std::max(1 - metal, kLeast));
    const Rgb of_metal = (specular - grey(f0 * (1 - metal))) * (1 / std::max(metal, kLeast));
    const Rgb mixed = of_body * (1 - metal * metal) + of_metal * (metal * metal);
    const auto unit = [](float v) { return std::clamp(v, 0.0f, 1.0f); };
    return {{unit(mixed.r), unit(mixed.g), unit(mixed.b)}, metal};
}

MetallicPictures metallic_pictures(const FactoredPicture& diffuse, const FactoredPicture& specular)
{
    int width = 1, height = 1;
    for (const Texture* picture : {diffuse.picture, specular.picture}) {
        if (!picture) continue;
        width = std::max(width, picture->width);
        height = std::max(height, picture->height);
    }
    MetallicPictures result;
    double body = 0, bodies = 0;
    const auto for_each = [&](const auto& take) {
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                take(colour_at(diffuse, x, y, width, height), colour_at(specular, x, y, width, height));
    };
    constexpr float kMetal = 0.5f;
    for_each([&](const Rgb& d, const Rgb& s) {
        if (metallic_of(d, s, kDielectric).metalness >= kMetal) {
            result.is_metal_somewhere = true;
            return;
        }
        body += static_cast<double>(max_component(s));
        ++bodies;
    });
    if (bodies > 0) result.f0 = static_cast<float>(body / bodies);
    if (!result.is_metal_somewhere) return result;
    result.f0 = std::clamp(result.f0, 0.01f, 2 * kDielectric);
    result.plain = metallic_of(diffuse.factor, specular.factor, result.f0);
    if (!diffuse.picture && !specular.picture) return result;
    result.base = {width, height, {}, true};
    result.metalness = {width, height, {}, false};
    for_each([&](const Rgb& d, const Rgb& s) {
        const Metallic m = metallic_of(d, s, result.f0);
        result.base.rgb.insert(result.base.rgb.end(), {encoded(m.base.r), encoded(m.base.g), encoded(m.base.b)});
        result.metalness.rgb.insert(result.metalness.rgb.end(), 3, as_byte(m.metalness));
    });
    return result;
}

Texture roughness_picture(Texture glossiness, float factor)
{
    for (uint8_t& byte : glossiness.rgb) byte = as_byte(1 - static_cast<float>(byte) / 255 * factor);
    return glossiness;
}

}  // namespace lumi::baker
