// SPDX-License-Identifier: MIT
// lumi compare: how alike two pictures are.
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "lumi/tools/cw_ssim.h"
#include "lumi/tools/error_picture.h"
#include "lumi/tools/failure.h"
#include "lumi/tools/output_file.h"
#include "lumi/tools/png.h"
#include "lumi/tools/psnr.h"
#include "lumi/tools/ssim.h"

namespace lumi::tools
{

namespace
{

struct CompareOptions {
    std::string a, b, error_picture;
    bool json = false;
};

struct Likeness {
    double psnr_db, ssim, cw_ssim;
};

std::string size_text(const Picture& picture)
{
    return std::to_string(picture.width_px) + "x" + std::to_string(picture.height_px);
}

void require_comparable(const CompareOptions& options, const Picture& a, const Picture& b)
{
    if (!same_size(a, b))
        throw Failure(options.b, "is " + size_text(b) + " but " + options.a + " is " + size_text(a),
                      "render both with the same --size");
    if (a.width_px < kSsimWindow || a.height_px < kSsimWindow)
        throw Failure(options.a, "is " + size_text(a) + ", too small for SSIM's 11x11 window",
                      "give pictures of at least 11x11 pixels");
}

void print_json(const Likeness& likeness)
{
    const bool identical = std::isinf(likeness.psnr_db);
    nlohmann::ordered_json report;
    report["psnr_db"] = identical ? nlohmann::ordered_json() : nlohmann::ordered_json(likeness.psnr_db);
    report["ssim"] = likeness.ssim;
    report["cw_ssim"] = likeness.cw_ssim;
    report["identical"] = identical;
    std::printf("%s\n", report.dump(2).c_str());
}

void run(const CompareOptions& options)
{
    const Picture a = read_png(options.a), b = read_png(options.b);
    require_comparable(options, a, b);
    if (!options.error_picture.empty()) write_png(options.error_picture, error_picture(a, b));
    const Likeness likeness = {psnr_db(a, b), ssim(a, b), cw_ssim(a, b)};
    if (options.json) return print_json(likeness);
    std::printf("PSNR     %.2f dB\nSSIM     %.4f\nCW-SSIM  %.4f\n", likeness.psnr_db, likeness.ssim, likeness.cw_ssim);
}

}  // namespace

void add_compare(CLI::App& lumi)
{
    auto options = std::make_shared<CompareOptions>();
    CLI::App* command = lumi.add_subcommand("compare", "Say how alike two pictures are: PSNR, SSIM, CW-SSIM");
    command->add_option("A", options->a, "One PNG file")->required();
    command->add_option("B", options->b, "Another PNG file of the same size")->required();
    command->add_flag("--json", options->json, "Print JSON: psnr_db (null if identical), ssim, cw_ssim, identical");
    command
        ->add_option("--error-picture", options->error_picture,
                     "Also write a picture of the differences, four times as bright as they are")
        ->type_name("OUT.png");
    command->footer("Example:\n  lumi compare view.png truth.png --json");
    command->callback([options] { run(*options); });
}

}  // namespace lumi::tools
