// SPDX-License-Identifier: MIT
// lumi-lab surface-extremes: how far pictures of surface fields are from exact ones at the ends of what views can be.
// The exact ones (twin/surface_picture.h) read the file by themselves, and follow rays to every triangle in double
// precision; of core they take the numbers of pose and image, and the places of a view table's nodes.
#include <algorithm>
#include <cmath>
#include <memory>

#include "draw/draw_surface.h"
#include "files/field_file.h"
#include "lumi/bench/surface_modes.h"
#include "lumi/twin/surface_picture.h"
#include "measure/commands.h"
#include "measure/extreme_views.h"
#include "terminal/failure.h"

namespace lumi::lab
{

namespace
{

using Json = nlohmann::ordered_json;

constexpr Rgb8 kNothing = {16, 16, 16};

// A field's palette becomes this, and with it all colours.
enum class Palette : uint8_t { own, black, white };

struct Case {
    const char* name;
    std::vector<View> views;
    Palette palette = Palette::own;
};

std::vector<Case> cases()
{
    const auto at = [](double azimuth, double elevation, double distance) {
        return View{from(azimuth, elevation, distance), kUsual};
    };
    return {
        {"eye at 3 radii", around(3)},
        {"eye at 1.000001 radii", around(1.000001, {96, 96, 90 * kDegree})},
        {"eye at 1.01 radii", around(1.01, {96, 96, 90 * kDegree})},
        {"eye at 2046 radii", around(2046, {1024, 1024, kMinFovTurns32})},
        {"field of view of 1°", around(3, {96, 96, kMinFovTurns32})},
        {"field of view of 120°", around(1.2, {200, 120, kMaxFovTurns32})},
        {"image of 1 × 1", around(3, {1, 1, 40 * kDegree})},
        {"image of 8192 × 1", around(3, {8192, 1, 40 * kDegree})},
        {"image of 1 × 8192", around(3, {1, 8192, 40 * kDegree})},
        {"down the poles", {at(61, 90, 3), at(10, -90, 3), at(61, 90, 1.1), at(10, -90, 1.1)}},
        {"rolled", {{rolled(from(40, 30, 2), 33.0), kUsual}, {rolled(from(200, -60, 3), 117.0), kUsual}}},
        {"stereo pair, shifted lens", stereo()},
        {"all colours 0", around(3), Palette::black},
        {"all colours 255", around(3), Palette::white},
    };
}

// The field's bytes with another palette.
std::vector<uint8_t> recoloured(const tools::FieldFile& file, Palette palette)
{
    std::vector<uint8_t> bytes(file.bytes(), file.bytes() + file.size());
    if (palette != Palette::own)
        std::fill_n(bytes.begin() + (file.surface().palette - file.bytes()), 3 * detail::format::kPaletteEntries,
                    static_cast<uint8_t>(palette == Palette::white ? 255 : 0));
    return bytes;
}

// The range of what the exact picture shows in a pixel and the eight around it.
struct Around {
    double least_covered = 1, most_covered = 0;
    std::array<double, 3> least{255, 255, 255}, most{};

    Around(const twin::SurfacePicture& exact, int32_t x, int32_t y)
    {
        for (int32_t v = std::max(y - 1, 0); v <= std::min(y + 1, exact.height_px - 1); ++v)
            for (int32_t u = std::max(x - 1, 0); u <= std::min(x + 1, exact.width_px - 1); ++u) {
                const auto k = static_cast<size_t>(v * exact.width_px + u);
                least_covered = std::min(least_covered, exact.coverage[k]);
                most_covered = std::max(most_covered, exact.coverage[k]);
                const double levels[] = {exact.colours[k].r, exact.colours[k].g, exact.colours[k].b};
                for (size_t c = 0; c < 3; ++c) {
                    least[c] = std::min(least[c], levels[c]);
                    most[c] = std::max(most[c], levels[c]);
                }
            }
    }
    // How many levels a colour lies beside all that shows here.
    double beyond(const Rgb8& colour) const
    {
        const double levels[] = {1.0 * colour.r, 1.0 * colour.g, 1.0 * colour.b};
        double worst = 0;
        for (size_t c = 0; c < 3; ++c) worst = std::max({worst, least[c] - levels[c], levels[c] - most[c]});
        return worst;
    }
};

struct Result {
    uint32_t pixels = 0, missing = 0, added = 0;
    double worst = 0, squares = 0, beyond = 0;

