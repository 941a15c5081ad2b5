// SPDX-License-Identifier: MIT
// The pictures of a glTF file, each decoded once for each use of it.
#pragma once

#include <tuple>

#include "image/picture_bytes.h"
#include "model/gltf/model.h"
#include "model/losses.h"

namespace lumi::baker
{

class GltfTextures
{
public:
    // Appends to both lists, and keeps the references. Throws SceneError where the pictures are too large in all.
    GltfTextures(const GltfModel& model, std::vector<Texture>& textures, std::vector<std::string>& warnings);

    // The picture's place among the textures, or kNoTexture where it is missing or no picture; a warning says so once.
    int32_t find(const GltfTextureUse& use, PictureUse part);
    // Returns normals that lean `strength` times as far.
    int32_t find_normals(const GltfTextureUse& use);
    // Opacity that crosses one half where the picture's alpha times `alpha` crosses `cutoff`. kNoTexture also where the
    // picture is opaque all over.
    int32_t find_opacity(const GltfTextureUse& use);
    int32_t find_mask(const GltfTextureUse& use, float alpha, float cutoff);

    // A picture that is found, and one that is made.
    const Texture& picture(int32_t texture) const { return textures_[static_cast<size_t>(texture)]; }
    int32_t add(Texture texture)
    {
        room_.take(static_cast<int64_t>(texture.rgb.size() / 3));
        textures_.push_back(std::move(texture));
        return static_cast<int32_t>(textures_.size() - 1);
    }

    // In linear light, of a picture of colours.
    Rgb mean_colour_of(int32_t texture) const;
    // Returns the mean of the bytes of red (0), green (1) or blue (2), from 0 to 1.
    double mean_of(int32_t texture, size_t channel = 0) const;

private:
    using Key = std::tuple<int32_t, PictureUse, double, double>;  // image, use, and two numbers that change it

    template <class Change>
    int32_t changed(const GltfTextureUse& use, PictureUse part, double a, double b, const Change& change);
    int32_t load(int32_t image, PictureUse part);

    const GltfModel& model_;
    PictureRoom room_;
    std::vector<Texture>& textures_;
    std::vector<std::string>& warnings_;
    std::map<Key, int32_t> known_;
    std::map<int32_t, bool> warned_;  // images
};

// Where a slot reads, with v upwards as everywhere here; glTF's v goes down.
TextureSlot slot_of(const GltfTextureUse& use, int32_t texture);

}  // namespace lumi::baker
