// SPDX-License-Identifier: MIT
// A picture of what a field holds, for people who want to know where its bytes went.
#pragma once

#include "files/field_file.h"
#include "image/picture.h"

namespace lumi::tools
{

// Surface field: shows the texels, which are mean colours, of one patch beside the other, the highest first, and behind
// them those of see-through patches over a chequered ground. What a lone triangle does not use of its rectangle stays
// empty. Texels of small fields are several pixels wide.
//
// Chord field: shows, for at most kMostOrigins of its origins, evenly chosen from the north pole southwards, a map of
// all directions, about one pixel each: longitude to the right, the north pole above. Rays that miss the scene are
// dark.
inline constexpr uint32_t kMostOrigins = 256;
Picture picture_of(const FieldFile& file);

}  // namespace lumi::tools
