// SPDX-License-Identifier: MIT
// The page of `lumi view`: a field and the code that draws it, in one HTML file that needs nothing but itself.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "draw/views.h"

namespace lumi::tools
{

// How fast a part draws in a mode, on 240 × 240 pixels.
struct ShownRate {
    std::string chip;  // its key
    double mean, worst;
};

struct ShownMode {
    int number;        // as the module counts them: platform/wasm/*_drawing.cpp
    std::string name;  // as `lumi render --mode` takes it
    std::string title, remark;
    std::vector<ShownRate> rates;  // may be empty: not modelled
};

struct ShownChip {
    std::string key, title, remark;
    double clock_mhz;
    uint32_t ram_bytes;  // in one piece
};

struct ViewPage {
    std::string title;  // what people call the field
    std::string layout;
    std::string_view module;  // compressed by gzip
    std::string_view field;
    std::vector<ShownMode> modes;  // from the coarsest to the finest
    int first_mode = 0;            // an index of modes
    std::vector<ShownChip> chips;
    host::Orbit home;
    Rgb8 background = {0, 0, 0};
    std::vector<std::string> references;  // PNG files: a turntable that begins at home; may be empty
};

std::string html_of(const ViewPage& page);

}  // namespace lumi::tools