    void add(const tools::Picture& drawn, const twin::SurfacePicture& exact)
    {
        for (int32_t y = 0; y < exact.height_px; ++y)
            for (int32_t x = 0; x < exact.width_px; ++x) add(PixelRgb888::load(drawn.pixel(x, y)), exact, x, y);
    }
    Json json() const
    {
        const auto rounded = [](double v) { return std::round(v * 100) / 100; };
        return {{"pixels", pixels},        {"missing", missing},
                {"added", added},          {"rms", rounded(std::sqrt(squares / std::max(3.0 * pixels, 1.0)))},
                {"worst", rounded(worst)}, {"beyond", rounded(beyond)}};
    }

private:
    void add(const Rgb8& colour, const twin::SurfacePicture& exact, int32_t x, int32_t y)
    {
        const Around around(exact, x, y);
        const bool is_background = colour.r == kNothing.r && colour.g == kNothing.g && colour.b == kNothing.b;
        if (!is_background && around.most_covered == 0) ++added;
        if (around.least_covered < 1) return;
        ++pixels;
        if (is_background && around.beyond(colour) > 1) ++missing;
        const twin::Colour& truth = exact.colours[static_cast<size_t>(y * exact.width_px + x)];
        for (const double error : {colour.r - truth.r, colour.g - truth.g, colour.b - truth.b}) {
            squares += error * error;
            worst = std::max(worst, std::abs(error));
        }
        beyond = std::max(beyond, around.beyond(colour));
    }
};

Json judged(const tools::FieldFile& file, const Case& of)
{
    const std::vector<uint8_t> bytes = recoloured(file, of.palette);
    SurfaceField field;
    if (open_surface<SurfaceFeatures::all>(bytes.data(), bytes.size(), field) != FieldError::none)
        throw std::logic_error("a field of the lab cannot be opened");
    Json row = {{"case", of.name}};
    for (const bench::NamedSurfaceMode& mode : bench::kSurfaceModes) {
        Result result;
        for (const View& view : of.views) {
            tools::leave_if_interrupted();
            tools::Eye eye = {view.pose, view.image, {}};
            if (make_camera(view.pose, view.image, eye.camera) != CameraError::none)
                throw std::logic_error("a view of the lab has no camera");
            const twin::SurfaceDrawing drawing = {mode.mode == SurfaceMode::two_by_two ? 2 : 1};
            result.add(tools::draw_surface(field, eye, {mode.mode, tools::DisplayFormat::rgb888, kNothing}),
                       twin::draw_surface(bytes.data(), view.pose, view.image, drawing, kNothing));
        }
        row[mode.name] = result.json();
    }
    return row;
}

}  // namespace

void add_surface_extremes(CLI::App& lab)
{
    auto path = std::make_shared<std::string>();
    CLI::App* command = lab.add_subcommand(
        "surface-extremes", "Compare pictures of a surface field with double precision at the ends of views");
    command->add_option("FIELD", *path, "An opaque surface field")->required();
    command->callback([path] {
        const tools::FieldFile file(*path);
        file.require_intact();
        if (!file.is_surface() || file.surface().see_through_count != 0)
            throw CLI::ValidationError("FIELD", "takes an opaque surface field");
        Json rows = Json::array();
        for (const Case& of : cases()) rows.push_back(judged(file, of));
        print(rows);
    });
}

}  // namespace lumi::lab
