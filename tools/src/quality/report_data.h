// SPDX-License-Identifier: MIT
// Everything that a report shows.
#pragma once

#include <string>
#include <vector>

#include "quality/measured.h"

namespace lumi::quality
{

struct ReportData {
    std::string scene;
    ViewSet set = ViewSet::all;
    uint32_t reference_samples = 0;
    std::vector<HeldOutView> views;
    std::vector<Reference> references;
    std::vector<Measured> fields;    // as given
    std::vector<Measured> variants;  // cheaper modes of these
};

// Returns "31.2 (7)": the PSNR of the view of least PSNR, and which it is, from 1 on.
std::string worst_view_text(const Measured& m);

std::string text_of(const ReportData& report);
std::string json_of(const ReportData& report);

}  // namespace lumi::quality
