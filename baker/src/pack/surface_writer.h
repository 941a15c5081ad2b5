// SPDX-License-Identifier: MIT
// Writes the file of a surface field (lumi/surface/format.h).
#pragma once

#include <array>

#include "fit/fit_shape.h"
#include "lumi/color.h"
#include "lumi/surface/format.h"

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

struct FieldParts {
    std::array<double, 3> centre;
    double radius;
    std::array<Rgb8, detail::format::kPaletteEntries> palette;
    std::vector<uint8_t> texels;
    NodeColours node_colours;
    std::vector<ViewCode> views;  // by vertex
    std::array<SeeThroughColour, detail::format::kPaletteEntries> see_through{};
    bool is_draft = false;
};

std::vector<uint8_t> surface_file(const FitShape& shape, const FieldParts& parts);

}  // namespace lumi::baker
