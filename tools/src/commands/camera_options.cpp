// SPDX-License-Identifier: MIT
#include "commands/camera_options.h"

#include "lumi/camera.h"
#include "program/option_checks.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

void set_size(const std::string& text, ViewOptions& options)
{
    const auto size = parse_size(text);
    if (!size || size->width_px > kMaxImageSide || size->height_px > kMaxImageSide)
        throw CLI::ValidationError("--size", "takes WIDTHxHEIGHT such as 240x240, each 1 to " +
                                                 std::to_string(kMaxImageSide) + ", not \"" + text + "\"");
    options.width_px = size->width_px;
    options.height_px = size->height_px;
}

// `radii` says which distances `is_near_enough` takes.
template <class Check>
void set_orbit(const std::string& text, ViewOptions& options, const char* radii, Check is_near_enough)
{
    constexpr double kPole = 90;
    const auto orbit = parse_triple(text);
    if (!orbit || std::abs((*orbit)[1]) > kPole || !is_near_enough((*orbit)[2]))
        throw CLI::ValidationError("--orbit",
                                   "takes AZIMUTH,ELEVATION,DISTANCE such as 30,20,3: degrees, degrees from -90 "
                                   "to 90, radii " +
                                       std::string(radii) + "; not \"" + text + "\"");
    options.orbit = {(*orbit)[0], (*orbit)[1], (*orbit)[2], options.orbit.roll_deg};
}

void set_picture_orbit(const std::string& text, ViewOptions& options)
{
    constexpr double kFarthest = kMaxEyeDistanceQ20 / kOneQ20;
    set_orbit(text, options, "above 1 and up to 2047", [](double radii) { return radii > 1 && radii <= kFarthest; });
}

// The limits of the page's eye: platform/wasm/viewer.cpp.
void set_page_orbit(const std::string& text, ViewOptions& options)
{
    constexpr double kNearest = 1.25, kFarthest = 8;
    set_orbit(text, options, "from 1.25 to 8", [](double radii) { return radii >= kNearest && radii <= kFarthest; });
}

void set_background(const std::string& text, ViewOptions& options)
{
    if (text == "gradient") {
        options.background = {Background::Kind::gradient, {}};
    } else if (text == "none") {
        options.background = {Background::Kind::none, {}};
    } else if (const auto colour = parse_colour(text == "black" ? "000000" : text)) {
        options.background = {Background::Kind::colour, *colour};
    } else {
        throw CLI::ValidationError(
            "--background",
            "takes gradient, black, none, or six hexadecimal digits RRGGBB such as ff8000, not \"" + text + "\"");
    }
}

// An option whose text a setter turns into a field of `options`.
void add(CLI::App& command, const std::string& name, void (*set)(const std::string&, ViewOptions&),
         ViewOptions& options, const std::string& type, const std::string& description)
{
    command
        .add_option_function<std::string>(
            name, [set, &options](const std::string& text) { set(text, options); }, description)
        ->type_name(type);
}

void add_orbit(CLI::App& command, ViewOptions& options, void (*set)(const std::string&, ViewOptions&))
{
    add(command, "--orbit", set, options, "AZ,EL,DIST",
        "Where the eye is: azimuth and elevation in degrees, distance from the centre in radii of the sphere "
        "[30,20,3]");
}

}  // namespace

void add_start_options(CLI::App& command, ViewOptions& options)
{
    add_orbit(command, options, set_page_orbit);
    add(command, "--background", set_background, options, "gradient|black|RRGGBB",
        "What lies behind the object [gradient, a dark grey one; black with --reference]");
}

void add_camera_options(CLI::App& command, ViewOptions& options, const std::string& background)
{
    set_background(background, options);
    constexpr double kMinFovDeg = 1, kMaxFovDeg = 120, kMostRollDeg = 360;
    add(command, "--size", set_size, options, "WxH", "Size of a view in pixels [240x240]");
    add_orbit(command, options, set_picture_orbit);
    command
        .add_option("--fov", options.fov_deg,
                    "Field of view over the longer side in degrees [so that the "
                    "sphere fills the frame]")
        ->type_name("DEG")
        ->check(number(kMinFovDeg, kMaxFovDeg));
    command
        .add_option("--roll", options.orbit.roll_deg,
                    "Turn the picture clockwise, as for a display that is mounted askew [0]")
        ->type_name("DEG")
        ->check(number(-kMostRollDeg, kMostRollDeg));
    command
        .add_option("--turntable", options.turntable,
                    "Draw COUNT views around the vertical axis: OUT-000.png, OUT-001.png, ... and OUT-sheet.png, or "
                    "one turning picture, OUT.webp")
        ->type_name("COUNT")
        ->check(whole_number(1, kMaxTurntable));
    add(command, "--background", set_background, options, "gradient|black|none|RRGGBB",
        "What lies behind the object: a dark grey gradient, a colour, or nothing, which is alpha [" + background + "]");
    command
        .add_option("--pose", options.pose,
                    "Where the eye is, by a text file in place of --orbit: a rigid 4x4 matrix row by row, from the "
                    "camera's axes (it looks along -z, y up, as in OpenGL) to those of the sphere (radius 1, z up)")
        ->type_name("POSE.txt")
        ->excludes("--orbit")
        ->excludes("--roll")
        ->excludes("--turntable");
    command.add_option("--over", options.photo, "Draw over this photograph, in its size")
        ->type_name("PHOTO.png")
        ->excludes("--size")
        ->excludes("--turntable")
        ->excludes("--background");
}

void add_picture_output(CLI::App& command, std::string& output, const std::string& type,
                        std::string (*wrong_name)(const std::string&))
{
    command.add_option("-o,--output", output, "Picture to write")->type_name(type)->check(wrong_name)->required();
}

void add_pace_option(CLI::App& command, std::vector<planner::Pace>& paces, const std::string& description,
                     bool takes_two)
{
    const auto set = [&paces, takes_two](const std::string& word) {
        const auto pace = planner::parse_pace(word);
        if (!pace || (pace->cores != 1 && !takes_two))
            throw CLI::ValidationError(
                "--for",
                std::string("takes parts with or without a frame rate, such as rp2040 or ") +
                    (takes_two ? "rp2040@30fps, or rp2040x2@30fps for both cores, " : "rp2040@30fps, of one core, ") +
                    "with " + planner::chip_names() + ", not \"" + word + "\"");
        paces.push_back(*pace);
    };
    add_list(command, "--for", set, description + ": " + planner::chip_names())->type_name("PART[@RATEfps],...");
}

void add_screen_options(CLI::App& command, host::ScreenSize& screen)
{
    const auto set_size = [&screen](const std::string& text) {
        const auto size = parse_size(text);
        if (!size || size->width_px > kMaxImageSide || size->height_px > kMaxImageSide)
            throw CLI::ValidationError("--screen", "takes WIDTHxHEIGHT such as 466x466, each 1 to " +
                                                       std::to_string(kMaxImageSide) + ", not \"" + text + "\"");
        screen.width_px = size->width_px;
        screen.height_px = size->height_px;
    };
    command
        .add_option_function<std::string>("--screen", set_size,
                                          "Screen of the device, for RAM and frame rates [240x240]")
        ->type_name("WxH");
    command.add_option("--rows", screen.rows, "Rows of a stripe, which the device draws at once")
        ->type_name("N")
        ->check(whole_number(1, kMaxImageSide))
        ->capture_default_str();
}

}  // namespace lumi::tools
