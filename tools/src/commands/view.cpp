// SPDX-License-Identifier: MIT
// lumi view: a page in which people turn a field.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "commands/camera_options.h"
#include "commands/commands.h"
#include "commands/device_figures.h"
#include "draw/draw_surface.h"
#include "draw/views.h"
#include "files/field_file.h"
#include "files/field_report.h"
#include "files/output_file.h"
#include "lumi/chord/render_spans.h"
#include "lumi/surface/states.h"
#include "program/option_checks.h"
#include "quality/page.h"
#include "terminal/failure.h"
#include "terminal/progress_printer.h"
#include "terminal/text.h"
#include "viewer/modules.h"
#include "viewer/page_sources.h"
#include "viewer/turntable.h"

namespace lumi::tools
{

namespace
{

struct PageOptions {
    std::string field, output, title, reference;
    ViewOptions views;  // orbit and background
};

using Json = nlohmann::ordered_json;

// A mode as pages show it. `number` is the module's: platform/wasm/surface_drawing.cpp and chord_drawing.cpp.
Json mode_of(int number, const char* name, const char* title, const char* remark)
{
    return {{"number", number}, {"name", name}, {"title", title}, {"remark", remark}, {"rates", Json::object()}};
}

Json surface_modes()
{
    return {mode_of(0, name_of(SurfaceMode::one_sample), "One sample", "One sample a pixel, the fastest"),
            mode_of(1, name_of(SurfaceMode::antialiased), "Antialiased", "One sample a pixel, smooth outlines"),
            mode_of(2, name_of(SurfaceMode::two_by_two), "2×2 samples", "Four samples a pixel, the finest")};
}

Json chord_modes(const Field& field)
{
    if (!fits_spans(field))
        return Json::array({mode_of(1, "linear", "Linear", "3×3 texels a pixel; the field is too small for spans")});
    return {mode_of(2, "nearest", "Nearest", "1 texel a pixel, the fastest"),
            mode_of(1, "linear", "Linear", "3×3 texels a pixel"),
            mode_of(0, "paper", "Paper", "5×5 texels a pixel, the kernel of the paper; every pixel exact")};
}

// From the coarsest to the finest, each with its rates on 240 × 240 pixels, where it is modelled.
Json modes_of(const FieldFile& file)
{
    Json modes = file.is_surface() ? surface_modes() : chord_modes(file.field());
    for (const ModeFigures& figures : device_figures(file))
        for (Json& mode : modes)
            if (mode["name"] == figures.mode)
                for (const planner::PartRate& part : figures.parts)
                    mode["rates"][part.chip->key] = {{"mean", part.mean}, {"worst", part.worst}};
    return modes;
}

Json shown_chips()
{
    Json chips = Json::array();
    for (const planner::Chip& chip : planner::kChipList)
        chips.push_back({{"key", chip.key},
                         {"title", marked_title(chip)},
                         {"remark", chip.remark},
                         {"mhz", chip.clock_mhz},
                         {"ram", chip.ram_bytes}});
    return chips;
}

// Degrees, or radii of one that slides.
Json moving_parts(const FieldFile& file)
{
    Json parts = Json::array();
    for (uint32_t k = 0; file.is_surface() && k < mover_count(file.surface()); ++k) {
        const PartMotion motion = part_motion(file.surface(), k);
        const PartName name = part_name(file.surface(), k);
        const double one = motion.slides ? kOneQ20 : 0x1p32 / 360;
        const bool is_free = !motion.slides && motion.span == UINT32_MAX;
        const double from = is_free ? 0 : motion.from / one, span = is_free ? 360 : motion.span / one;
        parts.push_back({{"name", std::string(name.text, name.bytes)},
                         {"slides", motion.slides},
                         {"from", from},
                         {"to", from + span}});
    }
    return parts;
}

Json light_states(const FieldFile& file)
{
    Json states = Json::array();
    for (uint32_t k = 0; file.is_surface() && k < file.surface().state_count; ++k) {
        const StateWeight w = default_weight(file.surface(), k);
        const auto share = [](uint16_t q12) { return static_cast<double>(q12) / kFullWeight; };
        states.push_back({{"name", name_of_state(file.surface(), k)},
                          {"tint", is_tint(file.surface(), k)},
                          {"weight", {share(w.r_q12), share(w.g_q12), share(w.b_q12)}}});
    }
    return states;
}

int first_mode_of(const Json& modes)
{
    for (size_t k = 0; k < modes.size(); ++k)
        if (modes[k]["name"] == "antialiased" || modes[k]["name"] == "linear") return static_cast<int>(k);
    return 0;
}

// "gradient", or a colour as browsers write it.
std::string background_text(const PageOptions& options)
{
    const Background background = options.views.background;
    if (background.kind == Background::Kind::gradient) return "gradient";
    const Rgb8 c = background.colour;
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", c.r, c.g, c.b);
    return text;
}

std::string stem_of(const PageOptions& options)
{
    return std::filesystem::path(options.field).stem().string();
}

std::string title_of(const PageOptions& options)
{
    return options.title.empty() ? stem_of(options) : options.title;
}

// The script reads this besides module and field. Angles and lengths are core's numbers; pictures are PNG files of a
// turntable that begins at home.
Json data_of(const PageOptions& options, const FieldFile& file)
{
    const host::Orbit& home = options.views.orbit;
    const Json modes = modes_of(file);
    Json data = {{"title", title_of(options)},
                 {"layout", file.is_surface() ? "surface" : "chord"},
                 {"firstMode", first_mode_of(modes)},
                 {"background", background_text(options)},
                 {"home",
                  {{"azimuth", host::turns32_from_degrees(home.azimuth_deg)},
                   {"elevation", host::signed_turns32_from_degrees(home.elevation_deg)},
                   {"distance", host::q20_from_radii(home.distance)}}},
                 {"modes", modes},
                 {"chips", shown_chips()},
                 {"parts", moving_parts(file)},
                 {"states", light_states(file)},
                 {"references", Json::array()}};
    if (!options.reference.empty())
        for (const std::string& png : read_turntable(options.reference))
            data["references"].push_back(quality::base64(png));
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

std::string_view module_for(const FieldFile& file)
{
    const std::string_view module = file.is_surface() ? surface_module() : chord_module();
    if (module.empty())
        throw Failure("view", "this lumi was built without clang and lld, which make the code that a page runs",
                      "install them (Debian: apt-get install clang lld), then configure and build lumi again");
    return module;
}

std::string page_of(const PageOptions& options, const FieldFile& file)
{
    const std::string_view bytes(reinterpret_cast<const char*>(file.bytes()), file.size());
    return filled(kPageHtml, {{"{{title}}", quality::escaped(title_of(options))},
                              {"{{style}}", kPageCss},
                              {"{{data}}", script_text(data_of(options, file))},
                              {"{{module}}", quality::base64(module_for(file))},
                              {"{{field}}", quality::base64(bytes)},
                              {"{{script}}", kPageScript}});
}

void run(const PageOptions& options)
{
    if (options.views.background.kind == Background::Kind::none)
        throw UsageError("--background of a page takes gradient, black or a colour: a display shows no alpha");
    announce_outputs({options.output});
    std::optional<Waiting> waiting(std::in_place, "making the page");
    const FieldFile file(options.field);
    file.require_intact();
    const std::string html = page_of(options, file);
    waiting.reset();
    std::string path = options.output;
    if (path.empty())
        path = show_in_browser(stem_of(options), html);
    else
        write_output(path, html);
    if (!std::filesystem::is_regular_file(path)) return;
    print(stdout, "%s: %s, of which the field has %s\n", path.c_str(), byte_text(html.size()).c_str(),
          byte_text(file.size()).c_str());
}

}  // namespace

void add_view(CLI::App& lumi)
{
    auto options = std::make_shared<PageOptions>();
    CLI::App* command = lumi.add_subcommand("view", "Turn a field in a browser, drawn by the code that firmware links");
    command->add_option("FIELD", options->field, "A field file")->required();
    command
        ->add_option("-o,--output", options->output,
                     "Page to write: one file that needs no network [a temporary one, opened by xdg-open]")
        ->type_name("OUT.html")
        ->check(wrong_page_name);
    command->add_option("--title", options->title, "What the page calls the object [the field's name]")
        ->type_name("TEXT");
    add_start_options(*command, options->views);
    command
        ->add_option("--reference", options->reference,
                     "Folder of a path-traced turntable to compare with: lumi reference SCENE -o DIR/view.png "
                     "--turntable 36, with the same --orbit and --background")
        ->type_name("DIR");
    command->footer("Example:\n  lumi view product.lumi -o product.html");
    command->callback([options, command] {
        if (command->count("--background") == 0 && options->reference.empty())
            options->views.background.kind = Background::Kind::gradient;
        run(*options);
    });
}

}  // namespace lumi::tools
