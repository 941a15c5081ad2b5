// SPDX-License-Identifier: MIT
// What a report knows: the truths of a scene's held-out views, and what fields and baselines show of them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "files/field_file.h"
#include "quality/figures.h"
#include "quality/truths.h"

namespace lumi::quality
{

// A kind of picture, drawn for every view.
struct Measured {
    std::string name;    // of the file, or what the baseline is
    std::string layout;  // "chord", "surface", "sprites", "one ray"
    uint64_t flash_bytes = 0;
    std::vector<tools::Section> sections;
    std::vector<tools::Picture> pictures;
    std::vector<Figures> figures;  // of each view
    Figures mean;
};

using DrawView = std::function<tools::Picture(const HeldOutView&)>;

// Draws and judges all views.
Measured measured(const std::string& name, const std::string& layout, uint64_t flash_bytes, const DrawView& draw,
                  const std::vector<HeldOutView>& views, const std::vector<Truth>& truths);

// A field by the best that it offers.
tools::Picture drawn(const tools::FieldFile& file, const HeldOutView& view);
Measured measured_field(const tools::FieldFile& file, const std::vector<HeldOutView>& views,
                        const std::vector<Truth>& truths);

}  // namespace lumi::quality
