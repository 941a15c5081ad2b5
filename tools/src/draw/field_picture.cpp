// SPDX-License-Identifier: MIT
#include "draw/field_picture.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "image/picture.h"
#include "lumi/chord/texel.h"

namespace lumi::tools
{

namespace
{

constexpr Rgb8 kEmpty = {32, 36, 40};

// A patch's rectangle in the picture, in texels.
struct Shelved {
    detail::SurfacePatch patch;
    bool is_see_through;
    int x = 0, y = 0;

    int columns() const { return static_cast<int>(patch.columns); }
    int rows() const { return static_cast<int>(patch.rows); }
};

struct Shelves {
    std::vector<Shelved> patches;
    int width = 0, height = 0;
};

constexpr int kGap = 1;  // between patches, so that one sees each

std::vector<Shelved> patches_of(const SurfaceField& field)
{
    std::vector<Shelved> patches;
    const uint32_t count = field.patch_count + field.see_through_count;
    for (uint32_t k = 0; k < count; ++k) patches.push_back({detail::surface_patch(field, k), k >= field.patch_count});
    std::stable_sort(patches.begin(), patches.end(), [](const Shelved& a, const Shelved& b) {
        if (a.is_see_through != b.is_see_through) return b.is_see_through;
        return a.rows() != b.rows() ? a.rows() > b.rows() : a.columns() > b.columns();
    });
    return patches;
}

int square_side(const std::vector<Shelved>& patches)
{
    double area = 0;
    int widest = 0;
    for (const Shelved& shelved : patches) {
        area += (shelved.columns() + kGap) * (shelved.rows() + kGap);
        widest = std::max(widest, shelved.columns());
    }
    return std::max(static_cast<int>(std::ceil(std::sqrt(area))), widest + 2 * kGap);
}

// Each shelf is as high as its first patch. See-through patches begin a shelf of their own.
Shelves shelves_of(const SurfaceField& field)
{
    Shelves shelves = {patches_of(field)};
    shelves.width = square_side(shelves.patches);
    int x = kGap, y = kGap, shelf = 0;
    bool is_see_through = false;
    for (Shelved& shelved : shelves.patches) {
        if (x + shelved.columns() + kGap > shelves.width || shelved.is_see_through != is_see_through) {
            x = kGap;
            y += shelf + kGap;
            shelf = 0;
            is_see_through = shelved.is_see_through;
        }
        shelf = std::max(shelf, shelved.rows());
        shelved.x = x;
        shelved.y = y;
        x += shelved.columns() + kGap;
    }
    shelves.height = y + shelf + kGap;
    return shelves;
}

// Whether a triangle of the patch covers some of texel (i, j).
bool is_used(const detail::SurfacePatch& patch, uint32_t i, uint32_t j)
{
    const bool has_both = patch.corner[3] != detail::format::kNoVertex;
    return has_both || i * patch.rows + j * patch.columns < patch.columns * patch.rows;
}

Rgb8 see_through_colour(const uint8_t* entry, uint32_t i, uint32_t j)
{
    constexpr uint8_t kLight = 200, kDark = 120;
    constexpr uint32_t kSquareShift = 1;  // two texels
    const uint8_t behind = ((i >> kSquareShift) + (j >> kSquareShift)) % 2 == 0 ? kLight : kDark;
    const auto channel = [&](int k) { return over(entry[k], static_cast<uint8_t>(UINT8_MAX - entry[k + 3]), behind); };
    return {channel(0), channel(1), channel(2)};
}

Rgb8 colour_of(const SurfaceField& field, const Shelved& shelved, uint32_t i, uint32_t j)
{
    namespace at = detail::format::see_through;
    const uint32_t texel = field.texels[shelved.patch.texels + j * shelved.patch.columns + i];
    if (shelved.is_see_through)
        return see_through_colour(field.see_through + at::kPaletteAt + texel * at::kEntryBytes, i, j);
    const uint8_t* entry = field.palette + 3 * texel;
    return {entry[0], entry[1], entry[2]};
}

void put(const Rgb8& colour, int x, int y, int size, Picture& picture)
{
    paste(Picture(size, size, colour), x * size, y * size, picture);
}

void put(const SurfaceField& field, const Shelved& shelved, int size, Picture& picture)
{
    for (uint32_t j = 0; j < shelved.patch.rows; ++j)
        for (uint32_t i = 0; i < shelved.patch.columns; ++i)
            if (is_used(shelved.patch, i, j))
                put(colour_of(field, shelved, i, j), shelved.x + static_cast<int>(i), shelved.y + static_cast<int>(j),
                    size, picture);
}

Picture picture_of(const SurfaceField& field)
{
    constexpr int kWidth = 1200, kLargestTexel = 16;
    const Shelves shelves = shelves_of(field);
    const int size = std::clamp(kWidth / shelves.width, 1, kLargestTexel);
    Picture picture(shelves.width * size, shelves.height * size, kEmpty);
    for (const Shelved& shelved : shelves.patches) put(field, shelved, size, picture);
    return picture;
}

// A map of the sphere on a cylinder around it keeps areas. This is the direction at the middle of each pixel, as a
// point of the lattice.
struct Map {
    int width_px, height_px;
    std::vector<uint32_t> directions;
};

Vec3q30 direction_of(double longitude_turns, double z)
{
    constexpr double kPi = 3.14159265358979323846, kOneQ30 = 1 << 30;
    const double r = std::sqrt(1 - z * z), angle = 2 * kPi * longitude_turns;
    const auto q30 = [](double v) { return static_cast<int32_t>(std::lround(v * kOneQ30)); };
    return {q30(r * std::cos(angle)), q30(r * std::sin(angle)), q30(z)};
}

Map map_of(const detail::Lattice& directions)
{
    constexpr double kPi = 3.14159265358979323846;  // the cylinder's width by its height
    constexpr double kHighest = 256;
    const double height = std::clamp(std::round(std::sqrt(directions.size() / kPi)), 1.0, kHighest);
    Map map = {static_cast<int>(std::ceil(kPi * height)), static_cast<int>(height), {}};
    for (int y = 0; y < map.height_px; ++y)
        for (int x = 0; x < map.width_px; ++x)
            map.directions.push_back(
                detail::nearest(directions, direction_of((x + 0.5) / map.width_px, 1 - 2 * (y + 0.5) / map.height_px)));
    return map;
}

template <class Texel>
Picture seen_from(const Field& field, uint32_t origin, const Map& map)
{
    Picture picture(map.width_px, map.height_px);
    const uint8_t* row = field.row(origin);
    for (size_t k = 0; k < map.directions.size(); ++k) {
        const detail::Rgba8 c = Texel::load(field, row, map.directions[k]);
        uint8_t* pixel = picture.rgb.data() + 3 * k;
        pixel[0] = over(c.r, c.a, kEmpty.r);
        pixel[1] = over(c.g, c.a, kEmpty.g);
        pixel[2] = over(c.b, c.a, kEmpty.b);
    }
    return picture;
}

Picture picture_of(const Field& field)
{
    constexpr Rgb8 kGround = {0, 0, 0};
    const Map map = map_of(field.directions);
    const uint32_t count = std::min(field.used_origins, kMostOrigins);
    ContactSheet sheet(static_cast<int>(count), map.width_px, map.height_px, kGround);
    for (uint32_t k = 0; k < count; ++k) {
        const auto origin = static_cast<uint32_t>(uint64_t{k} * field.used_origins / count);
        sheet.add(detail::with_texel(field.texel_format,
                                     [&](auto texel) { return seen_from<decltype(texel)>(field, origin, map); }));
    }
    return sheet.picture();
}

}  // namespace

Picture picture_of(const FieldFile& file)
{
    return file.is_surface() ? picture_of(file.surface()) : picture_of(file.field());
}

}  // namespace lumi::tools
