// SPDX-License-Identifier: MIT
// The report as one HTML page that needs nothing but itself.
#pragma once

#include <set>
#include <string>

#include "quality/report_data.h"

namespace lumi::quality
{

// A page begins with this, before the means.
struct PageLead {
    std::string title = "Quality", style, html;  // "… of model.obj"
    std::set<std::string> pictured;              // names of the fields whose pictures stand below; empty: all
};

std::string page_of(const ReportData& report, const PageLead& lead = {});

}  // namespace lumi::quality
