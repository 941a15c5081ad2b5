// SPDX-License-Identifier: MIT
// Packs guided fields into files.
#pragma once

#include "guided_parts.h"

namespace lumi::baker
{

// The whole file. Throws BakeError if it would not fit into the format: 4 GiB, or 2^16 texels in an origin's chart.
std::vector<uint8_t> guided_file(const GuidedParts& parts);

}  // namespace lumi::baker
