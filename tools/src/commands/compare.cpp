// SPDX-License-Identifier: MIT
// lumi compare: how alike two pictures are.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "commands/commands.h"
#include "files/output_file.h"
#include "image/picture_file.h"
#include "metrics/metrics.h"
#include "program/option_checks.h"
#include "terminal/failure.h"
#include "terminal/progress_printer.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

struct CompareOptions {
    std::string a, b, mask, error_picture;
    double pixels_per_degree = kFlipPixelsPerDegree;
    double least_psnr_db = 0;
    bool json = false;
};

struct Likeness {
    double psnr_db, ssim, cw_ssim, flip;
};

// Likeness of the pixels that a mask leaves.
struct MaskedLikeness {
    double psnr_db, ssim;
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

bool has_black_corners(const Picture& picture)
{
    const int right = picture.width_px - 1, bottom = picture.height_px - 1;
    const uint8_t* const corners[] = {picture.pixel(0, 0), picture.pixel(right, 0), picture.pixel(0, bottom),
                                      picture.pixel(right, bottom)};
    return std::all_of(std::begin(corners), std::end(corners),
                       [](const uint8_t* c) { return c[0] == 0 && c[1] == 0 && c[2] == 0; });
}

// The gradient of one picture beside the black of another would count as a difference of their objects.
void warn_of_backgrounds(const CompareOptions& options, const Picture& a, const Picture& b)
{
    if (has_black_corners(a) == has_black_corners(b)) return;
    print(stderr,
          "lumi: warning: only %s has black corners; if the backgrounds differ, draw both with --background "
          "black\n",
          (has_black_corners(a) ? options.a : options.b).c_str());
}

// Null where the pictures are identical: JSON has no infinity.
nlohmann::ordered_json json_db(double psnr_db)
{
    return std::isinf(psnr_db) ? nlohmann::ordered_json() : nlohmann::ordered_json(psnr_db);
}

void print_likeness(const Likeness& likeness, const std::optional<MaskedLikeness>& masked)
{
    nlohmann::ordered_json report;
    report["psnr_db"] = json_db(likeness.psnr_db);
    report["ssim"] = likeness.ssim;
    report["cw_ssim"] = likeness.cw_ssim;
    report["flip"] = likeness.flip;
    if (masked) {
        report["mask_psnr_db"] = json_db(masked->psnr_db);
        report["mask_ssim"] = masked->ssim;
    }
    report["identical"] = std::isinf(likeness.psnr_db);
    print(stdout, "%s\n", report.dump(2).c_str());
}

void print_text(const Likeness& likeness, const std::optional<MaskedLikeness>& masked)
{
    print(stdout, "PSNR     %.2f dB\nSSIM     %.4f\nCW-SSIM  %.4f\nFLIP     %.4f\n", likeness.psnr_db, likeness.ssim,
          likeness.cw_ssim, likeness.flip);
    if (masked) print(stdout, "inside the mask\nPSNR     %.2f dB\nSSIM     %.4f\n", masked->psnr_db, masked->ssim);
}

// White or grey where pixels count, black where they do not.
Mask read_mask(const std::string& path, const Picture& like)
{
    const Picture picture = read_png(path);
    if (!same_size(picture, like))
        throw Failure(path, "is " + size_text(picture) + " but the pictures are " + size_text(like),
                      "give a mask of their size");
    Mask mask(picture.width_px, picture.height_px);
    for (size_t i = 0; i < mask.values.size(); ++i)
        mask.values[i] = std::max({picture.rgb[3 * i], picture.rgb[3 * i + 1], picture.rgb[3 * i + 2]});
    if (std::all_of(mask.values.begin(), mask.values.end(), [](uint8_t value) { return value == 0; }))
        throw Failure(path, "is black, so no pixel counts", "paint what counts white");
    return mask;
}

std::optional<MaskedLikeness> masked_likeness(const CompareOptions& options, const Picture& a, const Picture& b)
{
    if (options.mask.empty()) return std::nullopt;
    const Mask mask = read_mask(options.mask, a);
    return MaskedLikeness{psnr_db(a, b, mask), ssim(a, b, mask)};
}

Likeness likeness_of(const CompareOptions& options, const Picture& a, const Picture& b)
{
    const LeaveAtOnce leaving;
    return {psnr_db(a, b), ssim(a, b), cw_ssim(a, b), flip(b, a, options.pixels_per_degree)};
}

void run(const CompareOptions& options)
{
    announce_outputs({options.error_picture});
    std::optional<Waiting> waiting(std::in_place, "comparing");
    const Picture a = read_png(options.a), b = read_png(options.b);
    require_comparable(options, a, b);
    if (options.mask.empty()) warn_of_backgrounds(options, a, b);
    const std::optional<MaskedLikeness> masked = masked_likeness(options, a, b);
    const Likeness likeness = likeness_of(options, a, b);
    if (!options.error_picture.empty()) write_png(options.error_picture, error_picture(a, b));
    waiting.reset();
    (options.json ? print_likeness : print_text)(likeness, masked);
    const double psnr = masked ? masked->psnr_db : likeness.psnr_db;
    if (psnr >= options.least_psnr_db) return;
    char problem[64];
    std::snprintf(problem, sizeof problem, "has %.2f dB, less than --min-psnr %g", psnr, options.least_psnr_db);
    throw Failure(options.a, problem, "look at --error-picture");
}

}  // namespace

void add_compare(CLI::App& lumi)
{
    auto options = std::make_shared<CompareOptions>();
    CLI::App* command = lumi.add_subcommand("compare", "Say how alike two pictures are: PSNR, SSIM, CW-SSIM, FLIP");
    command->add_option("A", options->a, "One PNG file")->required();
    command->add_option("B", options->b, "Another PNG file of the same size")->required();
    command->add_flag(
        "--json", options->json,
        "Print JSON: psnr_db (null if identical), ssim, cw_ssim, flip, identical, and with --mask mask_psnr_db and "
        "mask_ssim");
    command
        ->add_option("--error-picture", options->error_picture,
                     "Also write a picture of the differences, four times as bright as they are")
        ->type_name("OUT.png")
        ->check(wrong_png_name);
    command->add_option("--mask", options->mask, "Also compare only where this picture is not black")
        ->type_name("MASK.png");
    constexpr double kMostDb = 100;
    command
        ->add_option("--min-psnr", options->least_psnr_db,
                     "End with 1 if PSNR is below this, with --mask inside of it: for automatic tests")
        ->check(number(0, kMostDb))
        ->type_name("DB");
    constexpr double kMaxPixelsPerDegree = 1000;
    command
        ->add_option("--ppd", options->pixels_per_degree,
                     "Pixels a degree of the observer's view, for FLIP: the distance to the screen in pixels times "
                     "0.01745")
        ->check(number(1, kMaxPixelsPerDegree))
        ->type_name("PPD")
        ->capture_default_str();
    command->footer("Example:\n  lumi compare view.png truth.png --json");
    command->callback([options] { run(*options); });
}

}  // namespace lumi::tools
