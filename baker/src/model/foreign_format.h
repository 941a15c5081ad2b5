// SPDX-License-Identifier: MIT
// Names formats that are not read, by what a file holds or by the end of its name, and the way out.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace lumi::baker
{

// How many of a file's first bytes tell its format.
inline constexpr size_t kHeadBytesOfModel = size_t{1} << 16;

// The ending has small letters and the dot.
std::string extension_of(const std::filesystem::path& file);

// `head` are the first kHeadBytesOfModel bytes of `file`, or all of it. Throws SceneError if that is a format which we
// know and do not read. What the file holds counts before its name.
void refuse_foreign_model(const std::filesystem::path& file, std::string_view head);

}  // namespace lumi::baker
