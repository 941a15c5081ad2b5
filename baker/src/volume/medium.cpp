// SPDX-License-Identifier: MIT
#include "volume/medium.h"

namespace lumi::baker
{

namespace
{

int32_t blocks_of(uint32_t cells)
{
    return static_cast<int32_t>((cells + Majorants::kBlock - 1) / Majorants::kBlock);
}

// The largest density among the cells from `low` to `high`; both borders' voxels count.
float most_between(const Grid& grid, const TransferFunction& transfer, const std::array<uint32_t, 3>& low,
                   const std::array<uint32_t, 3>& high)
{
    float least = std::numeric_limits<float>::infinity(), most = -least;
    for (uint32_t z = low[2]; z <= high[2]; ++z) {
        for (uint32_t y = low[1]; y <= high[1]; ++y) {
            const float* row = grid.values.data() + (size_t{z} * grid.ny + y) * grid.nx;
            const auto [a, b] = std::minmax_element(row + low[0], row + high[0] + 1);
            least = std::min(least, *a);
            most = std::max(most, *b);
        }
    }
    constexpr float kRounding = 1e-6f;  // bounds the rounding of interpolation between voxels and between points
    return transfer.most_density(least, most) * (1 + kRounding);
}

}  // namespace

Majorants::Majorants(const Grid& grid, const TransferFunction& transfer)
    : cells_{grid.nx - 1, grid.ny - 1, grid.nz - 1},
      counts_{blocks_of(cells_[0]), blocks_of(cells_[1]), blocks_of(cells_[2])}
{
    const auto bounds = [&](std::array<uint32_t, 3> block, uint32_t more) {
        for (size_t k = 0; k < 3; ++k) block[k] = std::min((block[k] + more) * kBlock, cells_[k]);
        return block;
    };
    for (uint32_t z = 0; z < static_cast<uint32_t>(counts_[2]); ++z) {
        for (uint32_t y = 0; y < static_cast<uint32_t>(counts_[1]); ++y)
            for (uint32_t x = 0; x < static_cast<uint32_t>(counts_[0]); ++x)
                blocks_.push_back(most_between(grid, transfer, bounds({x, y, z}, 0), bounds({x, y, z}, 1)));
    }
}

float Majorants::most() const
{
    return *std::max_element(blocks_.begin(), blocks_.end());
}

std::vector<Vec3> Majorants::corners() const
{
    std::vector<Vec3> result;
    const auto place = [&](int32_t block, int bit, size_t k) {
        return static_cast<float>(std::min((static_cast<uint32_t>(block + bit)) * kBlock, cells_[k]));
    };
    std::array<int32_t, 3> b;
    for (b[2] = 0; b[2] < counts_[2]; ++b[2]) {
        for (b[1] = 0; b[1] < counts_[1]; ++b[1]) {
            for (b[0] = 0; b[0] < counts_[0]; ++b[0]) {
                for (int corner = 0; corner < 8 && at(b) > 0; ++corner) {
                    result.push_back(
                        {place(b[0], corner & 1, 0), place(b[1], corner >> 1 & 1, 1), place(b[2], corner >> 2, 2)});
                }
            }
        }
    }
    return result;
}

namespace
{

// -log(1 - u) for u in [0, 1): off by at most 2e-7 of itself and the same on all machines, see warp.h. By the series of
// the area hyperbolic tangent, of a fraction between the roots of 1/2 and 2.
float exponential(float u)
{
    constexpr float kLog2 = 0.693147181f, kRootHalf = 0.707106781f;
    int exponent = 0;
    float fraction = std::frexp(1 - u, &exponent);
    if (fraction < kRootHalf) {
        fraction *= 2;
        --exponent;
    }
    const float s = (fraction - 1) / (fraction + 1), s2 = s * s;
    const float log = 2 * s * (1 + s2 * (1.0f / 3 + s2 * (1.0f / 5 + s2 * (1.0f / 7 + s2 * (1.0f / 9)))));
    return -(log + static_cast<float>(exponent) * kLog2);
}

float mix(float a, float b, float share)
{
    return a + (b - a) * share;
}

}  // namespace

std::vector<Vec3> corners_of(const Volume& volume)
{
    std::vector<Vec3> corners = Majorants(volume.grid, volume.transfer).corners();
    for (Vec3& c : corners) c = moved(volume.grid.voxel_to_world, c);
    return corners;
}

Medium::Medium(Volume volume, const Affine& to_world, double radius)
    : grid_(std::move(volume.grid)),
      transfer_(std::move(volume.transfer)),
      phase_(volume.anisotropy),
      majorants_(grid_, transfer_),
      radius_(static_cast<float>(radius))
{
    const Affine voxels = combined(inverse(grid_.voxel_to_world), to_world);
    for (size_t r = 0; r < 3; ++r)
        for (size_t c = 0; c < 4; ++c) voxels_[r][c] = static_cast<float>(voxels[r][c]);
}

VoxelRay Medium::to_voxels(const Ray& ray) const
{
    const auto row = [&](size_t r, const Vec3& v) {
        return voxels_[r][0] * v.x + voxels_[r][1] * v.y + voxels_[r][2] * v.z;
    };
    const Vec3 &o = ray.origin, &d = ray.direction;
    return {{row(0, o) + voxels_[0][3], row(1, o) + voxels_[1][3], row(2, o) + voxels_[2][3]},
            {row(0, d), row(1, d), row(2, d)}};
}

std::optional<Medium::Part> Medium::inside(const Ray& ray) const
{
    Part part = {to_voxels(ray), 0, ray.end};
    const VoxelRay& v = part.ray;
    const auto clip = [&](float origin, float way, uint32_t voxels) {
        const float last = static_cast<float>(voxels - 1);
        if (way == 0) {
            part.end = origin >= 0 && origin <= last ? part.end : -1;
            return;
        }
        const float a = -origin / way, b = (last - origin) / way;
        part.start = std::max(part.start, std::min(a, b));
        part.end = std::min(part.end, std::max(a, b));
    };
    clip(v.origin.x, v.direction.x, grid_.nx);
    clip(v.origin.y, v.direction.y, grid_.ny);
    clip(v.origin.z, v.direction.z, grid_.nz);
    return part.start < part.end ? std::optional<Part>(part) : std::nullopt;
}

float Medium::scalar(const Vec3& voxel) const
{
    const auto cell = [](float place, uint32_t voxels) {
        return std::clamp(static_cast<int32_t>(place), 0, static_cast<int32_t>(voxels) - 2);
    };
    const int32_t i = cell(voxel.x, grid_.nx), j = cell(voxel.y, grid_.ny), k = cell(voxel.z, grid_.nz);
    const auto share = [](float place, int32_t from) {
        return std::clamp(place - static_cast<float>(from), 0.0f, 1.0f);
    };
    const float x = share(voxel.x, i), y = share(voxel.y, j), z = share(voxel.z, k);
    const size_t row = grid_.nx, slice = row * grid_.ny;
    const float* v =
        grid_.values.data() + static_cast<size_t>(k) * slice + static_cast<size_t>(j) * row + static_cast<size_t>(i);
    const auto plane = [&](const float* p) { return mix(mix(p[0], p[1], x), mix(p[row], p[row + 1], x), y); };
    return mix(plane(v), plane(v + slice), z);
}

std::optional<float> Medium::collision(const Ray& ray, Sampler& sampler) const
{
    const std::optional<Part> part = inside(ray);
    if (!part) return std::nullopt;
    std::optional<float> found;
    float rest = exponential(sampler.next_1d());  // depth to the next point that the majorants stop at
    majorants_.walk(part->ray, part->start, part->end, [&](float t, float end, float majorant) {
        const float most = majorant * radius_;
        for (; (end - t) * most > rest; rest = exponential(sampler.next_1d())) {
            t += rest / most;
            if (sampler.next_1d() * most < density_at(part->ray.at(t))) {
                found = t;
                return false;
            }
        }
        rest -= (end - t) * most;
        return true;
    });
    return found;
}

float Medium::transmittance(const Ray& ray, Sampler& sampler) const
{
    constexpr float kFaint = 0.1f;  // below it roulette decides
    const std::optional<Part> part = inside(ray);
    if (!part) return 1;
    float share = 1;
    float rest = exponential(sampler.next_1d());
    majorants_.walk(part->ray, part->start, part->end, [&](float t, float end, float majorant) {
        const float most = majorant * radius_;
        for (; (end - t) * most > rest; rest = exponential(sampler.next_1d())) {
            t += rest / most;
            share *= 1 - std::min(density_at(part->ray.at(t)) / most, 1.0f);
            if (share < kFaint) share = sampler.next_1d() * kFaint < share ? kFaint : 0.0f;
            if (share == 0) return false;
        }
        rest -= (end - t) * most;
        return true;
    });
    return share;
}

float Medium::density(const Vec3& point) const
{
    const Vec3 voxel = to_voxels({point, {}}).origin;
    const auto outside = [](float place, uint32_t voxels) {
        return place < 0 || place > static_cast<float>(voxels - 1);
    };
    if (outside(voxel.x, grid_.nx) || outside(voxel.y, grid_.ny) || outside(voxel.z, grid_.nz)) return 0;
    return density_at(voxel);
}

Rgb Medium::colour(const Vec3& point) const
{
    return transfer_.colour(scalar(to_voxels({point, {}}).origin));
}

void Medium::add_to(Digest& digest) const
{
    digest.add(grid_.nx);
    digest.add(grid_.ny);
    digest.add(grid_.nz);
    digest.add(grid_.values);
    for (const TransferPoint& p : transfer_.points()) {
        digest.add(p.value);
        digest.add(p.colour);
        digest.add(p.density);
    }
    digest.add(phase_.anisotropy());
    for (const auto& row : voxels_)
        for (const float v : row) digest.add(v);
}

}  // namespace lumi::baker
