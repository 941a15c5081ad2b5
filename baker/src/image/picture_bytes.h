// SPDX-License-Identifier: MIT
// All readers of pictures share this: the bytes of a file, and limits before anything is decoded.
#pragma once

#include <string>

#include "lumi/baker/picture_file.h"

namespace lumi::baker
{

// The whole file. Refuses folders, devices, pipes and what is too large before it reads. Throws PictureError.
std::string picture_bytes(const std::filesystem::path& file);

// Throws PictureError unless the picture has pixels, and not too many of them.
void check_picture_size(int64_t width, int64_t height);

// Throws PictureError where `bytes` are fewer than any picture of this size can be packed into, so that a few bytes
// never claim much memory.
void check_picture_bytes(int64_t bytes, int64_t fewest);

// Throws PictureError that names the format of bytes that no reader takes.
[[noreturn]] void refuse_picture(const std::filesystem::path& file, const std::string& bytes);

bool is_png(const std::string& bytes);

// Any PNG. Checksums count: what is damaged or cut short is refused. Throws PictureError.
DecodedPicture decode_png(const std::string& bytes, bool with_alpha);

bool is_jpeg(const std::string& bytes);

}  // namespace lumi::baker
