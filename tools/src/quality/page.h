// SPDX-License-Identifier: MIT
// The report as one HTML page that needs nothing but itself.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "image/picture.h"
#include "quality/report_data.h"

namespace lumi::quality
{

// Returns text as HTML shows it, with &, <, > and quotes escaped.
std::string escaped(std::string text);

// Writes a number with so many digits behind the point.
std::string number(double value, int places);

std::string cell(const std::string& html);

// Encodes by RFC 4648, with padding.
std::string base64(std::string_view bytes);

// An <img> that holds the picture itself.
std::string image_tag(const tools::Picture& picture, std::string_view alternative_text);

// A page begins with this, before the means.
struct PageLead {
    std::string title = "Quality", style, html;  // "… of model.obj"
    std::set<std::string> pictured;              // names of the fields whose pictures stand below; empty: all
};

std::string page_of(const ReportData& report, const PageLead& lead = {});

}  // namespace lumi::quality
