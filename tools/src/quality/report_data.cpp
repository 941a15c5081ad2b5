// SPDX-License-Identifier: MIT
#include "quality/report_data.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "terminal/text.h"

namespace lumi::quality
{

namespace
{

using Json = nlohmann::ordered_json;

std::string row_text(const Measured& m)
{
    char text[320];
    const std::string flash = m.flash_bytes != 0 ? tools::byte_text(m.flash_bytes) : "-";
    const Figures& f = m.mean;
    std::snprintf(text, sizeof text, "%-28s %-12s %9s %7.2f %7.4f %8.4f %7.4f %10.2f %10.4f %11s\n", m.name.c_str(),
                  m.layout.c_str(), flash.c_str(), f.psnr_db, f.ssim, f.cw_ssim, f.flip, f.mask_psnr_db, f.mask_ssim,
                  worst_view_text(m).c_str());
    return text;
}

// Four digits after the point are more than any figure's noise.
double rounded(double value)
{
    constexpr double kPlaces = 1e4;
    return std::round(value * kPlaces) / kPlaces;
}

Json json_of(const Figures& f)
{
    return {{"psnr_db", rounded(f.psnr_db)},           {"ssim", rounded(f.ssim)},
            {"cw_ssim", rounded(f.cw_ssim)},           {"flip", rounded(f.flip)},
            {"mask_psnr_db", rounded(f.mask_psnr_db)}, {"mask_ssim", rounded(f.mask_ssim)}};
}

Json json_of(const HeldOutView& view)
{
    return {{"azimuth_deg", rounded(view.azimuth_deg)},
            {"elevation_deg", rounded(view.elevation_deg)},
            {"distance", rounded(view.distance)}};
}

Json json_of(const Measured& m)
{
    Json json = {{"name", m.name}, {"layout", m.layout}, {"flash_bytes", m.flash_bytes}};
    json.update(json_of(m.mean));
    for (const tools::Section& section : m.sections) json["sections"][section.type] = section.bytes;
    json["draw_ms"] = rounded(m.draw_ms);
    if (m.triangles != 0) json["triangles"] = m.triangles;
    if (!m.figures.empty()) {
        const size_t v = worst_view(m);
        json["worst_view"] = {{"view", v}, {"psnr_db", rounded(m.figures[v].psnr_db)}};
    }
    json["views"] = Json::array();
    for (const Figures& figures : m.figures) json["views"].push_back(json_of(figures));
    return json;
}

Json json_of(const std::vector<Measured>& all)
{
    Json json = Json::array();
    for (const Measured& m : all) json.push_back(json_of(m));
    return json;
}

}  // namespace

std::string worst_view_text(const Measured& m)
{
    if (m.figures.empty()) return "";
    const size_t v = worst_view(m);
    char text[40];
    std::snprintf(text, sizeof text, "%.1f (%zu)", m.figures[v].psnr_db, v + 1);
    return text;
}

std::string text_of(const ReportData& report)
{
    std::string text =
        report.scene + ": means over " + std::to_string(report.views.size()) + " views (" + name_of(report.set) +
        ") against " + std::to_string(report.reference_samples) +
        " samples a pixel\n"
        "field                        layout           flash  PSNR dB   SSIM  CW-SSIM    FLIP  mask PSNR  "
        "mask SSIM  worst view\n";
    for (const Measured& field : report.fields) text += row_text(field);
    for (const Measured& variant : report.variants) text += row_text(variant);
    return text;
}

std::string json_of(const ReportData& report)
{
    Json json = {{"scene", report.scene},
                 {"view_set", name_of(report.set)},
                 {"reference_samples", report.reference_samples},
                 {"views", Json::array()}};
    for (const HeldOutView& view : report.views) json["views"].push_back(json_of(view));
    json["fields"] = json_of(report.fields);
    json["variants"] = json_of(report.variants);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lumi::quality
