// SPDX-License-Identifier: MIT
#include "mesh/rounded_mesh.h"

#include <map>

namespace lumi::baker
{
namespace
{

constexpr int32_t kOneQ14 = 1 << 14;

using Steps = std::array<int32_t, 3>;

int64_t square(int32_t v)
{
    return int64_t{v} * v;
}

Steps steps_of(const Vec3& p)
{
    const Vec3 scaled = p * (kOneQ14 / std::max(1.0f, length(p)));
    const auto nearest = [](float c) { return static_cast<int32_t>(std::lround(c)); };
    Steps s = {nearest(scaled.x), nearest(scaled.y), nearest(scaled.z)};
    if (square(s[0]) + square(s[1]) + square(s[2]) > square(kOneQ14)) {
        // Rounding towards the centre cannot leave the sphere.
        s = {static_cast<int32_t>(scaled.x), static_cast<int32_t>(scaled.y), static_cast<int32_t>(scaled.z)};
    }
    return s;
}

Vec3 position_of(const Steps& s)
{
    constexpr float kUnit = 1.0f / kOneQ14;
    return Vec3{static_cast<float>(s[0]), static_cast<float>(s[1]), static_cast<float>(s[2])} * kUnit;
}

// The area vector's components are exact in 64 bits.
bool has_area(const Steps& a, const Steps& b, const Steps& c)
{
    const auto minor = [&](size_t i, size_t j) {
        return int64_t{b[i] - a[i]} * (c[j] - a[j]) - int64_t{b[j] - a[j]} * (c[i] - a[i]);
    };
    return minor(0, 1) != 0 || minor(1, 2) != 0 || minor(2, 0) != 0;
}

}  // namespace

Mesh rounded(const Mesh& mesh)
{
    Mesh result;
    std::map<Steps, uint32_t> numbers;
    for (size_t k = 0; k < mesh.triangle_count(); ++k) {
        const std::array<Steps, 3> corners = {steps_of(mesh.position(k, 0)), steps_of(mesh.position(k, 1)),
                                              steps_of(mesh.position(k, 2))};
        if (!has_area(corners[0], corners[1], corners[2])) continue;
        Mesh::Corners numbered;
        for (size_t i = 0; i < 3; ++i) {
            const auto [found, is_new] = numbers.emplace(corners[i], static_cast<uint32_t>(result.positions.size()));
            if (is_new) result.positions.push_back(position_of(corners[i]));
            numbered[i] = found->second;
        }
        result.corners.push_back(numbered);
    }
    return result;
}

}  // namespace lumi::baker
