// SPDX-License-Identifier: MIT
// Measures what a filter does to views that it has not learned from.
#pragma once

#include <string>

#include "filter/lessons.h"

namespace lumi::filter
{

struct Verdict {
    quality::Figures drawn, filtered;  // means over the views
    int views = 0;
    // Where filtering lowers a measure: PSNR, SSIM or CW-SSIM falls, or FLIP rises.
    int worse_psnr = 0, worse_ssim = 0, worse_cw_ssim = 0, worse_flip = 0;
    double milliseconds = 0;  // processor time of the fastest view; 0 where pictures stay as they are drawn
};

// `network`: null where pictures stay as they are drawn.
Verdict verdict_on(Network* network, const Trial& trial);

std::string text_of(const Verdict& verdict);
std::string json_of(const Verdict& verdict);

}  // namespace lumi::filter
