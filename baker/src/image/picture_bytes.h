// SPDX-License-Identifier: MIT
// All readers of pictures share these: they take the bytes of a file, and check limits before they decode anything.
#pragma once

#include <string>

#include "lumi/baker/picture_file.h"

namespace lumi::baker
{

using host::check_picture_bytes;
using host::check_picture_size;

// The whole file. Refuses folders, devices, pipes and what is too large before it reads. Throws PictureError.
std::string picture_bytes(const std::filesystem::path& file);

// The pixels that a PNG, JPEG or WebP picture claims; 0 where it would not be decoded. Reads only its head.
int64_t pixels_of(const std::string& bytes);
int64_t pixels_of_jpeg(const std::string& bytes);
int64_t pixels_of_webp(const std::string& bytes);

// The pictures of one model may have so many pixels once each use of them is decoded, and so many more for each byte of
// their files. Photographs have at most 30 pixels a byte, and few are used twice.
class PictureRoom
{
public:
    explicit PictureRoom(std::filesystem::path model) : model_(std::move(model)) {}

    // Makes room for a picture's uses, by its bytes; once for each picture.
    void add(size_t bytes) { left_ += kPixelsOfAByte * static_cast<int64_t>(bytes); }
    // Counts pixels that are about to be decoded or made. Throws SceneError for too many.
    void take(int64_t pixels);

private:
    static constexpr int64_t kPixelsOfAnyModel = 160'000'000, kPixelsOfAByte = 32;

    std::filesystem::path model_;
    int64_t left_ = kPixelsOfAnyModel;
};

// Throws PictureError that names the format of bytes that no reader takes.
[[noreturn]] void refuse_picture(const std::filesystem::path& file, const std::string& bytes);

bool is_jpeg(const std::string& bytes);
bool is_webp(const std::string& bytes);
// Alpha only where it is asked for, and there. Throws PictureError.
DecodedPicture decode_webp(const std::string& bytes, bool with_alpha);

}  // namespace lumi::baker
