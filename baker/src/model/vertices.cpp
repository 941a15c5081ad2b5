// SPDX-License-Identifier: MIT
#include "model/vertices.h"

#include <algorithm>
#include <cmath>

#include "image/tone.h"
#include "lumi/baker/scene.h"

namespace lumi::baker
{

namespace
{

// How many times farther from the origin than they are large: below it binary32 keeps 20 bits of the shape.
constexpr double kFar = 16;

}  // namespace

CentredPositions centred(const std::vector<Point>& points)
{
    CentredPositions result;
    if (points.empty()) return result;
    Point low = points[0], high = points[0], middle{};
    for (const Point& p : points) {
        for (size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], p[k]);
            high[k] = std::max(high[k], p[k]);
        }
    }
    double size = 0, distance = 0;
    for (size_t k = 0; k < 3; ++k) {
        middle[k] = (low[k] + high[k]) / 2;
        size = std::max(size, high[k] - low[k]);
        distance = std::max(distance, std::abs(middle[k]));
    }
    if (distance > kFar * size) result.origin = middle;
    const Point& o = result.origin;
    result.positions.reserve(points.size());
    for (const Point& p : points) {
        result.positions.push_back(
            {static_cast<float>(p[0] - o[0]), static_cast<float>(p[1] - o[1]), static_cast<float>(p[2] - o[2])});
    }
    return result;
}

namespace
{

constexpr int kBlock = 2, kFineBlock = 4;  // pixels a side

// The colour that lies linearly at the shares of the ways to the second and third corner.
Rgb colour_at(const CornerColours& c, float to_second, float to_third)
{
    return c[0] + (c[1] - c[0]) * to_second + (c[2] - c[0]) * to_third;
}

bool is_in_range(const Rgb& c)
{
    constexpr float kLow = -0.05f, kHigh = 1.05f;
    return std::min({c.r, c.g, c.b}) >= kLow && std::max({c.r, c.g, c.b}) <= kHigh;
}

void put(Texture& picture, int x, int y, const Rgb& colour)
{
    uint8_t* pixel =
        &picture.rgb[3 * (static_cast<size_t>(y) * static_cast<size_t>(picture.width) + static_cast<size_t>(x))];
    const Rgb8 encoded = srgb_encode(colour);
    pixel[0] = encoded.r;
    pixel[1] = encoded.g;
    pixel[2] = encoded.b;
}

// The middle of a pixel, where filtering shows its colour alone.
Vec2 middle_of(const Texture& picture, int x, int y)
{
    return {(static_cast<float>(x) + 0.5f) / static_cast<float>(picture.width),
            1 - (static_cast<float>(y) + 0.5f) / static_cast<float>(picture.height)};
}

}  // namespace

Texture picture_of_corners(Mesh& mesh, size_t first, const std::vector<CornerColours>& colours)
{
    const bool simple = std::all_of(colours.begin(), colours.end(),
                                    [](const CornerColours& c) { return is_in_range(colour_at(c, 1, 1)); });
    const int block = simple ? kBlock : kFineBlock, last = block - 1;
    const size_t columns = static_cast<size_t>(std::ceil(std::sqrt(static_cast<double>(colours.size()))));
    const size_t rows = (colours.size() + columns - 1) / columns;
    if (columns > static_cast<size_t>(kMaxPictureSide / block))
        throw SceneError("the model has too many triangles with colours at vertices; simplify it");
    Texture picture{block * static_cast<int>(columns), block * static_cast<int>(rows), {}, true};
    picture.rgb.resize(3 * static_cast<size_t>(picture.width) * static_cast<size_t>(picture.height));
    for (size_t k = 0; k < colours.size(); ++k) {
        const int x = block * static_cast<int>(k % columns), y = block * static_cast<int>(k / columns);
        for (int i = 0; i < block * block; ++i) {
            const float to_second = static_cast<float>(i % block) / static_cast<float>(last);
            const float to_third = static_cast<float>(i / block) / static_cast<float>(last);
            put(picture, x + i % block, y + i / block, colour_at(colours[k], to_second, to_third));
        }
        const int32_t uv = static_cast<int32_t>(mesh.uvs.size());
        for (const Vec2& corner :
             {middle_of(picture, x, y), middle_of(picture, x + last, y), middle_of(picture, x, y + last)})
            mesh.uvs.push_back(corner);
        mesh.mapping[first + k] = {uv, uv + 1, uv + 2};
    }
    return picture;
}

}  // namespace lumi::baker
