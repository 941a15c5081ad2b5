// SPDX-License-Identifier: MIT
#include "model/gltf/textures.h"

#include <algorithm>
#include <cmath>

#include "image/tone.h"
#include "util/text_lines.h"

namespace lumi::baker
{
namespace
{

uint8_t byte_of(float unit)
{
    return static_cast<uint8_t>(std::lround(std::clamp(unit, 0.0f, 1.0f) * 255));
}

Texture leaning(Texture texture, float strength)
{
    for (size_t k = 0; k + 2 < texture.rgb.size(); k += 3) {
        const auto component = [&](size_t c) { return static_cast<float>(texture.rgb[k + c]) / 255 * 2 - 1; };
        const Vec3 n = {component(0) * strength, component(1) * strength, component(2)};
        const float size = std::max(length(n), 1e-6f);
        texture.rgb[k] = byte_of(n.x / size * 0.5f + 0.5f);
        texture.rgb[k + 1] = byte_of(n.y / size * 0.5f + 0.5f);
        texture.rgb[k + 2] = byte_of(n.z / size * 0.5f + 0.5f);
    }
    return texture;
}

// Steep, but not a step: between pixels the edge then lies where alpha crosses the cutoff.
Texture cut(Texture texture, float alpha, float cutoff)
{
    constexpr float kSlope = 8;
    for (uint8_t& byte : texture.rgb) byte = byte_of(0.5f + (static_cast<float>(byte) / 255 * alpha - cutoff) * kSlope);
    return texture;
}

}  // namespace

GltfTextures::GltfTextures(const GltfModel& model, std::vector<Texture>& textures, std::vector<std::string>& warnings)
    : model_(model), room_(model.file), textures_(textures), warnings_(warnings)
{
    int64_t pixels = 0;
    for (const GltfImage& image : model.images) {
        room_.add(image.bytes.size());
        pixels += pixels_of(image.bytes);
    }
    PictureRoom(room_).take(pixels);  // so that what is too much is refused before anything is decoded
}

int32_t GltfTextures::load(int32_t image, PictureUse part)
{
    const GltfImage& picture = element_of(model_, model_.images, image, "picture");
    std::string fault = picture.bytes.empty() ? "it is missing" : "";
    if (fault.empty()) {
        room_.take(pixels_of(picture.bytes));
        try {
            const std::string name = picture.name.empty() ? "picture" : picture.name;
            textures_.push_back(decode_texture(name, picture.bytes, part));
            return static_cast<int32_t>(textures_.size() - 1);
        } catch (const PictureError& e) {
            fault = e.what();
        }
    }
    if (!warned_[image]) {
        const std::string name = picture.name.empty() ? std::to_string(image) : "'" + picture.name + "'";
        const std::string mend = picture.bytes.empty() ? "put it beside " + model_.file.filename().string()
                                                       : std::string("export it as PNG or JPEG");
        warnings_.push_back(at({model_.file.string()},
                               "the picture " + name + " is not used (" + fault + "), the plain number is; " + mend));
        warned_[image] = true;
    }
    return kNoTexture;
}

template <class Change>
int32_t GltfTextures::changed(const GltfTextureUse& use, PictureUse part, double a, double b, const Change& change)
{
    if (!use.used()) return kNoTexture;
    const auto [entry, fresh] = known_.try_emplace(Key{use.image, part, a, b}, kNoTexture);
    if (!fresh) return entry->second;
    const int32_t texture = load(use.image, part);
    if (texture != kNoTexture) {
        Texture& loaded = textures_[static_cast<size_t>(texture)];
        loaded = change(std::move(loaded));
    }
    entry->second = texture;
    return texture;
}

int32_t GltfTextures::find(const GltfTextureUse& use, PictureUse part)
{
    return changed(
        use, part, 0, 0, [](Texture t) { return t; });
}

int32_t GltfTextures::find_normals(const GltfTextureUse& use)
{
    const float strength = static_cast<float>(std::clamp(use.strength, -100.0, 100.0));
    return changed(use, PictureUse::data, 1, use.strength,
                   [&](Texture t) { return strength == 1 ? t : leaning(std::move(t), strength); });
}

int32_t GltfTextures::find_opacity(const GltfTextureUse& use)
{
    const int32_t texture = find(use, PictureUse::opacity);
    return texture == kNoTexture || mean_of(texture) < 1 ? texture : kNoTexture;
}

int32_t GltfTextures::find_mask(const GltfTextureUse& use, float alpha, float cutoff)
{
    const int32_t texture =
        changed(use, PictureUse::opacity, static_cast<double>(alpha) + 2, static_cast<double>(cutoff),
                [&](Texture t) { return cut(std::move(t), alpha, cutoff); });
    return texture == kNoTexture || mean_of(texture) < 1 ? texture : kNoTexture;
}

double GltfTextures::mean_of(int32_t texture, size_t channel) const
{
    const std::vector<uint8_t>& bytes = textures_[static_cast<size_t>(texture)].rgb;
    uint64_t sum = 0;
    for (size_t k = channel; k < bytes.size(); k += 3) sum += bytes[k];
    return static_cast<double>(sum) / (255.0 * static_cast<double>(bytes.size() / 3));
}

Rgb GltfTextures::mean_colour_of(int32_t texture) const
{
    const std::vector<uint8_t>& bytes = picture(texture).rgb;
    std::array<double, 3> sum{};
    for (size_t k = 0; k < bytes.size(); ++k) sum[k % 3] += static_cast<double>(srgb_decode(bytes[k]));
    const double pixels = static_cast<double>(bytes.size() / 3);
    return {static_cast<float>(sum[0] / pixels), static_cast<float>(sum[1] / pixels),
            static_cast<float>(sum[2] / pixels)};
}

TextureSlot slot_of(const GltfTextureUse& use, int32_t texture)
{
    TextureSlot slot;
    slot.texture = texture;
    slot.scale = use.scale;
    const float c = static_cast<float>(std::cos(use.rotation)), s = static_cast<float>(std::sin(use.rotation));
    slot.turn = {c, s};
    slot.offset = {use.offset.x + s * use.scale.y, 1 - use.offset.y - c * use.scale.y};
    slot.wrap = use.wrap;
    return slot;
}

}  // namespace lumi::baker
