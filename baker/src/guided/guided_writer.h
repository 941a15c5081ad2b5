// SPDX-License-Identifier: MIT
// Packs guided fields into files.
#pragma once

#include "guided/guided_parts.h"

namespace lumi::baker
{

struct FieldSection {
    uint32_t type;
    std::vector<uint8_t> bytes;
};

// Those that no chart enters, and those of the charts. Throws BakeError for more than 2^16 texels in a chart.
std::vector<FieldSection> base_sections(const GuidedParts& parts);
std::vector<FieldSection> chart_sections(const GuidedParts& parts);

// The whole file. Throws BakeError if it would not fit into the format: 4 GiB, or 2^16 texels in an origin's chart.
std::vector<uint8_t> guided_file(const std::vector<FieldSection>& sections);
std::vector<uint8_t> guided_file(const GuidedParts& parts);

}  // namespace lumi::baker
