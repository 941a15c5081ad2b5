// SPDX-License-Identifier: MIT
// lumi_demo_firmware: draws a turn around the object in its field, stripe by stripe, as firmware does that feeds a
// panel. Reports over semihosting each picture's CRC, what drawing cost, and the picture itself when asked. See kUsage.
#include <cstdlib>
#include <cstring>
#include <optional>

#include "lumi/chord/render.h"
#include "lumi/color.h"
#include "lumi/detail/crc32.h"
#include "lumi/mps2/board.h"
#include "lumi/mps2/meters.h"
#include "text_line.h"

// embedded_field.S defines both.
extern "C" const uint8_t lumi_field_start[];
extern "C" const uint8_t lumi_field_end[];

namespace lumi::firmware
{
namespace
{

constexpr int kUsageExitCode = 64;  // EX_USAGE of sysexits.h
constexpr int kFailureExitCode = 1;

constexpr int32_t kElevationTurns32 = 298261617;     // 25 degrees
constexpr int32_t kDistanceQ20 = 5 * kOneQ20 / 2;    // 2.5 radii
constexpr uint32_t kFieldOfViewTurns32 = 536870912;  // 45 degrees: the sphere nearly fills the picture
constexpr int kFrameDigits = 3;

constexpr int32_t kSide = 240, kStripeHeight = 16;
static_assert(kSide % kStripeHeight == 0, "every stripe is full");
constexpr uint32_t kStrideBytes = kSide * PixelRgb565::kBytes;
constexpr OverColour kBackground = {{24, 28, 36}};

constexpr uint32_t kMaxFrames = 999;
constexpr const char* kUsage =
    "usage: [--frames 1..999] [--mode nearest|linear|paper] [--verify] [--write PREFIX]\n"
    "The field is linked into the program, or loaded to the start of the board's PSRAM.\n";

// Draws a stripe as RGB565 with the policies that a field and a mode ask for.
using DrawStripe = RenderError (*)(const Field&, const Camera&, const Stripe&);

struct DemoOptions {
    uint32_t frames = 1;  // in one turn around the object
    const char* mode = "linear";
    bool verify = false;                 // check the CRC of every section first
    const char* write_prefix = nullptr;  // write frame k to "<prefix>-<k>.ppm" on the host
};

// What the frame's stripes cost, in render() alone.
struct FrameReport {
    uint32_t crc = 0;
    uint32_t covered_px = 0;    // pixels whose ray meets the sphere
    uint64_t instructions = 0;  // to within a SysTick tick a stripe
    uint32_t stack_bytes = 0;   // deepest stack below its caller
};

uint8_t stripe_pixels[kStrideBytes * kStripeHeight];

template <class Reconstruction>
DrawStripe renderer_of(TexelFormat texels)
{
    return detail::with_texel(
        texels,
        [](auto texel) -> DrawStripe {
            return [](const Field& field, const Camera& camera, const Stripe& stripe) {
                return render<Reconstruction, decltype(texel), PixelRgb565>(field, camera, kBackground, stripe);
            };
        });
}

// Null for an unknown mode.
DrawStripe choose_renderer(const char* mode, TexelFormat texels)
{
    if (std::strcmp(mode, "nearest") == 0) return renderer_of<Nearest>(texels);
    if (std::strcmp(mode, "linear") == 0) return renderer_of<Linear>(texels);
    return std::strcmp(mode, "paper") == 0 ? renderer_of<Paper<5>>(texels) : nullptr;
}

// False where a word is unknown or a value cannot be.
bool parse(int argc, char** argv, DemoOptions& options)
{
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--verify") == 0) {
            options.verify = true;
            continue;
        }
        const char* const name = argv[i];
        if (++i == argc) return false;
        if (std::strcmp(name, "--frames") == 0)
            options.frames = static_cast<uint32_t>(std::strtoul(argv[i], nullptr, 10));
        else if (std::strcmp(name, "--mode") == 0)
            options.mode = argv[i];
        else if (std::strcmp(name, "--write") == 0)
            options.write_prefix = argv[i];
        else
            return false;
    }
    return options.frames >= 1 && options.frames <= kMaxFrames &&
           choose_renderer(options.mode, TexelFormat::rgb888) != nullptr;
}

int fail(const char* what, const char* why)
{
    TextLine line;
    mps2::write(line.text("error: ").text(what).text(": ").text(why).text("\n").c_str());
    return kFailureExitCode;
}

// A binary PPM picture (P6): its header, then the panel's own pixels, stripe by stripe.
void write_header(mps2::OutputFile& file)
{
    TextLine header;
    header.text("P6\n").decimal(kSide).text(" ").decimal(kSide).text("\n255\n");
    file.write(header.c_str(), std::strlen(header.c_str()));
}

