// SPDX-License-Identifier: MIT
#include "commands/layout_options.h"

#include <array>

#include "program/choice.h"
#include "terminal/failure.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

const Choices<Layout> kLayouts = {{"auto", Layout::automatic}, {"surface", Layout::surface}, {"chord", Layout::chord}};

constexpr std::array kChordOnly = {"--origins", "--directions", "--texel",   "--footprint",
                                   "--beam",    "--spp",        "--adaptive"};
constexpr std::array kSurfaceShape = {"--triangles", "--longest-edge", "--texel-density", "--no-view-tables"};
// Only surface fields take it, but it says nothing of the layout: a scene may still suit only the other one.
constexpr std::array kSurfaceTime = {"--paths"};

// The first of them that was given; null if none was.
template <class Names>
const char* first_given(const CLI::App& command, const Names& names)
{
    for (const char* name : names)
        if (command.count(name) != 0) return name;
    return nullptr;
}

// A number of origins; a share suits both layouts.
bool is_chord_cap(const CLI::App& command)
{
    return command.count("--cap") != 0 && !parse_cap_share(command.get_option("--cap")->as<std::string>());
}

void refuse(const char* option, const std::string& layout)
{
    if (option != nullptr) throw UsageError(std::string(option) + " does not go with --layout " + layout);
}

}  // namespace

void add_layout_option(CLI::App& command, Layout& layout)
{
    add_choice(command, "--layout", layout, kLayouts,
               "surface: a mesh that carries colours, by far the best for solid objects; chord: the paper's, for all "
               "scenes; auto: surface, unless a mesh does not do the scene justice [auto]");
}

Layout resolved_layout(const CLI::App& command, Layout layout)
{
    const char* chord = is_chord_cap(command) ? "--cap with a number of origins" : first_given(command, kChordOnly);
    const char* shape = first_given(command, kSurfaceShape);
    const char* surface = shape != nullptr ? shape : first_given(command, kSurfaceTime);
    if (layout == Layout::chord) refuse(surface, "chord");
    if (layout == Layout::surface) refuse(chord, "surface");
    if (layout != Layout::automatic) return layout;
    if (chord != nullptr && surface != nullptr)
        throw UsageError(std::string(chord) + " belongs to chord fields, " + surface +
                         " to surface fields; leave one of them out");
    return chord != nullptr ? Layout::chord : shape != nullptr ? Layout::surface : Layout::automatic;
}

}  // namespace lumi::tools
