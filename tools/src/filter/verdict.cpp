// SPDX-License-Identifier: MIT
#include "filter/verdict.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <limits>
#include <nlohmann/json.hpp>

namespace lumi::filter
{

namespace
{

Planes filtered(Network& network, const Planes& inputs, double& fastest_ms)
{
    const std::clock_t begin = std::clock();
    Planes planes = network.filtered(inputs);
    fastest_ms = std::min(fastest_ms, 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    return planes;
}

void count_worse(const quality::Figures& drawn, const quality::Figures& filtered, Verdict& verdict)
{
    verdict.worse_psnr += filtered.psnr_db < drawn.psnr_db;
    verdict.worse_ssim += filtered.ssim < drawn.ssim;
    verdict.worse_cw_ssim += filtered.cw_ssim < drawn.cw_ssim;
    verdict.worse_flip += filtered.flip > drawn.flip;
}

std::string row(const char* name, const quality::Figures& f)
{
    char text[160];
    std::snprintf(text, sizeof text, "%-9s %8.2f %8.2f %8.4f %8.4f %8.4f\n", name, f.psnr_db, f.mask_psnr_db, f.ssim,
                  f.cw_ssim, f.flip);
    return text;
}

nlohmann::ordered_json json_of(const quality::Figures& f)
{
    return {{"psnr_db", f.psnr_db},
            {"mask_psnr_db", f.mask_psnr_db},
            {"ssim", f.ssim},
            {"cw_ssim", f.cw_ssim},
            {"flip", f.flip}};
}

}  // namespace

Verdict verdict_on(Network* network, const Trial& trial)
{
    Verdict verdict;
    verdict.views = static_cast<int>(trial.drawn.size());
    double fastest_ms = std::numeric_limits<double>::infinity();
    std::vector<quality::Figures> drawn, after;
    for (size_t k = 0; k < trial.drawn.size(); ++k) {
        const Planes& inputs = trial.drawn[k];
        drawn.push_back(quality::figures_of(over(inputs), trial.references[k]));
        after.push_back(drawn.back());
        if (network != nullptr)
            after.back() = quality::figures_of(over(filtered(*network, inputs, fastest_ms)), trial.references[k]);
        count_worse(drawn.back(), after.back(), verdict);
    }
    verdict.drawn = quality::mean_of(drawn);
    verdict.filtered = quality::mean_of(after);
    if (network != nullptr) verdict.milliseconds = fastest_ms;
    return verdict;
}

std::string text_of(const Verdict& verdict)
{
    char worse[200];
    std::snprintf(worse, sizeof worse,
                  "of %d views, worse when filtered: PSNR %d, SSIM %d, CW-SSIM %d, FLIP %d; %.0f ms of CPU a view\n",
                  verdict.views, verdict.worse_psnr, verdict.worse_ssim, verdict.worse_cw_ssim, verdict.worse_flip,
                  verdict.milliseconds);
    return "          PSNR dB  covered     SSIM  CW-SSIM     FLIP\n" + row("drawn", verdict.drawn) +
           row("filtered", verdict.filtered) + worse;
}

std::string json_of(const Verdict& verdict)
{
    const nlohmann::ordered_json json = {{"views", verdict.views},
                                         {"drawn", json_of(verdict.drawn)},
                                         {"filtered", json_of(verdict.filtered)},
                                         {"worse",
                                          {{"psnr", verdict.worse_psnr},
                                           {"ssim", verdict.worse_ssim},
                                           {"cw_ssim", verdict.worse_cw_ssim},
                                           {"flip", verdict.worse_flip}}},
                                         {"milliseconds", verdict.milliseconds}};
    return json.dump(2) + "\n";
}

}  // namespace lumi::filter
