// SPDX-License-Identifier: MIT
// Outputs of one stem share a header of `lumi embed`: product.c and product.bin both have product.h.
// The header says which field it describes and how; two outputs may share it only if they would write the same there.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "files/embed.h"

namespace lumi::tools
{

// "Field product.lumi, symbol product, flashed at 0x10100000. For .bin .uf2", a line of the header's first comment.
// `field`: the file's name without its folder.
std::string embed_purpose(const std::string& field, const std::string& symbol, EmbedKind kind,
                          std::optional<uint32_t> address);

// Call before `header`, the one beside `output`, is written for `purpose`. Throws Failure if a file is there that
// `lumi embed` did not write, or that serves another output, still there, and would no longer fit it.
void require_same_purpose(const std::string& header, const std::string& output, const std::string& purpose);

}  // namespace lumi::tools
