// SPDX-License-Identifier: MIT
// A report knows these: the references of a scene's held-out views, and what fields and baselines show of them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "draw/draw.h"
#include "draw/draw_surface.h"
#include "files/field_file.h"
#include "metrics/psnr.h"
#include "quality/kept.h"
#include "quality/references.h"

namespace lumi::quality
{

// Ways to draw a chord field, as words name them.

struct DrawMode {
    std::string name;  // as it was given
    tools::DrawSettings settings;
};

inline constexpr const char* kDrawModeWords =
    "nearest, linear or paperK with K from 1 to 9; the first two also with /S for spans "
    "of S = 2, 4, 8 or 16 pixels, for instance linear/8";

// "linear", "paper9", "nearest/8"; nothing for other words.
std::optional<DrawMode> parse_draw_mode(std::string_view text);

// How a field is drawn: by the one that its layout takes.
struct Way {
    tools::SurfaceDrawSettings surface;
    tools::DrawSettings chord;
};

// The finest of a surface field, exact `linear` of a chord field.
Way finest(tools::DisplayFormat display = tools::DisplayFormat::rgb888);

// A kind of picture, drawn for every view.
struct Measured {
    std::string name;    // the file's name
    std::string layout;  // "chord", "surface", "mean alone", "antialiased", ...
    Way way;             // of fields
    uint64_t flash_bytes = 0;
    std::vector<tools::Section> sections;
    std::vector<tools::Picture> pictures;
    std::vector<Figures> figures;  // one for each view
    Figures mean;
    uint32_t triangles = 0;           // in a surface field
    std::vector<tools::Block> worst;  // block of each view
    double draw_ms = 0;               // processor time of one view on this machine, the mean
};

// The view of least PSNR, and the one that holds the worst block. Precondition: at least one view.
size_t worst_view(const Measured& m);
size_t worst_block_view(const Measured& m);

// Fields are measured against these, by one way of drawing; `kept` says where that is kept.
struct Yardstick {
    const std::vector<HeldOutView>& views;
    const std::vector<Reference>& references;  // one for each view
    Way way = finest();
    Kept kept = {};
};

using DrawView = std::function<tools::Picture(const HeldOutView&)>;

// Draws and judges all views.
Measured measured(const std::string& name, const std::string& layout, uint64_t flash_bytes, const DrawView& draw,
                  const std::vector<HeldOutView>& views, const std::vector<Reference>& references);

tools::Picture drawn(const tools::FieldFile& file, const HeldOutView& view, const Way& way = finest());
// "chord", "surface", or "mean alone": a surface field whose colours do not depend on the direction of view.
const char* layout_of(const tools::FieldFile& file);
// A field by the best that it offers.
Measured measured_field(const tools::FieldFile& file, const Yardstick& by);

// The cheaper modes of a surface field; a chord field by the modes that are given; as `by` says in all else.
std::vector<Measured> measured_variants(const tools::FieldFile& file, const std::vector<DrawMode>& modes,
                                        const Yardstick& by);

// A digest of all that decides how the field is drawn.
std::string key_of(const tools::FieldFile& file, const Way& way);

}  // namespace lumi::quality
