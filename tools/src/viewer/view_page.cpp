// SPDX-License-Identifier: MIT
#include "viewer/view_page.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "quality/page.h"
#include "viewer/page_sources.h"

namespace lumi::tools
{

namespace
{

using Json = nlohmann::ordered_json;

Json json_of(const ShownMode& mode)
{
    Json rates = Json::object();
    for (const ShownRate& rate : mode.rates) rates[rate.chip] = {{"mean", rate.mean}, {"worst", rate.worst}};
    return {
        {"number", mode.number}, {"name", mode.name}, {"title", mode.title}, {"remark", mode.remark}, {"rates", rates}};
}

Json json_of(const ShownChip& chip)
{
    return {{"key", chip.key},
            {"title", chip.title},
            {"remark", chip.remark},
            {"mhz", chip.clock_mhz},
            {"ram", chip.ram_bytes}};
}

std::string colour_text(const Rgb8& c)
{
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", c.r, c.g, c.b);
    return text;
}

// The script reads this besides module and field. Angles and lengths are core's numbers.
Json data_of(const ViewPage& page)
{
    Json data = {{"title", page.title},
                 {"layout", page.layout},
                 {"firstMode", page.first_mode},
                 {"background", colour_text(page.background)},
                 {"home",
                  {{"azimuth", host::turns32_from_degrees(page.home.azimuth_deg)},
                   {"elevation", host::signed_turns32_from_degrees(page.home.elevation_deg)},
                   {"distance", host::q20_from_radii(page.home.distance)}}}};
    for (const ShownMode& mode : page.modes) data["modes"].push_back(json_of(mode));
    for (const ShownChip& chip : page.chips) data["chips"].push_back(json_of(chip));
    data["references"] = Json::array();
    for (const std::string& png : page.references) data["references"].push_back(quality::base64(png));
    return data;
}

// As the text of a <script>, which "</script" would end.
std::string script_text(const Json& data)
{
    std::string text;
    // Names need not be UTF-8; what is none becomes U+FFFD.
    for (const char c : data.dump(-1, ' ', false, Json::error_handler_t::replace))
        text += c == '<' ? "\\u003c" : std::string(1, c);
    return text;
}

struct Part {
    std::string mark, text;
};

// Every mark of the template in one pass, so that a part's own text is never searched.
std::string filled(const std::string& html, const std::vector<Part>& parts)
{
    std::string text;
    for (size_t at = 0; at < html.size();) {
        const Part* found = nullptr;
        for (const Part& part : parts)
            if (html.compare(at, part.mark.size(), part.mark) == 0) found = &part;
        if (found != nullptr) {
            text += found->text;
            at += found->mark.size();
        } else {
            text += html[at++];
        }
    }
    return text;
}

}  // namespace

std::string html_of(const ViewPage& page)
{
    return filled(kPageHtml, {{"{{title}}", quality::escaped(page.title)},
                              {"{{style}}", kPageCss},
                              {"{{data}}", script_text(data_of(page))},
                              {"{{module}}", quality::base64(page.module)},
                              {"{{field}}", quality::base64(page.field)},
                              {"{{script}}", kPageScript}});
}

}  // namespace lumi::tools
