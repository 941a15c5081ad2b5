// SPDX-License-Identifier: MIT
// A frame's discs of gloss, and its vertices in them.
#include "lumi/surface/detail/gloss.h"

#include "lumi/detail/math.h"
#include "math/reciprocal.h"
#include "surface/owners.h"
#include "surface/projection.h"
#include "surface/view_light.h"

namespace lumi::detail
{
namespace
{

constexpr int32_t kOneQ14 = 1 << 14;
constexpr int32_t kLeastCosineQ14 = kOneQ14 / 4;  // grazing directions are mirrored as at this one
constexpr int32_t kMiddleQ8 = kGlossDiscSide / 2 * 256;
constexpr int32_t kRadius = static_cast<int32_t>(kGlossDiscSide) / 2 - 1;  // of the disc, texels

struct Vec3q14 {
    int32_t x, y, z;
};

// A product of a unit vector and one of at most 3.
int32_t dot_q14(const Vec3q14& a, const Vec3q14& b)
{
    return (a.x * b.x + a.y * b.y + a.z * b.z) >> 14;
}

uint32_t squared(const Vec3q14& v)
{
    return static_cast<uint32_t>(v.x * v.x) + static_cast<uint32_t>(v.y * v.y) + static_cast<uint32_t>(v.z * v.z);
}

// The reciprocal of a vector's length, of one that is not 0 and whose square fits 32 bits.
class InverseLength
{
public:
    explicit InverseLength(uint32_t square)
    {
        const int32_t even = normalized(square).leading & ~1;
        root_q14_ = static_cast<int32_t>(coarse_inverse_root_q15(square << even) >> 1);
        shift_ = 16 - even / 2;
    }
    // v/length, Q14, for v up to the length.
    int32_t times(int32_t v) const { return (v * root_q14_) >> shift_; }

private:
    int32_t root_q14_, shift_;
};

// The camera's axes in the frame of the sphere. `back` leads to the eye. They are those of the projection, so that a
// body that is kept because its projection is the same has the same discs.
struct CameraAxes {
    Vec3q14 right, up, back;

    explicit CameraAxes(const SurfaceProjection& p)
        : right(direction(p.axis[0], 1)), up(direction(p.axis[1], -1)), back(direction(p.axis[2], -1))
    {
    }

private:
    static Vec3q14 direction(const int32_t (&axis)[3], int32_t sign)
    {
        const Vec3q14 v = {sign * axis[0], sign * axis[1], sign * axis[2]};
        const InverseLength inverse(squared(v));
        return {inverse.times(v.x), inverse.times(v.y), inverse.times(v.z)};
    }
};

void put_colours(const SurfaceFrame& frame, PackedColour* colours)
{
    const uint8_t* gain = frame.field.gloss + format::kGlossHeaderBytes;
    for (uint32_t map = 0; map < gloss_count(frame.field); ++map, gain += format::kGlossGainBytes) {
        for (uint32_t k = 0; k < kGlossColours; ++k) {
            // Levels have 6 bits of fraction, and 2 in a colour.
            const auto channel = [&](uint32_t c) {
                const uint32_t level_q2 = k * gain[c] >> 4;
                return level_q2 < 1020 ? level_q2 : 1020u;
            };
            *colours++ = packed_colour(channel(0), channel(1), channel(2));
        }
    }
}

// sqrt(v) of Q28, Q14, for v > 0.
int32_t root_q14(uint32_t v)
{
    const int32_t even = normalized(v).leading & ~1;
    const uint32_t m = v << even, inverse = coarse_inverse_root_q15(m);
    return static_cast<int32_t>(((m >> 16) * inverse) >> (15 + even / 2));
}

// A place in a map: the upper left of four texels, and how far it is from that one's middle.
struct MapPlace {
    uint32_t at, right_q8, down_q8;
};

// Returns a direction's place in the map (surface/format.h). One unit of the octahedral map is 16 texels, Q8.
MapPlace place_in_map(const Vec3q14& d)
{
    const auto size = [](int32_t v) { return v < 0 ? -v : v; };
    const Reciprocal r = reciprocal(static_cast<uint32_t>(size(d.x) + size(d.y) + size(d.z)));
    const auto part = [&](int32_t v) { return (v * static_cast<int32_t>(r.mantissa)) >> (35 - r.leading); };
    constexpr int32_t kOne = static_cast<int32_t>(format::kGlossSide) * 128;
    int32_t x = part(d.x), y = part(d.y);
    if (d.z < 0) {
        const int32_t folded_x = kOne - size(y), folded_y = kOne - size(x);
        x = d.x < 0 ? -folded_x : folded_x;
        y = d.y < 0 ? -folded_y : folded_y;
    }
    const auto within = [](int32_t v) {
        const int32_t q8 = v + kOne + 128;
        return static_cast<uint32_t>(q8 < 0 ? 0 : q8 < 2 * kOne + 255 ? q8 : 2 * kOne + 255);
    };
    const uint32_t u = within(x), v = within(y);
    return {(v >> 8) * format::kGlossStride + (u >> 8), u & 255, v & 255};
}

uint8_t texel_at(const uint8_t* map, const MapPlace& p)
{
    const uint8_t* const t = map + p.at;
    const uint32_t upper = t[0] * (256 - p.right_q8) + t[1] * p.right_q8;
    const uint32_t lower = t[format::kGlossStride] * (256 - p.right_q8) + t[format::kGlossStride + 1] * p.right_q8;
    return static_cast<uint8_t>((upper * (256 - p.down_q8) + lower * p.down_q8 + (1 << 15)) >> 16);
}

class Discs
{
public:
    Discs(const SurfaceFrame& frame, const CameraAxes& axes, uint8_t* discs)
        : field_(frame.field), axes_(axes), discs_(discs)
    {
    }

