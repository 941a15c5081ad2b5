// SPDX-License-Identifier: MIT
#include "commands/device_figures.h"

#include <algorithm>

#include "../planner/speed.h"
#include "draw/draw_surface.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

std::vector<planner::PartRate> of_device(std::vector<planner::PartRate> rates, const Device& device)
{
    const auto is_other = [&](const planner::PartRate& rate) {
        return std::find(device.parts.begin(), device.parts.end(), rate.chip) == device.parts.end();
    };
    if (!device.parts.empty()) rates.erase(std::remove_if(rates.begin(), rates.end(), is_other), rates.end());
    return rates;
}

// Why a part cannot draw the field; empty: it can.
const char* obstacle_of(const planner::Chip& part, const planner::Ram& ram, const FieldFile& file)
{
    if (ram.all() > part.ram_bytes) return "too little RAM";
    return part.flash_bytes != 0 && file.size() > part.flash_bytes ? "too little flash" : "";
}

std::string rate_text(double rate)
{
    constexpr double kWhole = 10;
    return formatted(rate < 1 ? "%.1g" : rate < kWhole ? "%.1f" : "%.0f", rate);
}

std::string part_text(const planner::PartRate& rate, const planner::Ram& ram, const FieldFile& file)
{
    const std::string title = planner::marked_title(*rate.chip);
    if (const std::string obstacle = obstacle_of(*rate.chip, ram, file); !obstacle.empty())
        return title + " " + obstacle;
    return title + " " + rate_text(rate.mean) + (file.is_surface() ? " (" + rate_text(rate.worst) + ")" : "");
}

std::string head_text(const FieldFile& file, const host::ScreenSize& screen)
{
    std::string text =
        formatted("%d x %d pixels of 16 bits in stripes of %d rows; frames a second of one core, modelled",
                  screen.width_px, screen.height_px, screen.stripe_rows());
    if (file.is_surface())
        text += formatted(", mean (worst) of %d poses", planner::rated_poses(screen));
    else if (!fits_spans(file.field()))
        text += ", every pixel exact: spans refuse this field";
    return text + ":\n";
}

std::string foot_text(const FieldFile& file, const std::vector<ModeFigures>& modes, const host::ScreenSize& screen)
{
    std::string text = "  RAM is a view and a stripe. Besides, drawing takes less than " +
                       std::to_string(planner::stack_of(file)) + " bytes of stack on Cortex-M, and the field " +
                       std::to_string(file.size()) + " bytes of flash.\n";
    const double limit = planner::display_frames_per_second(1.0 * screen.width_px * screen.height_px);
    const auto is_limited = [&](const planner::PartRate& rate) { return rate.mean > 0.99 * limit; };
    const auto is_estimated = [](const planner::PartRate& rate) { return rate.chip->is_estimated; };
    bool has_limit = false, has_estimate = false;
    for (const ModeFigures& mode : modes) {
        has_limit |= std::any_of(mode.parts.begin(), mode.parts.end(), is_limited);
        has_estimate |= std::any_of(mode.parts.begin(), mode.parts.end(), is_estimated);
    }
    if (has_limit) text += formatted("  The display, SPI of 62.5 MHz, takes at most %.1f frames a second.\n", limit);
    if (has_estimate) text += "  * estimated: by instructions of a Cortex-M4, whose set is another\n";
    return text;
}

nlohmann::ordered_json json_of(const planner::Chip& part)
{
    return {{"ram_bytes", part.ram_bytes}, {"estimated", part.is_estimated}};
}

}  // namespace

std::vector<ModeFigures> device_figures(const FieldFile& file, const Device& device)
{
    std::vector<ModeFigures> figures;
    if (file.is_surface())
        for (const SurfaceMode mode : {SurfaceMode::one_sample, SurfaceMode::antialiased, SurfaceMode::two_by_two})
            figures.push_back({name_of(mode), planner::ram_of(file, mode, device.screen),
                               of_device(planner::surface_rates(file.surface(), mode, device.screen), device)});
    else
        for (const planner::ChordMode& mode : planner::chord_modes())
            figures.push_back(
                {mode.name, planner::ram_of(file, {}, device.screen),
                 of_device(planner::chord_rates(file.field(), mode.mode, planner::kRatedSpanPx, device.screen),
                           device)});
    return figures;
}

std::string device_text(const FieldFile& file, const Device& device)
{
    const std::vector<ModeFigures> modes = device_figures(file, device);
    std::string text = head_text(file, device.screen);
    for (const ModeFigures& mode : modes) {
        text += formatted("  %-12sRAM %u + %u bytes; ", mode.mode, mode.ram.view, mode.ram.stripe);
        for (size_t k = 0; k < mode.parts.size(); ++k)
            text += (k == 0 ? "" : ", ") + part_text(mode.parts[k], mode.ram, file);
        text += "\n";
    }
    return text + foot_text(file, modes, device.screen);
}

std::string pace_text(const FieldFile& file, const planner::Pace& pace, const host::ScreenSize& screen)
{
    std::vector<ModeFigures> modes = device_figures(file, {screen, {pace.chip}});
    if (file.is_surface()) std::reverse(modes.begin(), modes.end());
    const int cores = file.is_surface() ? pace.cores : 1;
    const auto rate_of = [&](const ModeFigures& mode) { return mode.parts.front().of(cores); };
    const auto found = std::find_if(modes.begin(), modes.end(),
                                    [&](const ModeFigures& mode) { return rate_of(mode) >= pace.frames_per_second; });
    const bool is_reached = found != modes.end();
    const ModeFigures& mode = is_reached ? *found : modes.back();
    if (const std::string obstacle = obstacle_of(*pace.chip, mode.ram, file); !obstacle.empty())
        return pace.chip->title + (": " + obstacle) + "\n";
    std::string text =
        formatted("%s%s: %s frames a second at %d x %d pixels (%s, %s), %s of RAM", pace.chip->title,
                  cores == 2 ? ", both cores" : "", rate_text(rate_of(mode)).c_str(), screen.width_px, screen.height_px,
                  mode.mode, pace.chip->is_estimated ? "estimated" : "modelled", byte_text(mode.ram.all()).c_str());
    if (!is_reached) text += formatted(", below %g frames a second", pace.frames_per_second);
    return text + (is_reached || !file.is_surface() ? "\n" : "; more --rows or fewer --triangles are faster\n");
}

nlohmann::ordered_json device_json(const FieldFile& file, const Device& device)
{
    const host::ScreenSize& screen = device.screen;
    nlohmann::ordered_json json = {
        {"screen", {{"width_px", screen.width_px}, {"height_px", screen.height_px}, {"rows", screen.stripe_rows()}}},
        {"stack_bytes", planner::stack_of(file)}};
    for (const ModeFigures& mode : device_figures(file, device)) {
        json["ram_bytes"][mode.mode] = {{"view", mode.ram.view}, {"stripe", mode.ram.stripe}};
        for (const planner::PartRate& part : mode.parts) {
            json["chips"][part.chip->key] = json_of(*part.chip);
            json["frames_per_second"][mode.mode][part.chip->key] = part.mean;
            json["worst_frames_per_second"][mode.mode][part.chip->key] = part.worst;
        }
    }
    return json;
}

}  // namespace lumi::tools
