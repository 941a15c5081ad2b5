// SPDX-License-Identifier: MIT
// The outside of glTF files, checked before a parser sees them: the chunks of a GLB, and how much its JSON claims.
//
// Why before: tinygltf 2.7 trusts the length of a GLB's second chunk by 8 bytes too much, calls itself for each bracket
// of an extension, and takes some 600 bytes of memory for an object of two.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace lumi::baker
{

bool is_glb(std::string_view bytes);

// `bytes` are all of `file`. Throws SceneError where it is no glTF 2.0, cut short, or claims more than it can hold.
void check_gltf_container(const std::filesystem::path& file, const std::string& bytes);

// The file as tinygltf reads it: with three bytes in each buffer that EXT_meshopt_compression leaves empty, and without
// the indices that Draco brings anew.
std::string plain_for_parser(const std::string& bytes);

}  // namespace lumi::baker
