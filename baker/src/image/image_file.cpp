// SPDX-License-Identifier: MIT
#include "image/image_file.h"

#include <fstream>
#include <iterator>
#include <limits>
#include <memory>

#include "lumi/baker/file_guard.h"
#include "lumi/baker/scene.h"
#include "util/text_lines.h"

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 32768
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace lumi::baker
{
namespace
{

// The reader of plain pixel maps (P5, P6) adds up the digits of its header without looking for an overflow.
bool has_endless_number(const std::string& bytes)
{
    constexpr size_t kMostDigits = 8, kHeader = 4096;
    size_t digits = 0;
    for (size_t k = 0; k < std::min(bytes.size(), kHeader) && bytes[0] == 'P'; ++k) {
        digits = bytes[k] >= '0' && bytes[k] <= '9' ? digits + 1 : 0;
        if (digits > kMostDigits) {
            return true;
        }
    }
    return false;
}

// What the reader says, which for some damages is nothing.
std::string failure_reason()
{
    const char* reason = stbi_failure_reason();
    return reason && *reason ? reason : "it is damaged";
}

}  // namespace

std::optional<Texture> read_texture(const std::filesystem::path& file, PictureUse use, std::string& why)
{
    note_input(file);
    std::ifstream stream(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (!stream.good() && bytes.empty()) {
        why = "it cannot be read";
        return std::nullopt;
    }
    if (bytes.size() > static_cast<size_t>(std::numeric_limits<int>::max())) {
        why = "it is larger than 2 GB";
        return std::nullopt;
    }
    if (has_endless_number(bytes)) {
        why = "its header is damaged";
        return std::nullopt;
    }
    Texture texture;
    constexpr int kChannels = 4;
    int channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size()),
                              &texture.width, &texture.height, &channels, kChannels),
        stbi_image_free);
    if (!pixels) {
        why = failure_reason();
        return std::nullopt;
    }
    if (texture.width < 1 || texture.height < 1) {
        why = "it has no pixels";
        return std::nullopt;
    }
    const bool has_alpha = channels == 2 || channels == 4;
    const size_t count = static_cast<size_t>(texture.width) * static_cast<size_t>(texture.height);
    texture.rgb.reserve(3 * count);
    for (size_t k = 0; k < count; ++k) {
        const stbi_uc* p = pixels.get() + kChannels * k;
        if (use == PictureUse::alpha && has_alpha) {
            texture.rgb.insert(texture.rgb.end(), 3, p[3]);
        } else {
            texture.rgb.insert(texture.rgb.end(), p, p + 3);
        }
    }
    texture.encoded = use == PictureUse::colour;
    return texture;
}

RadiancePicture read_hdr(const std::filesystem::path& file, const std::string& bytes)
{
    const stbi_uc* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(std::min<size_t>(bytes.size(), std::numeric_limits<int>::max()));
    if (!stbi_is_hdr_from_memory(data, size)) {
        throw SceneError(
            at({file.string()}, "this is neither a Radiance .hdr nor an OpenEXR picture; save it as one of them"));
    }
    RadiancePicture picture;
    int channels = 0;
    const std::unique_ptr<float, void (*)(void*)> floats(
        stbi_loadf_from_memory(data, size, &picture.width, &picture.height, &channels, 3), stbi_image_free);
    if (!floats) {
        throw SceneError(at({file.string()}, std::string("the picture cannot be read (") + failure_reason() +
                                                 "); save it again as .hdr"));
    }
    if (picture.width < 1 || picture.height < 1) {
        throw SceneError(at({file.string()}, "the picture has no pixels; save it again as .hdr"));
    }
    const size_t count = static_cast<size_t>(picture.width) * static_cast<size_t>(picture.height);
    for (size_t k = 0; k < count; ++k) {
        const float* p = floats.get() + 3 * k;
        picture.pixels.push_back({p[0], p[1], p[2]});
    }
    return picture;
}

}  // namespace lumi::baker
