// SPDX-License-Identifier: MIT
#include "filter/drawing.h"

#include <algorithm>
#include <cstdlib>

#include "draw/draw_surface.h"

namespace lumi::filter
{

namespace
{

using tools::Eye;
using tools::FieldFile;
using tools::Picture;

constexpr int kOpaque = 255;
constexpr Rgb8 kBlack = {0, 0, 0}, kWhite = {kOpaque, kOpaque, kOpaque};

Picture drawn(const FieldFile& field, const Eye& eye, const Rgb8& background)
{
    if (field.is_surface()) {
        tools::SurfaceDrawSettings settings;
        settings.background = background;
        return tools::draw_surface(field.surface(), eye, settings);
    }
    tools::DrawSettings settings;
    settings.background = background;
    return tools::draw(field.field(), eye.camera, settings);
}

void put_colours(const Picture& picture, int first, Planes& planes)
{
    for (int k = 0; k < 3; ++k) {
        uint8_t* const plane = planes.plane(first + k);
        for (size_t i = 0; i < planes.size(); ++i) plane[i] = picture.rgb[3 * i + static_cast<size_t>(k)];
    }
}

// A white background adds what nothing covers.
void put_coverage(const Picture& over_black, const Picture& over_white, Planes& planes)
{
    uint8_t* const plane = planes.plane(kCoveragePlane);
    for (size_t i = 0; i < planes.size(); ++i) {
        const int shows = over_white.rgb[3 * i + 1] - over_black.rgb[3 * i + 1];
        plane[i] = static_cast<uint8_t>(std::clamp(kOpaque - shows, 0, kOpaque));
    }
}

// The texture alone: the same field without its view tables and gloss maps, which use their normals.
Picture mean_colours(const SurfaceField& field, const Eye& eye)
{
    SurfaceField plain = field;
    plain.lit_count = 0;
    plain.views = plain.node_colours = plain.gloss = nullptr;
    tools::SurfaceDrawSettings settings;
    settings.mode = SurfaceMode::one_sample;
    return tools::draw_surface(plain, eye, settings);
}

// The smaller of two differences to neighbours: a surface's slope, not the step to what lies behind it.
uint8_t slope_byte(uint32_t before, uint32_t here, uint32_t after)
{
    constexpr int kUnitsPerStep = 8, kFlat = 128;
    const auto step = [](uint32_t from, uint32_t to) { return static_cast<int>(to) - static_cast<int>(from); };
    int slope = before == detail::kEmptyDepth ? 0 : step(before, here);
    if (after != detail::kEmptyDepth &&
        (before == detail::kEmptyDepth || std::abs(step(here, after)) < std::abs(slope)))
        slope = step(here, after);
    return static_cast<uint8_t>(std::clamp(kFlat + slope / kUnitsPerStep, 1, kOpaque));
}

void put_depths(const tools::Plane<uint16_t>& depths, int first, Planes& planes)
{
    const int width = depths.width_px, height = depths.height_px;
    const auto at = [&](int x, int y) -> uint32_t {
        return x < 0 || y < 0 || x >= width || y >= height ? detail::kEmptyDepth : depths.at(x, y);
    };
    size_t i = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x, ++i) {
            const uint32_t here = at(x, y);
            if (here == detail::kEmptyDepth) continue;  // zeros
            planes.plane(first)[i] = static_cast<uint8_t>(here >> 8);
            planes.plane(first + 1)[i] = slope_byte(at(x - 1, y), here, at(x + 1, y));
            planes.plane(first + 2)[i] = slope_byte(at(x, y - 1), here, at(x, y + 1));
        }
}

}  // namespace

uint32_t input_planes(const FieldFile& field)
{
    return field.is_surface() ? kSurfacePlanes : kPicturePlanes;
}

Planes drawn_planes(const FieldFile& field, const Eye& eye)
{
    Planes planes(static_cast<int>(input_planes(field)), eye.image.width_px, eye.image.height_px);
    const Picture picture = drawn(field, eye, kBlack);
    put_colours(picture, 0, planes);
    put_coverage(picture, drawn(field, eye, kWhite), planes);
    if (field.is_surface()) {
        put_colours(mean_colours(field.surface(), eye), kPicturePlanes, planes);
        put_depths(tools::surface_depths(field.surface(), eye), kPicturePlanes + 3, planes);
    }
    return planes;
}

Planes reference_planes(const quality::Reference& reference)
{
    Planes planes(kPicturePlanes, reference.picture.width_px, reference.picture.height_px);
    put_colours(reference.picture, 0, planes);
    std::copy(reference.mask.values.begin(), reference.mask.values.end(), planes.plane(kCoveragePlane));
    return planes;
}

Picture over(const Planes& planes, const Rgb8& background)
{
    Picture picture(planes.width_px, planes.height_px);
    const uint8_t behind[] = {background.r, background.g, background.b};
    const uint8_t* const coverage = planes.plane(kCoveragePlane);
    for (size_t i = 0; i < planes.size(); ++i)
        for (size_t k = 0; k < 3; ++k)
            picture.rgb[3 * i + k] = tools::over(planes.plane(static_cast<int>(k))[i], coverage[i], behind[k]);
    return picture;
}

}  // namespace lumi::filter
