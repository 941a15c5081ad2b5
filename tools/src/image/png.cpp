// SPDX-License-Identifier: MIT
#include "image/png.h"

#include <cstring>
#include <limits>
#include <memory>
#include <stdexcept>

#include "files/output_file.h"
#include "lumi/baker/file_guard.h"
#include "lumi/host/mapped_file.h"
#include "terminal/failure.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>
#pragma GCC diagnostic pop

namespace lumi::tools
{

namespace
{

constexpr int kChannels = 3;

void append(void* context, void* data, int size)
{
    static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<size_t>(size));
}

host::MappedFile map(const std::string& path)
{
    baker::note_input(path);
    host::MappedFile file;
    if (const int error = file.open(path); error != 0)
        throw Failure(path, std::string("cannot be read (") + std::strerror(error) + ")", "check the path");
    if (file.size() > static_cast<size_t>(std::numeric_limits<int>::max()))
        throw Failure(path, "is larger than 2 GiB", "give a smaller picture");
    return file;
}

}  // namespace

Picture read_png(const std::string& path)
{
    const host::MappedFile file = map(path);
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(file.bytes(), static_cast<int>(file.size()), &width, &height, &channels, kChannels),
        stbi_image_free);
    if (!pixels)
        throw Failure(path, std::string("is not a PNG file that can be read (") + stbi_failure_reason() + ")",
                      "give a whole PNG file");
    Picture picture(width, height);
    std::memcpy(picture.rgb.data(), pixels.get(), picture.rgb.size());
    return picture;
}

std::string png_bytes(const Picture& picture)
{
    std::string bytes;
    const int row_bytes = kChannels * picture.width_px;
    if (!stbi_write_png_to_func(append, &bytes, picture.width_px, picture.height_px, kChannels, picture.rgb.data(),
                                row_bytes))
        throw std::length_error("the picture could not be packed");
    return bytes;
}

void write_png(const std::string& path, const Picture& picture)
{
    try {
        write_output(path, png_bytes(picture));
    } catch (const std::length_error& error) {
        throw Failure(path, error.what(), "choose a smaller --size");
    }
}

}  // namespace lumi::tools
