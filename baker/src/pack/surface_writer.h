// SPDX-License-Identifier: MIT
// Writes the file of a surface field (lumi/surface/format.h).
#pragma once

#include <array>
#include <string>

#include "fit/fit_shape.h"
#include "lumi/color.h"
#include "lumi/surface/format.h"
#include "pack/texel_palette.h"

namespace lumi::baker
{

// Holds a vertex's view table.
struct ViewCode {
    std::array<uint8_t, 3> gains{};  // 0: there is no table
    std::array<uint8_t, detail::format::kViewNodes> codes{};

    bool is_there() const { return gains[0] != 0; }
};

// The colours that all view tables share: 2^bits a node.
struct NodeColours {
    using Colour = std::array<int8_t, 3>;
    uint32_t bits = 1;
    std::vector<Colour> colours = std::vector<Colour>(detail::format::kViewNodes << 1);

    const Colour& of(size_t node, size_t code) const { return colours[(node << bits) + code]; }
};

// An entry of the palette of see-through patches.
struct SeeThroughColour {
    Rgb8 added, passed;
};

// A state of the light, of a field that has several.
struct StateColours {
    std::string name;
    float scale = 1;               // all its light is divided by it
    Rgb8 usual = {255, 255, 255};  // the level of its weight until another is chosen
    bool is_tint = false;
    PaletteColours palette, added;  // of texels, and of what see-through texels add
    NodeColours node_colours;
    std::vector<ViewCode> views;  // by vertex; the codes are the same in all states
};

struct FieldParts {
    std::array<double, 3> centre;
    double radius;
    PaletteColours palette;
    std::vector<uint8_t> texels;
    NodeColours node_colours;
    std::vector<ViewCode> views;  // by vertex
    std::array<SeeThroughColour, detail::format::kPaletteEntries> see_through{};
    bool is_draft = false;
    std::vector<StateColours> states = {};  // what stands above is all of them together; empty: there is one
    std::vector<uint8_t> means = {};        // by vertex: the entry of the states' palettes that is about its mean
};

std::vector<uint8_t> surface_file(const FitShape& shape, const FieldParts& parts);

}  // namespace lumi::baker
