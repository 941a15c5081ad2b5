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

// Throws PictureError that names the format of bytes that no reader takes.
[[noreturn]] void refuse_picture(const std::filesystem::path& file, const std::string& bytes);

bool is_jpeg(const std::string& bytes);
bool is_webp(const std::string& bytes);
// Alpha only where it is asked for, and there. Throws PictureError.
DecodedPicture decode_webp(const std::string& bytes, bool with_alpha);

}  // namespace lumi::baker
