// SPDX-License-Identifier: MIT
#include "lumi/reference/guided_shading.h"

#include <algorithm>
#include <optional>

#include "lumi/guided/guided_chart.h"

namespace lumi::reference
{
namespace
{

constexpr double kFrameOne = 16384;        // ChartFrame is Q14
constexpr double kOcclusionPerUnit = 128;  // depth bytes a radius
constexpr uint8_t kHidesNothing = 255;
constexpr double kFullDifference = 0.25;  // below this sum of weights a difference fades

uint32_t u16_at(const uint8_t* p)
{
    return p[0] | static_cast<uint32_t>(p[1]) << 8;
}
uint32_t u32_at(const uint8_t* p)
{
    return u16_at(p) | u16_at(p + 2) << 16;
}
Vec3 decoded_q14(const int16_t (&v)[3])
{
    return {v[0] / kFrameOne, v[1] / kFrameOne, v[2] / kFrameOne};
}

Colour level_colour(uint8_t r, uint8_t g, uint8_t b)
{
    return {static_cast<double>(r), static_cast<double>(g), static_cast<double>(b)};
}

// Grid point to the number of its texel, as guided_format.h says under `chart`.
std::optional<uint32_t> texel_number(const ChartTable& table, uint32_t origin, int64_t u, int64_t v)
{
    const uint8_t* entry = table.directory + size_t{origin} * format::chart::kEntryBytes;
    const int64_t row = v - u16_at(entry + format::chart::kFirstRowAt);
    if (row < 0 || row >= u16_at(entry + format::chart::kRowCountAt)) return std::nullopt;
    const uint64_t place = u32_at(entry + format::chart::kRowBaseAt) + static_cast<uint64_t>(row);
    const uint32_t offset = static_cast<uint32_t>(u16_at(table.rows + 2 * place) + u) & 0xFFFF;
    const uint64_t number = uint64_t{u32_at(entry + format::chart::kTexelBaseAt)} + offset;
    if (number >= table.texel_count) return std::nullopt;
    return static_cast<uint32_t>(number);
}

// The chart colour of a grid point, a difference where there is a mean; nothing if it is missing.
std::optional<Colour> texel_colour(const GuidedField& field, uint32_t origin, int64_t u, int64_t v)
{
    const bool blocks = field.texel == format::GuidedTexel::vq8;
    const auto number =
        blocks ? texel_number(field.chart, origin, u >> 1, v >> 1) : texel_number(field.chart, origin, u, v);
    if (!number) return std::nullopt;
    const bool narrow = field.texel == format::GuidedTexel::index4;
    const uint8_t* texels = field.chart.texels;
    const int index = narrow ? texels[*number / 2] >> *number % 2 * 4 & 0xF : texels[*number];
    if (index == 0) return std::nullopt;
    const size_t group = origin / field.origins_per_palette;
    const size_t entry = blocks ? 4 * static_cast<size_t>(index) + static_cast<size_t>(2 * (v & 1) + (u & 1))
                                : static_cast<size_t>(index);
    const uint8_t* rgb =
        field.colours + (group * format::chart_colours(field.texel) + entry) * format::kChartColourBytes;
    const auto value = [&](int channel) {
        return field.mean.resolution != 0 ? static_cast<double>(static_cast<int8_t>(rgb[channel])) : rgb[channel];
    };
    return Colour{value(0), value(1), value(2)};
}

struct Tap {
    int64_t u, v;
    double weight;
};

void taps_around(const ChartPlace& place, Taps kind, Tap (&taps)[3])
{
    const double fu = place.u - std::floor(place.u), fv = place.v - std::floor(place.v);
    const auto u = static_cast<int64_t>(std::floor(place.u)), v = static_cast<int64_t>(std::floor(place.v));
    const bool lower = fu > fv;
    taps[0] = {u, v, 1 - std::max(fu, fv)};
    taps[1] = {u + (lower ? 1 : 0), v + (lower ? 0 : 1), std::fabs(fu - fv)};
    taps[2] = {u + 1, v + 1, std::min(fu, fv)};
    if (kind == Taps::linear) return;
    Tap* heaviest = std::max_element(taps, taps + 3, [](const Tap& a, const Tap& b) { return a.weight < b.weight; });
    for (Tap& tap : taps) tap.weight = &tap == heaviest ? 1 : 0;
}

Colour node_colour(const MeanColours& mean, const int64_t (&node)[3])
{
    uint32_t brick[3], inside[3];
    for (int axis = 0; axis < 3; ++axis) {
        const int64_t first = 4 * mean.first_brick[axis], count = 4 * mean.box[axis];
        const auto n = static_cast<uint32_t>(std::clamp<int64_t>(node[axis] - first, 0, count - 1));
        brick[axis] = n / 4;
        inside[axis] = n % 4;
    }
    const uint32_t place = (brick[2] * mean.box[1] + brick[1]) * mean.box[0] + brick[0];
    const size_t at = size_t{u16_at(mean.index + 2 * size_t{place})} * format::kBrickNodes +
                      (inside[2] * 4 + inside[1]) * 4 + inside[0];
    if (mean.format == format::MeanFormat::palette8) {
        const uint8_t* rgb = mean.palette + size_t{mean.bricks[at]} * 4;
        return level_colour(rgb[0], rgb[1], rgb[2]);
    }
    const Rgb8 c = unpack_rgb565(static_cast<uint16_t>(u16_at(mean.bricks + 2 * at)));
    return level_colour(c.r, c.g, c.b);
}

struct Sum {
    Colour colour;
    double weight = 0;

