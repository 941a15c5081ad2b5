// SPDX-License-Identifier: MIT
#include "lumi/detail/lattice.h"

#include "lattice/zone_tables.h"
#include "lumi/detail/math.h"
#include "math/generate.h"

namespace lumi::detail
{
namespace
{

constexpr ZoneTables make_zone_tables()
{
    ZoneTables t{};
    double power = 1;
    double inverse = 1;
    for (uint32_t& v : t.threshold_q10) {
        v = static_cast<uint32_t>(1024 * power / (generate::root(5) * generate::kPi) + 0.5);
        power *= generate::kGolden;
    }
    for (int32_t& v : t.inverse_power_q30) {
        v = static_cast<int32_t>(kOneQ30 * inverse + 0.5);
        inverse /= generate::kGolden;
    }
    return t;
}

}  // namespace

constexpr ZoneTables kZoneTables = make_zone_tables();

Lattice::Lattice(uint32_t size)
    : size_(size), reciprocal_q62_(((uint64_t{1} << 62) + size / 2) / size), spacing2_(0), unit_bits_(0)
{
    constexpr uint64_t kFourPiQ56 = 905502432259640355u;  // 4π
    const uint64_t spacing2_q56 = kFourPiQ56 / size;
    const uint32_t spacing_q28 = square_root(spacing2_q56);
    constexpr int kSpacingBits = 14;  // the spacing is in [2^13, 2^14) units
    const int shift = 32 - __builtin_clz(spacing_q28) - kSpacingBits;
    unit_bits_ = 28 - shift;
    spacing2_ = static_cast<uint32_t>(spacing2_q56 >> (2 * shift));
}

int32_t Lattice::height_q30(uint32_t i) const
{
    return kOneQ30 - static_cast<int32_t>(((2 * i + 1) * reciprocal_q62_ + (uint64_t{1} << 31)) >> 32);
}

int32_t Lattice::height_at_q30(int32_t index_q10) const
{
    const uint64_t below_top_q10 = static_cast<uint64_t>(2 * static_cast<int64_t>(index_q10) + 1024);  // < 2^32
    return kOneQ30 - static_cast<int32_t>((below_top_q10 * (reciprocal_q62_ >> 10)) >> 32);
}

int32_t Lattice::index_at_q10(int32_t z_q30) const
{
    const uint64_t below_top = static_cast<uint64_t>(kOneQ30 - static_cast<int64_t>(z_q30)) * size_;  // Q30
    return static_cast<int32_t>(below_top >> 21) - 512;
}

uint32_t longitude_turns32(uint32_t i)
{
    // 2^32/Φ = 0x9E3779B9 + 0.4972…; the second product adds that fraction, 2036/4096.
    return i * 0x9E3779B9u + static_cast<uint32_t>(static_cast<int32_t>(i * 2036u) >> 12);
}

Vec3q30 point(const Lattice& lattice, uint32_t i)
{
    const int32_t z = lattice.height_q30(i);
    const SinCos direction = sin_cos(longitude_turns32(i));
    const uint64_t radius2_q60 = (uint64_t{1} << 60) - static_cast<uint64_t>(wide_product(z, z));
    const int32_t radius = static_cast<int32_t>(square_root(radius2_q60));
    return {mul_q30(radius, direction.cos_q30), mul_q30(radius, direction.sin_q30), z};
}

}  // namespace lumi::detail
