// SPDX-License-Identifier: MIT
// The report as one HTML page that needs nothing but itself.
#pragma once

#include <string>

#include "quality/report_data.h"

namespace lumi::quality
{

std::string page_of(const ReportData& report);

}  // namespace lumi::quality
