// SPDX-License-Identifier: MIT
// From all charts of a guided field to its file.
#pragma once

#include "guided/traced_chart.h"
#include "lumi/baker/guided.h"
#include "util/job.h"

namespace lumi::baker
{

// `charts` of all used origins, in order; `settings` as checked() returns them. The bytes do not depend on the job's
// threads. Throws BakeError if the field would not fit into the format, Cancelled.
std::vector<uint8_t> assembled_field(std::vector<FieldSection> base, std::vector<TracedChart> charts,
                                     const GuidedSettings& settings, Job& job);

}  // namespace lumi::baker
