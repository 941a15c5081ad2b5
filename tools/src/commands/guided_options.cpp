// SPDX-License-Identifier: MIT
#include "commands/guided_options.h"

#include <cstdio>

#include "commands/choice.h"
#include "terminal/failure.h"

namespace lumi::tools
{

namespace
{

const Choices<Layout> kLayouts = {
    {"chord", Layout::chord}, {"guided", Layout::guided}, {"focus", Layout::focus}, {"surface", Layout::surface}};
const Choices<format::MeanFormat> kMeanFormats = {{"rgb565", format::MeanFormat::rgb565},
                                                  {"palette8", format::MeanFormat::palette8}};

const Choices<format::GuidedTexel> kTexels = {{"none", format::GuidedTexel::none},
                                              {"4", format::GuidedTexel::index4},
                                              {"8", format::GuidedTexel::index8},
                                              {"vq8", format::GuidedTexel::vq8}};

constexpr const char* kChordOnly[] = {"--directions", "--texel", "--footprint", "--adaptive"};
constexpr const char* kGuidedOnly[] = {"--proxy-triangles", "--mean-resolution", "--mean-format", "--no-occlusion"};
constexpr const char* kFocusOnly[] = {"--focus", "--focus-radius"};
constexpr const char* kLatticeOnly[] = {"--origins", "--cap", "--spp", "--shard"};
constexpr const char* kChartOnly[] = {"--chart", "--texels", "--jitter"};

template <size_t count>
void refuse(const CLI::App& command, const char* const (&names)[count], const std::string& layout)
{
    for (const char* name : names)
        if (command.count(name) != 0) throw UsageError(std::string(name) + " does not go with --layout " + layout);
}

void add_proxy_options(CLI::App& command, GuidedOptions& options)
{
    baker::GuidedSettings& s = options.settings;
    command
        .add_option("--proxy-triangles", s.proxy_triangles, "guided: triangles of the surface that all origins look at")
        ->type_name("T")
        ->check(CLI::Range(uint32_t{1}, format::kMaxProxyTriangles))
        ->capture_default_str();
    command
        .add_option("--mean-resolution", s.mean_resolution,
                    "guided: voxels of the mean colour along the sphere's cube, 8 to 252; 0: none, texels then hold "
                    "colours in place of differences")
        ->type_name("R")
        ->capture_default_str();
    add_choice(command, "--mean-format", s.mean_format, kMeanFormats, "FORMAT",
               "guided: what a voxel is stored as: rgb565 (2 bytes) or palette8 (1) [palette8]");
    command.add_flag("--no-occlusion", options.no_occlusion,
                     "guided: leave out what tells origins apart that do not see a point");
}

void add_chart_options(CLI::App& command, GuidedOptions& options)
{
    baker::GuidedSettings& s = options.settings;
    command.add_option("--chart", s.chart_size, "guided, focus: grid points across what an origin sees")
        ->type_name("G")
        ->check(CLI::Range(format::kMinChart, format::kMaxChart))
        ->capture_default_str();
    add_choice(
        command, "--texels", s.texel, kTexels, "BITS",
        "guided, focus: bits a texel: 4, 8, or guided alone: vq8, eight for blocks of 2x2, or none where the mean "
        "colours say enough [4]");
    command
        .add_option("--jitter", s.jitter, "guided, focus: how far a texel's samples spread, in its share of the disc")
        ->type_name("RADIUS")
        ->check(CLI::Range(0.0f, 2.0f))
        ->capture_default_str();
}

}  // namespace

void add_guided_options(CLI::App& command, GuidedOptions& options)
{
    add_choice(
        command, "--layout", options.layout, kLayouts, "LAYOUT",
        "chord: the paper's, for everything; guided: aimed at a surface, by far the best for solid objects; "
        "focus: aimed at a point or a sphere, for hair, glass and glow; surface: a mesh that carries colours, the "
        "fastest to draw [chord]");
    add_chart_options(command, options);
    add_proxy_options(command, options);
    command.add_option("--focus", options.focus, "focus: the point, in the scene's units [the sphere's centre]")
        ->type_name("X,Y,Z")
        ->delimiter(',')
        ->expected(3);
    command
        .add_option("--focus-radius", options.settings.focus_radius,
                    "focus: radius of a sphere around it that rays are aimed at, in the scene's units [0]")
        ->type_name("R")
        ->check(CLI::NonNegativeNumber);
}

void require_fitting_options(const CLI::App& command, const GuidedOptions& options)
{
    switch (options.layout) {
        case Layout::chord:
            refuse(command, kChartOnly, "chord");
            refuse(command, kGuidedOnly, "chord");
            refuse(command, kFocusOnly, "chord");
            return;
        case Layout::guided:
            refuse(command, kChordOnly, "guided");
            refuse(command, kFocusOnly, "guided");
            return;
        case Layout::focus:
            refuse(command, kChordOnly, "focus");
            refuse(command, kGuidedOnly, "focus");
            return;
        case Layout::surface:
            refuse(command, kChordOnly, "surface");
            refuse(command, kGuidedOnly, "surface");
            refuse(command, kFocusOnly, "surface");
            refuse(command, kChartOnly, "surface");
            refuse(command, kLatticeOnly, "surface");
            return;
    }
}

baker::GuidedSettings guided_settings(const GuidedOptions& options)
{
    baker::GuidedSettings s = options.settings;
    s.surface = options.layout == Layout::focus ? format::GuidedSurface::focus : format::GuidedSurface::proxy;
    s.occlusion = !options.no_occlusion;
    if (!options.focus.empty()) s.focus = {options.focus[0], options.focus[1], options.focus[2]};
    return s;
}

std::string proxy_text(const baker::GuidedBake& bake)
{
    if (bake.triangles == 0) return "";
    const auto percent = [](double share) {
        char text[16];
        std::snprintf(text, sizeof text, "%.1f %%", 100 * share);
        return std::string(text);
    };
    return "proxy: " + std::to_string(bake.triangles) + " triangles" +
           (bake.two_sided ? ", seen from both sides" : "") + "; of the rays that meet the scene it misses " +
           percent(bake.loss.missed) + ", displaces " + percent(bake.loss.displaced) + ", adds " +
           percent(bake.loss.added) + "\n";
}

}  // namespace lumi::tools
