// SPDX-License-Identifier: MIT
#include "quality/page.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "image/picture_file.h"
#include "metrics/metrics.h"
#include "terminal/text.h"

namespace lumi::quality
{

std::string escaped(std::string text)
{
    for (const auto& [sign, word] : {std::pair("&", "&amp;"), {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}})
        text = tools::replaced(std::move(text), sign, word);
    return text;
}

std::string number(double value, int places)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.*f", places, value);
    return text;
}

std::string cell(const std::string& html)
{
    return "<td>" + html + "</td>";
}

std::string base64(std::string_view bytes)
{
    constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        const size_t count = std::min<size_t>(3, bytes.size() - i);
        uint32_t group = 0;
        for (size_t k = 0; k < 3; ++k)
            group = group << 8 | (k < count ? static_cast<uint32_t>(static_cast<uint8_t>(bytes[i + k])) : 0u);
        for (size_t k = 0; k < 4; ++k) text += k <= count ? kDigits[group >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

std::string image_tag(const tools::Picture& picture, std::string_view alternative_text)
{
    return "<img loading=\"lazy\" width=\"" + std::to_string(picture.width_px) + "\" height=\"" +
           std::to_string(picture.height_px) + "\" alt=\"" + escaped(std::string(alternative_text)) +
           "\" src=\"data:image/png;base64," + base64(tools::png_bytes(picture)) + "\">";
}

namespace
{

// This is how the report page looks: one column on a phone, pictures side by side where there is room.
constexpr char kPageStyle[] = R"(
:root { color-scheme: light dark; --line: #8884; --soft: #8882; }
body { font: 16px/1.45 system-ui, sans-serif; margin: 0 auto; padding: 0.8rem; max-width: 1560px; }
h1 { font-size: 1.35rem; margin: 0.4rem 0; overflow-wrap: anywhere; }
h2 { font-size: 1.1rem; margin: 1.6rem 0 0.4rem; }
h3 { font-size: 0.95rem; margin: 1rem 0 0.3rem; }
p { margin: 0.4rem 0; max-width: 46rem; }
.wide { overflow-x: auto; }
table { border-collapse: separate; border-spacing: 0; font-variant-numeric: tabular-nums; font-size: 0.88rem; }
th, td { padding: 0.25rem 0.6rem; border-bottom: 1px solid var(--line); text-align: right; white-space: nowrap; }
th:first-child, td:first-child { text-align: left; position: sticky; left: 0; background: Canvas; }
td:first-child { white-space: normal; overflow-wrap: anywhere; min-width: 7rem; max-width: 16rem; }
.views { display: grid; grid-template-columns: repeat(auto-fit, minmax(160px, 1fr)); gap: 0.5rem; align-items: start; }
.views .pair { grid-column: span 2; display: grid; grid-template-columns: 1fr 1fr; column-gap: 0.5rem; }
.pair figcaption { grid-column: 1 / -1; }
@media (max-width: 500px) {
  table { font-size: 0.8rem; }
  th, td { padding: 0.25rem 0.3rem; }
  .views { grid-template-columns: repeat(2, 1fr); }
  .views figure:first-child { grid-column: 1 / -1; display: grid; grid-template-columns: 1fr 1fr; column-gap: 0.5rem;
    align-items: center; }
}
figure { margin: 0; background: var(--soft); border-radius: 6px; overflow: hidden; }
figure img { display: block; width: 100%; height: auto; }
figcaption { padding: 0.3rem 0.5rem 0.45rem; font-size: 0.8rem; overflow-wrap: anywhere; }
.bar { display: flex; height: 1.1rem; border-radius: 4px; overflow: hidden; }
.bar span { min-width: 1px; }
.key { display: flex; flex-wrap: wrap; gap: 0.2rem 0.9rem; font-size: 0.82rem; margin-top: 0.25rem; }
.key i { display: inline-block; width: 0.75em; height: 0.75em; border-radius: 2px; margin-right: 0.35em; }
)";

std::string file_name(const std::string& path)
{
    return std::filesystem::path(path).filename().string();
}

std::string flash_text(const Measured& m)
{
    return m.flash_bytes != 0 ? tools::byte_text(m.flash_bytes) : "";
}

std::string mean_row(const Measured& m)
{
    const Figures& f = m.mean;
    return "<tr>" + cell(escaped(file_name(m.name))) + cell(m.layout) + cell(flash_text(m)) +
           cell(number(f.psnr_db, 2)) + cell(number(f.ssim, 4)) + cell(number(f.cw_ssim, 4)) + cell(number(f.flip, 4)) +
           cell(number(f.mask_psnr_db, 2)) + cell(number(f.mask_ssim, 4)) + cell(worst_view_text(m)) + "</tr>\n";
}

std::string mean_table(const ReportData& report)
{
    std::string html =
        "<div class=\"wide\"><table><tr><th>what<th>layout<th>flash<th>PSNR dB<th>SSIM<th>CW-SSIM<th>FLIP"
        "<th>mask PSNR<th>mask SSIM<th>worst view</tr>\n";
    for (const Measured& m : report.fields) html += mean_row(m);
    for (const Measured& m : report.variants) html += mean_row(m);
    return html + "</table></div>\n";
}

// Where a field's bytes go.
std::string section_bar(const Measured& field)
{
    constexpr std::array<const char*, 7> kColours = {"#4477aa", "#ee6677", "#228833", "#ccbb44",
                                                     "#66ccee", "#aa3377", "#777777"};
    std::string bar, key;
    for (size_t i = 0; i < field.sections.size(); ++i) {
        const tools::Section& section = field.sections[i];
        const std::string colour = kColours[i % kColours.size()];
        bar += "<span style=\"flex:" + std::to_string(section.bytes) + ";background:" + colour + "\"></span>";
        key += "<span><i style=\"background:" + colour + "\"></i>" + escaped(tools::title_of(section.type)) + " " +
               tools::byte_text(section.bytes) + "</span>";
    }
    return "<h3>" + escaped(file_name(field.name)) + ", " + flash_text(field) + "</h3><div class=\"bar\">" + bar +
           "</div><div class=\"key\">" + key + "</div>\n";
}

std::string figure(const tools::Picture& picture, const std::string& caption)
{
    return "<figure>" + image_tag(picture, caption) + "<figcaption>" + escaped(caption) + "</figcaption></figure>\n";
}

std::string figures_text(const Figures& f)
{
    return number(f.psnr_db, 2) + " dB, SSIM " + number(f.ssim, 4) + ", FLIP " + number(f.flip, 4) + "; mask " +
           number(f.mask_psnr_db, 2) + " dB, " + number(f.mask_ssim, 4);
}

// A field's picture beside its error, with one caption.
std::string pair(const Measured& field, size_t v, const Reference& reference)
{
    const std::string name = file_name(field.name);
    return "<figure class=\"pair\">" + image_tag(field.pictures[v], name) +
           image_tag(tools::error_picture(field.pictures[v], reference.picture), "error of " + name) +
           "<figcaption><b>" + escaped(name) + "</b>: " + figures_text(field.figures[v]) + "</figcaption></figure>\n";
}

std::string view_part(const ReportData& report, const std::set<std::string>& pictured, size_t v)
{
    const Reference& reference = report.references[v];
    std::string html = "<h3>View " + std::to_string(v + 1) + ": " + escaped(text_of(report.views[v])) +
                       "</h3>\n<div class=\"views\">\n" + figure(reference.picture, "reference");
    for (const Measured& field : report.fields)
        if (pictured.empty() || pictured.count(field.name) != 0) html += pair(field, v, reference);
    return html + "</div>\n";
}

std::string introduction(const ReportData& report)
{
    return "<p>" + std::to_string(report.views.size()) + " views that no bake aimed at (" + name_of(report.set) +
           "), 2.5 to 4 radii away, the sphere filling the frame, on black; references with " +
           std::to_string(report.reference_samples) +
           " light paths a pixel. Means over the views. Fields are drawn as a microcontroller draws them. FLIP is an "
           "error, 0 is best; the mask is where the reference is covered. Beside the worst view stands its "
           "number.</p>\n";
}

}  // namespace

std::string page_of(const ReportData& report, const PageLead& lead)
{
    const std::string title = lead.title + " of " + escaped(file_name(report.scene));
    std::string html =
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<meta name=\"viewport\" "
        "content=\"width=device-width, initial-scale=1\">\n<title>" +
        title + "</title>\n<style>" + kPageStyle + lead.style + "</style></head><body>\n<h1>" + title + "</h1>\n" +
        lead.html + introduction(report) + mean_table(report) + "<h2>Where the bytes go</h2>\n";
    for (const Measured& field : report.fields) html += section_bar(field);
    html += std::string("<h2>Views</h2>\n<p>The picture of each field") +
            (lead.pictured.empty() ? "" : " that is on a front") +
            ", and beside it its error, 4 times as bright.</p>\n";
    for (size_t v = 0; v < report.views.size(); ++v) html += view_part(report, lead.pictured, v);
    return html + "</body></html>\n";
}

}  // namespace lumi::quality
