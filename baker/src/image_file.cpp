// SPDX-License-Identifier: MIT
#include "image_file.h"

#include <fstream>
#include <iterator>
#include <limits>
#include <memory>

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

std::optional<Texture> read_texture(const std::filesystem::path& file, std::string& why)
{
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
    Texture texture;
    int channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size()),
                              &texture.width, &texture.height, &channels, 3),
        stbi_image_free);
    if (!pixels) {
        why = stbi_failure_reason();
        return std::nullopt;
    }
    const size_t size = 3 * static_cast<size_t>(texture.width) * static_cast<size_t>(texture.height);
    texture.rgb.assign(pixels.get(), pixels.get() + size);
    return texture;
}

}  // namespace lumi::baker
