// SPDX-License-Identifier: MIT
// lumi view: a page in which people turn a field.
#include <cstdio>
#include <filesystem>
#include <memory>

#include "commands/camera_options.h"
#include "commands/commands.h"
#include "commands/device_figures.h"
#include "draw/draw_surface.h"
#include "files/field_file.h"
#include "files/output_file.h"
#include "lumi/chord/render_spans.h"
#include "terminal/failure.h"
#include "terminal/text.h"
#include "viewer/modules.h"
#include "viewer/turntable.h"
#include "viewer/view_page.h"

namespace lumi::tools
{

namespace
{

struct PageOptions {
    std::string field, output, title, reference;
    ViewOptions views;  // orbit and background
};

// The modules' numbers: platform/wasm/surface_drawing.cpp and chord_drawing.cpp.
std::vector<ShownMode> surface_modes()
{
    return {{0, name_of(SurfaceMode::one_sample), "One sample", "One sample a pixel, the fastest", {}},
            {1, name_of(SurfaceMode::antialiased), "Antialiased", "One sample a pixel, smooth outlines", {}},
            {2, name_of(SurfaceMode::two_by_two), "2×2 samples", "Four samples a pixel, the finest", {}}};
}

std::vector<ShownMode> chord_modes(const Field& field)
{
    if (!fits_spans(field))
        return {{1, "linear", "Linear", "3×3 texels a pixel; the field is too small for spans", {}}};
    return {{2, "nearest", "Nearest", "1 texel a pixel, the fastest", {}},
            {1, "linear", "Linear", "3×3 texels a pixel", {}},
            {0, "paper", "Paper", "5×5 texels a pixel, the kernel of the paper; every pixel exact", {}}};
}

std::vector<ShownMode> modes_of(const FieldFile& file)
{
    std::vector<ShownMode> modes = file.is_surface() ? surface_modes() : chord_modes(file.field());
    const std::vector<ModeFigures> all_figures = device_figures(file);
    for (ShownMode& mode : modes)
        for (const ModeFigures& figures : all_figures)
            if (figures.mode == mode.name)
                for (const planner::PartRate& part : figures.parts)
                    mode.rates.push_back({part.chip->key, part.mean, part.worst});
    return modes;
}

std::vector<ShownChip> shown_chips()
{
    std::vector<ShownChip> chips;
    for (const planner::Chip& chip : planner::kChipList)
        chips.push_back({chip.key, marked_title(chip), chip.remark, chip.clock_mhz, chip.ram_bytes});
    return chips;
}

int first_mode_of(const std::vector<ShownMode>& modes)
{
    for (size_t k = 0; k < modes.size(); ++k)
        if (modes[k].name == "antialiased" || modes[k].name == "linear") return static_cast<int>(k);
    return 0;
}

std::string_view module_for(const FieldFile& file)
{
    const std::string_view module = file.is_surface() ? surface_module() : chord_module();
    if (module.empty())
        throw Failure("view", "this lumi was built without clang and lld, which make the code that a page runs",
                      "install them (Debian: apt-get install clang lld), then configure and build lumi again");
    return module;
}

std::string stem_of(const PageOptions& options)
{
    return std::filesystem::path(options.field).stem().string();
}

std::string page_of(const PageOptions& options, const FieldFile& file)
{
    ViewPage page;
    page.title = options.title.empty() ? stem_of(options) : options.title;
    page.layout = file.is_surface() ? "surface" : "chord";
    page.module = module_for(file);
    page.field = {reinterpret_cast<const char*>(file.bytes()), file.size()};
    page.modes = modes_of(file);
    page.first_mode = first_mode_of(page.modes);
    page.chips = shown_chips();
    page.home = options.views.orbit;
    page.background = options.views.background;
    if (!options.reference.empty()) page.references = read_turntable(options.reference);
    return html_of(page);
}

// The limits of the page's eye: platform/wasm/viewer.cpp.
void require_in_reach(const host::Orbit& orbit)
{
    constexpr double kNearest = 1.25, kFarthest = 8;
    if (orbit.distance < kNearest || orbit.distance > kFarthest)
        throw UsageError("--orbit of a page takes a distance of 1.25 to 8 radii");
}

void run(const PageOptions& options)
{
    require_in_reach(options.views.orbit);
    announce_outputs({options.output});
    const FieldFile file(options.field);
    file.require_intact();
    const std::string html = page_of(options, file);
    std::string path = options.output;
    if (path.empty())
        path = show_in_browser(stem_of(options), html);
    else
        write_output(path, html);
    if (!std::filesystem::is_regular_file(path)) return;
    std::printf("%s: %s, of which the field has %s\n", path.c_str(), byte_text(html.size()).c_str(),
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
        ->type_name("OUT.html");
    command->add_option("--title", options->title, "What the page calls the object [the field's name]")
        ->type_name("TEXT");
    add_start_options(*command, options->views);
    command
        ->add_option("--reference", options->reference,
                     "Folder of a path-traced turntable to compare with: lumi reference SCENE -o DIR/view.png "
                     "--turntable 36, with the same --orbit and --background")
        ->type_name("DIR");
    command->footer("Example:\n  lumi view product.lumi -o product.html");
    command->callback([options] { run(*options); });
}

}  // namespace lumi::tools