void write_stripe(mps2::OutputFile& file)
{
    uint8_t row[3 * kSide];
    for (const uint8_t* at = stripe_pixels; at < stripe_pixels + sizeof(stripe_pixels);) {
        for (uint8_t* out = row; out < row + sizeof(row); out += 3, at += PixelRgb565::kBytes) {
            const Rgb8 colour = detail::unpack_rgb565(static_cast<uint16_t>(at[0] | at[1] << 8));
            out[0] = colour.r;
            out[1] = colour.g;
            out[2] = colour.b;
        }
        file.write(row, sizeof(row));
    }
}

// Draws one stripe and adds its cost to the report.
RenderError draw_measured(const Field& field, const Camera& camera, DrawStripe draw, int32_t y, FrameReport& report)
{
    mps2::StackMeter meter;
    meter.paint();
    const uint64_t begin = mps2::instructions();
    const RenderError error = draw(field, camera, {stripe_pixels, 0, y, kSide, kStripeHeight, kStrideBytes});
    report.instructions += mps2::instructions() - begin;
    const uint32_t stack_bytes = meter.high_water_bytes();
    report.stack_bytes = stack_bytes > report.stack_bytes ? stack_bytes : report.stack_bytes;
    report.crc = detail::crc32(report.crc, stripe_pixels, sizeof(stripe_pixels));
    for (int32_t row = y; row < y + kStripeHeight; ++row) {
        const detail::Extent span = detail::covered_extent(camera, row, 0, kSide);
        report.covered_px += static_cast<uint32_t>(span.end - span.begin);
    }
    return error;
}

void write_report(uint32_t frame, const FrameReport& report)
{
    TextLine line;
    line.text("frame ").decimal(frame, kFrameDigits).text(" crc ").hex32(report.crc);
    line.text(" covered ").decimal(report.covered_px).text(" instructions ").decimal(report.instructions);
    const uint64_t covered = report.covered_px != 0 ? report.covered_px : 1;
    line.text(" per-covered ").decimal(report.instructions / covered);
    mps2::write(line.text(" stack ").decimal(report.stack_bytes).text("\n").c_str());
}

int draw_frame(const Field& field, const DemoOptions& options, uint32_t frame)
{
    const uint32_t azimuth_turns32 = static_cast<uint32_t>((uint64_t{frame} << 32) / options.frames);
    Camera camera;
    const CameraError error = make_camera(detail::orbit(azimuth_turns32, kElevationTurns32, kDistanceQ20),
                                          {kSide, kSide, kFieldOfViewTurns32}, camera);
    if (error != CameraError::none) return fail("camera", describe(error));
    std::optional<mps2::OutputFile> picture;
    if (options.write_prefix != nullptr) {
        TextLine path;
        path.text(options.write_prefix).text("-").decimal(frame, kFrameDigits).text(".ppm");
        write_header(picture.emplace(path.c_str()));
    }
    const DrawStripe draw = choose_renderer(options.mode, field.texel_format);
    FrameReport report;
    for (int32_t y = 0; y < kSide; y += kStripeHeight) {
        if (draw_measured(field, camera, draw, y, report) != RenderError::none) return fail("frame", "not complete");
        if (picture) write_stripe(*picture);
    }
    write_report(frame, report);
    return !picture || picture->ok() ? 0 : fail("picture", "it cannot be written");
}

// The field: linked into the program from the file that LUMI_FIRMWARE_FIELD names, or put into PSRAM by the loader.
mps2::LoadedField firmware_field()
{
#ifdef LUMI_FIRMWARE_FIELD
    return {lumi_field_start, static_cast<size_t>(lumi_field_end - lumi_field_start)};
#else
    return mps2::loaded_field(0);
#endif
}

int run(const DemoOptions& options)
{
    const mps2::LoadedField file = firmware_field();
    Field field;
    FieldError error = open_field(file.bytes, file.size, field);
    if (error == FieldError::none && options.verify) error = verify_field(file.bytes, file.size);
    if (error != FieldError::none) return fail("field", describe(error));
    mps2::start_instruction_counter();
    int code = 0;
    for (uint32_t frame = 0; frame < options.frames && code == 0; ++frame) code = draw_frame(field, options, frame);
    return code;
}

}  // namespace
}  // namespace lumi::firmware

int main(int argc, char** argv)
{
    lumi::firmware::DemoOptions options;
    if (lumi::firmware::parse(argc, argv, options)) return lumi::firmware::run(options);
    lumi::mps2::write(lumi::firmware::kUsage);
    return lumi::firmware::kUsageExitCode;
}