    void add(const Colour& c, double w)
    {
        colour.r += w * c.r;
        colour.g += w * c.g;
        colour.b += w * c.b;
        weight += w;
    }
};

void add_origin(const GuidedField& field, uint32_t origin, double weight, const Vec3& x, Taps kind, Sum& sum)
{
    if (origin >= field.used_origins || is_hidden(field, origin, x)) return;
    Tap taps[3];
    taps_around(chart_place(field, origin, x), kind, taps);
    for (const Tap& tap : taps)
        if (tap.weight > 0)
            if (const auto colour = texel_colour(field, origin, tap.u, tap.v)) sum.add(*colour, weight * tap.weight);
}

Sum chart_sum(const GuidedField& field, const Weights& weights, const Vec3& x, const GuidedShading& shading)
{
    Sum sum;
    if (field.texel == format::GuidedTexel::none) return sum;
    if (shading.origins == Origins::three) {
        for (const auto& [origin, weight] : weights) add_origin(field, origin, weight, x, shading.taps, sum);
        return sum;
    }
    const auto heaviest = std::max_element(weights.begin(), weights.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
    add_origin(field, heaviest->first, 1, x, shading.taps, sum);
    return sum;
}

Colour scaled(const Colour& c, double by)
{
    return {c.r * by, c.g * by, c.b * by};
}

Colour clamped(const Colour& c)
{
    const auto level = [](double value) { return std::clamp(value, 0.0, 255.0); };
    return {level(c.r), level(c.g), level(c.b)};
}

}  // namespace

ChartPlace chart_place(const GuidedField& field, uint32_t origin, const Vec3& x)
{
    const ChartFrame frame = chart_frame(lumi::point(field.origins, origin));  // its integers define the chart
    const Vec3 e = normalised(x - point(field.origins.size(), origin));
    const double a = dot(decoded_q14(frame.tangent_q14), e), b = dot(decoded_q14(frame.bitangent_q14), e);
    const double half = field.chart_size / 2.0, root3 = std::sqrt(3.0);
    const double centre = format::chart_centre(field.chart_size);
    return {centre + (a + b / root3) * half, centre + 2 * b / root3 * half};
}

Colour mean_colour(const GuidedField& field, const Vec3& x)
{
    const double half = field.mean.resolution / 2.0;
    const double at[3] = {(x.x + 1) * half, (x.y + 1) * half, (x.z + 1) * half};
    Sum sum;
    for (int corner = 0; corner < 8; ++corner) {
        int64_t node[3];
        double weight = 1;
        for (int axis = 0; axis < 3; ++axis) {
            const double low = std::floor(at[axis]), part = at[axis] - low;
            const bool high = (corner >> axis & 1) != 0;
            node[axis] = static_cast<int64_t>(low) + (high ? 1 : 0);
            weight *= high ? part : 1 - part;
        }
        sum.add(node_colour(field.mean, node), weight);
    }
    return sum.colour;
}

bool is_hidden(const GuidedField& field, uint32_t origin, const Vec3& x)
{
    if (field.occlusion.texel_count == 0) return false;
    const ChartPlace place = chart_place(field, origin, x);
    const auto block = [](double c) { return static_cast<int64_t>(std::floor(c)) >> format::kOcclusionShift; };
    const auto number = texel_number(field.occlusion, origin, block(place.u), block(place.v));
    const uint8_t depth = number ? field.occlusion.texels[*number] : kHidesNothing;
    return depth != kHidesNothing && length(x - point(field.origins.size(), origin)) > depth / kOcclusionPerUnit;
}

Shade shade(const GuidedField& field, const Weights& weights, const Vec3& x, const GuidedShading& shading)
{
    const Sum sum = chart_sum(field, weights, x, shading);
    if (field.mean.resolution != 0) {
        const Colour mean = mean_colour(field, x);
        const Colour difference = scaled(sum.colour, 1 / std::max(sum.weight, kFullDifference));
        return {clamped({mean.r + difference.r, mean.g + difference.g, mean.b + difference.b}), 1};
    }
    if (sum.weight <= 0) return {{}, 0};
    const bool partly = field.surface == format::GuidedSurface::focus;
    return {clamped(scaled(sum.colour, 1 / sum.weight)), partly ? std::min(sum.weight, 1.0) : 1};
}

}  // namespace lumi::reference
