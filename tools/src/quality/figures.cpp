// SPDX-License-Identifier: MIT
#include "quality/figures.h"

#include <algorithm>

#include "metrics/cw_ssim.h"
#include "metrics/flip.h"
#include "metrics/psnr.h"
#include "metrics/ssim.h"

namespace lumi::quality
{

namespace
{

bool is_empty(const tools::Mask& mask)
{
    return std::all_of(
        mask.values.begin(), mask.values.end(), [](uint8_t value) { return value == 0; });
}

}  // namespace

Figures figures_of(const tools::Picture& picture, const Reference& reference)
{
    Figures figures;
    figures.psnr_db = std::min(kIdenticalDb, tools::psnr_db(picture, reference.picture));
    figures.ssim = tools::ssim(picture, reference.picture);
    figures.cw_ssim = tools::cw_ssim(picture, reference.picture);
    figures.flip = tools::flip(reference.picture, picture);
    const bool whole = is_empty(reference.mask);
    figures.mask_psnr_db =
        whole ? figures.psnr_db : std::min(kIdenticalDb, tools::psnr_db(picture, reference.picture, reference.mask));
    figures.mask_ssim = whole ? figures.ssim : tools::ssim(picture, reference.picture, reference.mask);
    return figures;
}

Figures mean_of(const std::vector<Figures>& all)
{
    Figures mean;
    constexpr double Figures::*kMembers[] = {&Figures::psnr_db, &Figures::ssim,         &Figures::cw_ssim,
                                             &Figures::flip,    &Figures::mask_psnr_db, &Figures::mask_ssim};
    for (const auto member : kMembers) {
        for (const Figures& figures : all) mean.*member += figures.*member;
        mean.*member /= static_cast<double>(all.size());
    }
    return mean;
}

}  // namespace lumi::quality
