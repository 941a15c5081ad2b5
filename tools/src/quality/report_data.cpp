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
    char text[256];
    const std::string flash = m.flash_bytes != 0 ? tools::byte_text(m.flash_bytes) : "-";
    const Figures& f = m.mean;
    std::snprintf(text, sizeof text, "%-28s %-8s %9s %7.2f %7.4f %8.4f %7.4f %10.2f %10.4f\n", m.name.c_str(),
                  m.layout.c_str(), flash.c_str(), f.psnr_db, f.ssim, f.cw_ssim, f.flip, f.mask_psnr_db, f.mask_ssim);
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

Json json_of(const Measured& m)
{
    Json json = {{"name", m.name}, {"layout", m.layout}, {"flash_bytes", m.flash_bytes}};
    json.update(json_of(m.mean));
    for (const tools::Section& section : m.sections) json["sections"][section.type] = section.bytes;
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

Json json_of(const HeldOutView& view)
{
    return {{"azimuth_deg", rounded(view.azimuth_deg)},
            {"elevation_deg", rounded(view.elevation_deg)},
            {"distance", rounded(view.distance)}};
}

Json json_of(const ModeCost& cost)
{
    Json json = {{"layout", cost.layout},
                 {"core", cost.core},
                 {"mode", cost.mode},
                 {"instructions_per_pixel", cost.instructions_per_pixel}};
    if (cost.layout != "chord") return json;
    json["texel"] = cost.texel;
    json["span"] = cost.span;
    return json;
}

}  // namespace

std::string text_of(const ReportData& report)
{
    std::string text = report.scene + ": means over " + std::to_string(report.views.size()) + " views (" +
                       name_of(report.set) + ") against " + std::to_string(report.truth_samples) +
                       " samples a pixel\n"
                       "field                        layout       flash  PSNR dB   SSIM  CW-SSIM    FLIP  mask PSNR  "
                       "mask SSIM\n";
    for (const Measured& field : report.fields) text += row_text(field);
    for (const Measured& baseline : report.baselines) text += row_text(baseline);
    if (report.one_ray) text += row_text(*report.one_ray);
    return text;
}

std::string json_of(const ReportData& report)
{
    Json json = {{"scene", report.scene},
                 {"view_set", name_of(report.set)},
                 {"reference_samples", report.truth_samples},
                 {"views", Json::array()}};
    for (const HeldOutView& view : report.views) json["views"].push_back(json_of(view));
    json["fields"] = json_of(report.fields);
    json["baselines"] = json_of(report.baselines);
    if (report.one_ray) json["one_ray"] = json_of(*report.one_ray);
    json["costs"] = Json::array();
    for (const ModeCost& cost : report.costs) json["costs"].push_back(json_of(cost));
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lumi::quality