    // A quarter of a disc has the others' half vectors, mirrored.
    void put() const
    {
        for (int32_t y = 0; y <= kRadius; ++y)
            for (int32_t x = 0; x <= kRadius; ++x) put_four(x, y);
    }

private:
    static constexpr int32_t kLast = static_cast<int32_t>(kGlossDiscSide) - 1;
    static constexpr int32_t kReach = 2 * kRadius + 3;  // half texels: four texels around a place in the circle

    void put_four(int32_t x, int32_t y) const
    {
        const int32_t to_right = 2 * x - kLast, to_up = kLast - 2 * y;
        if (to_right * to_right + to_up * to_up > kReach * kReach) return;
        const int32_t right = to_right * kOneQ14 / (2 * kRadius), up = to_up * kOneQ14 / (2 * kRadius);
        const int32_t square_q28 = right * right + up * up;
        // Beyond the circle lies what is behind the disc's middle.
        const int32_t left_q28 = (1 << 28) - square_q28;
        const int32_t back = left_q28 > 0 ? root_q14(static_cast<uint32_t>(left_q28)) : 0;
        put_texel(x, y, right, up, back);
        put_texel(kLast - x, y, -right, up, back);
        put_texel(x, kLast - y, right, -up, back);
        put_texel(kLast - x, kLast - y, -right, -up, back);
    }

    // Mirrors the direction to the eye, (0, 0, 1), in the half vector.
    void put_texel(int32_t x, int32_t y, int32_t right, int32_t up, int32_t back) const
    {
        LUMI_TALLY(Work::gloss_texel, 1);
        const int32_t to_right = (2 * back * right) >> 14, to_up = (2 * back * up) >> 14;
        const int32_t to_back = ((2 * back * back) >> 14) - kOneQ14;
        const auto sum = [&](int32_t Vec3q14::*k) {
            return (axes_.right.*k * to_right + axes_.up.*k * to_up + axes_.back.*k * to_back) >> 14;
        };
        const MapPlace place = place_in_map({sum(&Vec3q14::x), sum(&Vec3q14::y), sum(&Vec3q14::z)});
        uint8_t* texel = discs_ + y * static_cast<int32_t>(kGlossDiscSide) + x;
        const uint8_t* map = field_.gloss + format::gloss_maps_at(gloss_count(field_));
        for (uint32_t k = 0; k < gloss_count(field_); ++k, texel += kGlossDiscBytes, map += format::kGlossMapBytes)
            *texel = texel_at(map, place);
    }

