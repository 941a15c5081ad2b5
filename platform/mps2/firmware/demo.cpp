// SPDX-License-Identifier: MIT
// lumi_demo_firmware: draws a turn around the object in its field and reports, frame by frame over semihosting, the
// picture's CRC, what drawing cost, and the picture itself when asked. See kUsage.
#include <cstring>

#include "lumi/color.h"
#include "lumi/mps2/board.h"
#include "lumi/mps2/meters.h"
#include "measured_frame.h"
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

constexpr uint32_t kBlockPixels = 256;  // a call of semihosting costs far more than its bytes
constexpr uint32_t kBytesPerRgb565 = 2;
constexpr uint32_t kBytesPerRgb888 = 3;

constexpr uint32_t kMaxFrames = 999;
constexpr const char* kUsage =
    "usage: [--frames 1..999] [--mode nearest|linear|paper] [--verify] [--write PREFIX]\n"
    "The field is linked into the program, or loaded to the start of the board's PSRAM.\n";

struct DemoOptions {
    uint32_t frames = 1;  // frames in one turn around the object; 1 .. kMaxFrames
    Mode mode = Mode::linear;
    bool verify = false;                 // check the CRC of every section first
    const char* write_prefix = nullptr;  // write frame k to "<prefix>-<k>.ppm" on the host
};

bool parse_count(const char* text, uint32_t& out)
{
    uint32_t value = 0;
    for (const char* digit = text; *digit != '\0'; ++digit) {
        if (*digit < '0' || *digit > '9' || value > kMaxFrames) return false;
        value = value * 10 + static_cast<uint32_t>(*digit - '0');
    }
    out = value;
    return value >= 1 && value <= kMaxFrames;
}

bool parse_mode(const char* text, Mode& out)
{
    constexpr const char* kNames[] = {"nearest", "linear", "paper"};
    for (uint8_t i = 0; i < sizeof(kNames) / sizeof(kNames[0]); ++i) {
        if (std::strcmp(text, kNames[i]) == 0) {
            out = static_cast<Mode>(i);
            return true;
        }
    }
    return false;
}

// An option with a value; false if it is unknown or the value is wrong.
bool parse_pair(const char* name, const char* value, DemoOptions& options)
{
    if (std::strcmp(name, "--frames") == 0) return parse_count(value, options.frames);
    if (std::strcmp(name, "--mode") == 0) return parse_mode(value, options.mode);
    if (std::strcmp(name, "--write") == 0) {
        options.write_prefix = value;
        return true;
    }
    return false;
}

// Fills `out`; on failure returns the argument that is wrong, else null. argv[0] is skipped.
const char* parse(int argc, char** argv, DemoOptions& out)
{
    DemoOptions options;
    for (int i = 1; i < argc; ++i)
        if (std::strcmp(argv[i], "--verify") == 0)
            options.verify = true;
        else if (i + 1 < argc && parse_pair(argv[i], argv[i + 1], options))
            ++i;
        else
            return argv[i];
    out = options;
    return nullptr;
}

void unpack(const uint8_t* rgb565, uint8_t* rgb888)
{
    const Rgb8 colour = detail::unpack_rgb565(static_cast<uint16_t>(rgb565[0] | rgb565[1] << 8));
    rgb888[0] = colour.r;
    rgb888[1] = colour.g;
    rgb888[2] = colour.b;
}

// This is a binary PPM picture (P6) on the host, written stripe by stripe from the panel's own RGB565 pixels.
class PpmFile
{
public:
    PpmFile(const char* path, uint32_t width_px, uint32_t height_px);

    // Appends pixels (RGB565, two bytes each in the CPU's byte order); false after a failure.
    bool append_rgb565(const uint8_t* pixels, uint32_t bytes);
    bool ok() const { return file_.ok(); }

private:
    mps2::OutputFile file_;
};

PpmFile::PpmFile(const char* path, uint32_t width_px, uint32_t height_px) : file_(path)
{
    TextLine header;
    header.text("P6\n").decimal(width_px).text(" ").decimal(height_px).text("\n255\n");
    file_.write(header.c_str(), std::strlen(header.c_str()));
}

bool PpmFile::append_rgb565(const uint8_t* pixels, uint32_t bytes)
{
    uint8_t block[kBlockPixels * kBytesPerRgb888];
    const uint8_t* end = pixels + bytes;
    while (pixels < end) {
        uint32_t filled = 0;
        for (; filled < sizeof(block) && pixels < end; filled += kBytesPerRgb888, pixels += kBytesPerRgb565)
            unpack(pixels, block + filled);
        file_.write(block, filled);
    }
    return file_.ok();
}

int fail(const char* what, const char* why)
{
    TextLine line;
    mps2::write(line.text("error: ").text(what).text(": ").text(why).text("\n").c_str());
    return kFailureExitCode;
}

bool discard(void*, const uint8_t*, uint32_t)
{
    return true;
}

bool append_to_picture(void* picture, const uint8_t* pixels, uint32_t bytes)
{
    return static_cast<PpmFile*>(picture)->append_rgb565(pixels, bytes);
}

FrameReport draw_to_file(const Field& field, const Camera& camera, DrawStripe draw, const char* path)
{
    PpmFile picture(path, kFrameWidth, kFrameHeight);
    return draw_measured_frame(field, camera, draw, {append_to_picture, &picture});
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

int draw_one(const Field& field, const DemoOptions& options, uint32_t frame)
{
    const uint32_t azimuth_turns32 = static_cast<uint32_t>((uint64_t{frame} << 32) / options.frames);
    Camera camera;
    const CameraError error = make_camera(detail::orbit(azimuth_turns32, kElevationTurns32, kDistanceQ20),
                                          {kFrameWidth, kFrameHeight, kFieldOfViewTurns32}, camera);
    if (error != CameraError::none) return fail("camera", describe(error));
    const DrawStripe draw = choose_renderer(options.mode, field.texel_format);
    FrameReport report;
    if (options.write_prefix != nullptr) {
        TextLine path;
        path.text(options.write_prefix).text("-").decimal(frame, kFrameDigits).text(".ppm");
        report = draw_to_file(field, camera, draw, path.c_str());
    } else {
        report = draw_measured_frame(field, camera, draw, {discard, nullptr});
    }
    write_report(frame, report);
    return report.complete ? 0 : fail("frame", "not complete; can the picture's file be written?");
}

// The field: linked into the program from the file that LUMI_FIRMWARE_FIELD names, or put into PSRAM by the loader.
#ifdef LUMI_FIRMWARE_FIELD
mps2::LoadedField firmware_field()
{
    return {lumi_field_start, static_cast<size_t>(lumi_field_end - lumi_field_start)};
}
#else
mps2::LoadedField firmware_field()
{
    return mps2::loaded_field(0);
}
#endif

int run(const DemoOptions& options)
{
    const mps2::LoadedField file = firmware_field();
    Field field;
    FieldError error = open_field(file.bytes, file.size, field);
    if (error == FieldError::none && options.verify) error = verify_field(file.bytes, file.size);
    if (error != FieldError::none) return fail("field", describe(error));
    mps2::start_instruction_counter();
    int code = 0;
    for (uint32_t frame = 0; frame < options.frames && code == 0; ++frame) code = draw_one(field, options, frame);
    return code;
}

}  // namespace
}  // namespace lumi::firmware

int main(int argc, char** argv)
{
    using namespace lumi::firmware;
    DemoOptions options;
    const char* wrong = parse(argc, argv, options);
    if (wrong != nullptr) {
        fail("option", wrong);
        lumi::mps2::write(kUsage);
        return kUsageExitCode;
    }
    return run(options);
}
