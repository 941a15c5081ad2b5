// SPDX-License-Identifier: MIT
#include "planner/plan.h"

#include <cstdio>

#include "files/field_file.h"

namespace lumi::planner
{

namespace
{

std::string number(float value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", static_cast<double>(value));
    return text;
}

const char* texel_word(format::GuidedTexel texel)
{
    return texel == format::GuidedTexel::none     ? "none"
           : texel == format::GuidedTexel::index4 ? "4"
           : texel == format::GuidedTexel::vq8    ? "vq8"
                                                  : "8";
}

const char* mean_word(format::MeanFormat format)
{
    return format == format::MeanFormat::rgb565 ? "rgb565" : "palette8";
}

std::string cap_text(uint32_t used, uint32_t all)
{
    return used == 0 || used == all ? "" : " (uppermost " + std::to_string(used) + ")";
}

std::string texel_text(const baker::GuidedSettings& s)
{
    if (s.texel == format::GuidedTexel::none) return ", no texels";
    const char* texels = s.texel == format::GuidedTexel::vq8 ? " texels" : "-bit texels";
    return ", chart " + std::to_string(s.chart_size) + ", " + texel_word(s.texel) + texels;
}

std::string mean_text(const baker::GuidedSettings& s)
{
    if (s.mean_resolution == 0) return ", no mean";
    return ", mean " + std::to_string(s.mean_resolution) + " " + mean_word(s.mean_format);
}

std::string guided_text(const Plan& plan)
{
    const baker::GuidedSettings& s = plan.guided;
    const std::string text =
        std::to_string(s.origins) + " origins" + cap_text(s.used_origins, s.origins) + texel_text(s);
    if (plan.layout == Layout::focus) return text + ", focus radius " + number(s.focus_radius);
    const bool occlusion = s.occlusion && s.texel != format::GuidedTexel::none;
    return text + ", " + std::to_string(s.proxy_triangles) + " triangles" + mean_text(s) +
           (occlusion ? ", occlusion" : ", no occlusion");
}

std::string chord_text(const baker::BakeSettings& s)
{
    return std::to_string(s.origins) + " origins" + cap_text(s.used_origins, s.origins) + ", " +
           std::to_string(s.directions) + " directions, " + tools::name_of(s.texel);
}

std::string cap_option(uint32_t used, uint32_t all)
{
    return used == 0 || used == all ? "" : " --cap " + std::to_string(used);
}

std::string guided_options(const Plan& plan)
{
    const baker::GuidedSettings& s = plan.guided;
    std::string text = " --origins " + std::to_string(s.origins) + cap_option(s.used_origins, s.origins) + " --chart " +
                       std::to_string(s.chart_size) + " --texels " + texel_word(s.texel);
    if (plan.layout == Layout::focus) return text + " --focus-radius " + number(s.focus_radius);
    text += " --proxy-triangles " + std::to_string(s.proxy_triangles) + " --mean-resolution " +
            std::to_string(s.mean_resolution);
    if (s.mean_resolution != 0) text += std::string(" --mean-format ") + mean_word(s.mean_format);
    return text + (s.occlusion ? "" : " --no-occlusion");
}

}  // namespace

const char* name_of(Layout layout)
{
    switch (layout) {
        case Layout::guided:
            return "guided";
        case Layout::focus:
            return "focus";
        case Layout::chord:
            return "chord";
    }
    return "unknown";
}

std::string text_of(const Plan& plan)
{
    const std::string rest = plan.layout == Layout::chord ? chord_text(plan.chord) : guided_text(plan);
    return std::string(name_of(plan.layout)) + ", " + rest;
}

std::string options_of(const Plan& plan)
{
    const std::string layout = std::string("--layout ") + name_of(plan.layout);
    if (plan.layout != Layout::chord) return layout + guided_options(plan);
    const baker::BakeSettings& s = plan.chord;
    return layout + " --origins " + std::to_string(s.origins) + cap_option(s.used_origins, s.origins) +
           " --directions " + std::to_string(s.directions) + " --texel " + tools::name_of(s.texel);
}

}  // namespace lumi::planner