    const SurfaceField& field_;
    const CameraAxes& axes_;
    uint8_t* const discs_;
};

// The normal that a vertex's turn leads to, as in_view_frame() turns: 2·h_z·h - z, h = turn/127.
Vec3q14 normal_of(const uint8_t* turn)
{
    constexpr int32_t kTwiceQ12 = 8321;  // 2 · 2^14/127²
    const int32_t x = signed_byte(turn), y = signed_byte(turn + 1), z = signed_byte(turn + 2);
    return {(z * x * kTwiceQ12) >> 12, (z * y * kTwiceQ12) >> 12, ((z * z * kTwiceQ12) >> 12) - kOneQ14};
}

Vec3q14 to_eye(const SurfaceFrame& frame, uint32_t vertex, const Vec3q14& otherwise)
{
    const VertexQ14 v = surface_vertex(frame.field, vertex);
    const SurfaceProjection& p = frame.projection;
    const Vec3q14 way = {p.viewer.x - (v.x >> p.viewer_shift), p.viewer.y - (v.y >> p.viewer_shift),
                         p.viewer.z - (v.z >> p.viewer_shift)};
    const uint32_t square = squared(way);
    if (square == 0) return otherwise;
    const InverseLength inverse(square);
    return {inverse.times(way.x), inverse.times(way.y), inverse.times(way.z)};
}

uint16_t packed_place(int32_t u_q8, int32_t v_q8)
{
    const auto quarter = [](int32_t q8) { return static_cast<uint32_t>(q8 + 32) >> 6; };
    return static_cast<uint16_t>(quarter(v_q8) << 8 | quarter(u_q8));
}

// Where a vertex lies in the discs: at the half vector of the axis and of its mirrored direction to the eye.
uint16_t place_in_disc(const SurfaceFrame& frame, const CameraAxes& axes, uint32_t vertex)
{
    LUMI_TALLY(Work::gloss_vertex, 1);
    const uint32_t bits = frame.field.code_bits;
    const Vec3q14 n = normal_of(frame.field.views + vertex * format::view_bytes(bits) + format::view_turn_at(bits));
    const Vec3q14 w = to_eye(frame, vertex, axes.back);
    const int32_t cosine = dot_q14(n, w), c = cosine > kLeastCosineQ14 ? cosine : kLeastCosineQ14;
    const auto sum = [&](int32_t Vec3q14::*k) { return ((2 * c * n.*k) >> 14) - w.*k + axes.back.*k; };
    const Vec3q14 both = {sum(&Vec3q14::x), sum(&Vec3q14::y), sum(&Vec3q14::z)};
    Vec3q14 h = {dot_q14(both, axes.right), dot_q14(both, axes.up), dot_q14(both, axes.back)};
    if (h.z < kOneQ14 / 64) h.z = 0;
    const uint32_t square = squared(h);
    if (square == 0) return packed_place(kMiddleQ8, kMiddleQ8);
    const InverseLength inverse(square);
    // Q14 of the radius to Q8 of texels.
    return packed_place(kMiddleQ8 + ((inverse.times(h.x) * kRadius) >> 6),
                        kMiddleQ8 - ((inverse.times(h.y) * kRadius) >> 6));
}

}  // namespace

void put_gloss(const SurfaceFrame& frame)
{
    if (gloss_count(frame.field) == 0 || frame.columns.begin >= frame.columns.end) return;
    const GlossMemory memory(frame);
    const CameraAxes axes(frame.projection);
    put_colours(frame, memory.colours);
    Discs(frame, axes, memory.discs).put();
    const uint32_t end = owner_ranges(frame.field, 0).viewed.end;
    for (uint32_t k = 0; k < end; ++k)
        if (frame.memory.vertices[k].colour != kUnlit) memory.places[k] = place_in_disc(frame, axes, k);
}

}  // namespace lumi::detail
