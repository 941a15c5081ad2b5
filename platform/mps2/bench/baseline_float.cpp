// SPDX-License-Identifier: MIT
// A baseline: the paper's algorithm pixel by pixel in single-precision floating point, as one would first write it.
// Hits by the quadratic equation; the cell of a hit by Keinert's inverse map ("Spherical Fibonacci Mapping", ACM TOG
// 34(6), 2015, section 5); of the 16 points around it the five nearest, weighted by the paper's kernel.
// It has a floating-point unit or not, as the build's flags say.
#include <cmath>

#include "instance.h"
#include "lumi/chord/render.h"

namespace lumi::bench
{
namespace
{

struct FloatVec {
    float x, y, z;
};

class FloatLattice
{
public:
    static constexpr int kTaps = 5;

    struct Taps {
        uint32_t index[kTaps];
        float weight[kTaps];
    };

    explicit FloatLattice(uint32_t size) : size_(static_cast<float>(size)) {}

    Taps taps(const FloatVec& hit) const
    {
        Ranking ranking;
        const Basis basis(size_, hit.z);
        const Steps cell = basis.cell_of(std::atan2(hit.y, hit.x), hit.z - (1 - 1 / size_));
        for (int a = -1; a <= 2; ++a) {
            for (int b = -1; b <= 2; ++b) {
                const float i = basis.index(cell.first + static_cast<float>(a), cell.second + static_cast<float>(b));
                if (i >= 0 && i < size_) ranking.consider(static_cast<uint32_t>(i), distance2(i, hit));
            }
        }
        return weighted(ranking);
    }

private:
    static constexpr float kPi = 3.14159265f;
    static constexpr float kGolden = 1.61803399f;
    static constexpr float kRoot5 = 2.23606798f;
    static constexpr float kTurn = 4294967296.0f;

    struct Steps {
        float first, second;
    };

    // The two Fibonacci steps of the zone at height z and the differences in longitude and height that they make.
    class Basis
    {
    public:
        Basis(float size, float z)
        {
            const float sine2 = std::fmax(1 - z * z, 1e-6f);
            const float k =
                std::fmax(2.0f, std::floor(std::log(size * kPi * kRoot5 * sine2) / std::log(kGolden * kGolden)));
            const float power = std::pow(kGolden, k) / kRoot5;
            fibonacci_ = {std::round(power), std::round(power * kGolden)};
            longitude_ = {longitude_step(fibonacci_.first), longitude_step(fibonacci_.second)};
            height_ = {-2 * fibonacci_.first / size, -2 * fibonacci_.second / size};
        }

        Steps cell_of(float longitude, float height) const
        {
            const float scale = 1 / (longitude_.first * height_.second - longitude_.second * height_.first);
            return {std::floor(scale * (longitude * height_.second - longitude_.second * height)),
                    std::floor(scale * (longitude_.first * height - longitude * height_.first))};
        }

        float index(float a, float b) const { return a * fibonacci_.first + b * fibonacci_.second; }

    private:
        static float longitude_step(float steps)
        {
            return 2 * kPi *
                   static_cast<float>(static_cast<int32_t>(detail::longitude_turns32(static_cast<uint32_t>(steps)))) /
                   kTurn;
        }

        Steps fibonacci_, longitude_, height_;
    };

    struct Ranking {
        uint32_t index[kTaps];
        float distance2[kTaps];
        int count = 0;

        void consider(uint32_t i, float d2)
        {
            int k = count < kTaps ? count++ : kTaps;
            if (k == kTaps && d2 >= distance2[--k]) return;
            for (; k > 0 && d2 < distance2[k - 1]; --k) {
                index[k] = index[k - 1];
                distance2[k] = distance2[k - 1];
            }
            index[k] = i;
            distance2[k] = d2;
        }
    };

    float distance2(float i, const FloatVec& hit) const
    {
        const float z = 1 - (2 * i + 1) / size_;
        const float radius = std::sqrt(std::fmax(0.0f, 1 - z * z));
        const float angle = 2 * kPi * static_cast<float>(detail::longitude_turns32(static_cast<uint32_t>(i))) / kTurn;
        const FloatVec d = {radius * std::cos(angle) - hit.x, radius * std::sin(angle) - hit.y, z - hit.z};
        return d.x * d.x + d.y * d.y + d.z * d.z;
    }

