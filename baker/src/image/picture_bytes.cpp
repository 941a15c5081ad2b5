// SPDX-License-Identifier: MIT
#include "image/picture_bytes.h"

#include <algorithm>
#include <cctype>
#include <fstream>

#include "lumi/baker/file_guard.h"
#include "lumi/baker/scene.h"
#include "lumi/host/png.h"
#include "util/text_lines.h"

namespace lumi::baker
{
namespace
{

namespace fs = std::filesystem;

struct KnownFormat {
    const char* name;
    const char* first;      // bytes that such a file begins with, or null
    const char* extension;  // or the end of its name, or null
};

constexpr KnownFormat kRefused[] = {
    {"a BMP", "BM", nullptr},         {"a GIF", "GIF8", nullptr},  {"a Photoshop", "8BPS", nullptr},
    {"a TIFF", "II*", nullptr},       {"a TIFF", "MM", nullptr},   {"a PNM", "P1", nullptr},
    {"a PNM", "P2", nullptr},         {"a PNM", "P3", nullptr},    {"a PNM", "P4", nullptr},
    {"a PNM", "P5", nullptr},         {"a PNM", "P6", nullptr},    {"a PNM", "P7", nullptr},
    {"a DDS", "DDS ", nullptr},       {"a WebP", "RIFF", nullptr}, {"a Radiance", "#?R", nullptr},
    {"an OpenEXR", "v/1\1", nullptr}, {"a TGA", nullptr, ".tga"},
};

bool matches(const KnownFormat& format, const fs::path& file, const std::string& bytes)
{
    if (format.first) return bytes.rfind(format.first, 0) == 0;
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == format.extension;
}

}  // namespace

std::string picture_bytes(const fs::path& file)
{
    std::error_code failed;
    if (!fs::is_regular_file(file, failed)) throw PictureError("it is no file that can be read");
    const uintmax_t size = fs::file_size(file, failed);
    if (failed || size > kMaxPictureFileBytes)
        throw PictureError("it has more than " + std::to_string(kMaxPictureFileBytes) + " bytes");
    note_input(file);
    std::ifstream stream(file, std::ios::binary);
    std::string bytes(static_cast<size_t>(size), '\0');
    if (!stream || !stream.read(bytes.data(), static_cast<std::streamsize>(size)))
        throw PictureError("it cannot be read");
    return bytes;
}

int64_t pixels_of(const std::string& bytes)
{
    constexpr size_t kWidthAt = 16, kHeightAt = 20;  // in a PNG's first chunk
    const auto number = [&](size_t place) {
        int64_t sum = 0;
        for (size_t k = 0; k < 4; ++k) sum = sum << 8 | static_cast<uint8_t>(bytes[place + k]);
        return sum;
    };
    int64_t pixels = 0;
    if (host::is_png(bytes) && bytes.size() >= kHeightAt + 4 && number(kWidthAt) <= kMaxPictureSide)
        pixels = number(kWidthAt) * number(kHeightAt);
    if (is_jpeg(bytes)) pixels = pixels_of_jpeg(bytes);
    if (is_webp(bytes)) pixels = pixels_of_webp(bytes);
    return pixels > host::kMaxPicturePixels ? 0 : pixels;
}

void PictureRoom::take(int64_t pixels)
{
    if (pixels > left_) {
        throw SceneError(
            at({model_.string()}, "its pictures are too large in all: they may have " +
                                      std::to_string(kPixelsOfAnyModel / 1'000'000) + " million pixels, and " +
                                      std::to_string(kPixelsOfAByte) +
                                      " for each byte of their files, where each use counts; make them smaller"));
    }
    left_ -= pixels;
}

DecodedPicture read_png(const fs::path& file)
{
    const std::string bytes = picture_bytes(file);
    if (!host::is_png(bytes)) throw PictureError("it is no PNG picture");
    return host::decode_png(bytes, true);
}

void refuse_picture(const fs::path& file, const std::string& bytes)
{
    const auto* format = std::find_if(std::begin(kRefused), std::end(kRefused),
                                      [&](const KnownFormat& known) { return matches(known, file, bytes); });
    throw PictureError(format == std::end(kRefused) ? std::string("it is neither PNG nor JPEG")
                                                    : std::string("it is ") + format->name + " picture");
}

}  // namespace lumi::baker