    Taps weighted(const Ranking& ranking) const
    {
        const float radius2 = 4 * kPi / size_;
        Taps taps = {};
        float sum = 0;
        for (int k = 0; k < ranking.count; ++k) {
            const float inside = std::fmax(0.0f, 1 - ranking.distance2[k] / radius2);
            taps.index[k] = ranking.index[k];
            taps.weight[k] = inside * inside;
            sum += taps.weight[k];
        }
        for (float& weight : taps.weight) weight = sum > 0 ? weight / sum : 0;
        return taps;
    }

    float size_;
};

// Holds the quantities of lumi::Camera in floating point.
struct FloatRay {
    FloatVec eye_direction, offset;
    float inverse_distance, facing;

    FloatRay(const Camera& camera, int32_t x, int32_t y)
        : eye_direction{from_q30(camera.eye_direction().x), from_q30(camera.eye_direction().y),
                        from_q30(camera.eye_direction().z)},
          offset{from_q40(camera.offset()[0].at(x, y)), from_q40(camera.offset()[1].at(x, y)),
                 from_q40(camera.offset()[2].at(x, y))},
          inverse_distance(from_q30(camera.inverse_distance_q30())),
          facing(from_q40(camera.facing().at(x, y)))
    {
    }

    // Returns false if the ray misses the sphere.
    bool hits(FloatVec& front, FloatVec& back) const
    {
        const float p2 = offset.x * offset.x + offset.y * offset.y + offset.z * offset.z;
        const float chord2 = facing * facing - (1 - inverse_distance * inverse_distance) * p2;
        if (chord2 <= 0) return false;
        const float s = std::sqrt(chord2);
        const float scale = 1 / (facing * facing + p2 * inverse_distance * inverse_distance);
        front = point(scale * (p2 * inverse_distance + s * facing), scale * (facing - s * inverse_distance));
        back = point(scale * (p2 * inverse_distance - s * facing), scale * (facing + s * inverse_distance));
        return true;
    }

private:
    static float from_q30(int32_t v) { return static_cast<float>(v) * 0x1p-30f; }
    static float from_q40(int64_t v) { return static_cast<float>(v) * 0x1p-40f; }
    FloatVec point(float along_eye, float along_offset) const
    {
        return {along_eye * eye_direction.x + along_offset * offset.x,
                along_eye * eye_direction.y + along_offset * offset.y,
                along_eye * eye_direction.z + along_offset * offset.z};
    }
};

// Draws over black.
template <class Texel>
Rgb8 float_colour(const Field& field, const FloatLattice::Taps& origins, const FloatLattice::Taps& directions)
{
    float r = 0, g = 0, b = 0;
    for (int m = 0; m < FloatLattice::kTaps; ++m) {
        for (int k = 0; k < FloatLattice::kTaps; ++k) {
            const uint8_t* row = field.row(origins.index[m]);
            if (row == nullptr) continue;
            const detail::Rgba8 texel = Texel::load(field, row, directions.index[k]);
            const float weight = origins.weight[m] * directions.weight[k];
            r += weight * texel.r;
            g += weight * texel.g;
            b += weight * texel.b;
        }
    }
    constexpr float kHalf = 0.5f;
    return {static_cast<uint8_t>(r + kHalf), static_cast<uint8_t>(g + kHalf), static_cast<uint8_t>(b + kHalf)};
}

// Draws the stripe over black.
template <class Texel, class Pixel>
void draw_float_paper(const Field& field, const Camera& camera, const Stripe& stripe)
{
    const FloatLattice origins(field.origins.size());
    const FloatLattice directions(field.directions.size());
    for (int32_t y = 0; y < stripe.height_px; ++y) {
        uint8_t* pixel = stripe.pixels + static_cast<uint32_t>(y) * stripe.stride_bytes;
        for (int32_t x = 0; x < stripe.width_px; ++x, pixel += Pixel::kBytes) {
            FloatVec front, back;
            Rgb8 colour = {0, 0, 0};
            if (FloatRay(camera, stripe.x_px + x, stripe.y_px + y).hits(front, back))
                colour = float_colour<Texel>(field, origins.taps(front), directions.taps(back));
            Pixel::store(pixel, colour);
        }
    }
}

}  // namespace

RenderError draw(const Field& field, const Camera& camera, const Stripe& stripe, int32_t)
{
    draw_float_paper<LUMI_BENCH_TEXEL, PixelRgb565>(field, camera, stripe);
    return RenderError::none;
}

}  // namespace lumi::bench
