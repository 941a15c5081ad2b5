// SPDX-License-Identifier: MIT
#include "mesh/silhouettes.h"

#include "math/frame.h"
#include "math/warp.h"
#include "trace/hit_point.h"

namespace lumi::baker
{
namespace
{

constexpr int kSide = static_cast<int>(kSilhouetteSize);
constexpr float kGoldenRatio = 0.618034f;
constexpr float kRayStart = 2;  // where rays start, in radii

class Mask
{
public:
    Mask() : pixels_(kSilhouetteSize * kSilhouetteSize, false) {}

    bool at(int x, int y) const { return x >= 0 && y >= 0 && x < kSide && y < kSide && pixels_[index(x, y)]; }
    void set(int x, int y, bool value) { pixels_[index(x, y)] = value; }
    uint32_t count() const { return static_cast<uint32_t>(std::count(pixels_.begin(), pixels_.end(), true)); }

    // How many of the w × h pixels from (x, y) on are set.
    uint32_t count(int x, int y, int w, int h) const
    {
        uint32_t sum = 0;
        for (int k = 0; k < w * h; ++k) sum += at(x + k % w, y + k / w) ? 1u : 0u;
        return sum;
    }

    // Clears the connected region around a pixel and returns its size.
    uint32_t clear_region(int x, int y)
    {
        std::vector<std::array<int, 2>> open = {{x, y}};
        uint32_t size = 0;
        while (!open.empty()) {
            const auto [px, py] = open.back();
            open.pop_back();
            if (!at(px, py)) continue;
            set(px, py, false);
            ++size;
            for (int k = 0; k < 9; ++k) open.push_back({px - 1 + k % 3, py - 1 + k / 3});
        }
        return size;
    }

private:
    static size_t index(int x, int y) { return static_cast<size_t>(y * kSide + x); }

    std::vector<bool> pixels_;
};

float height_of(uint32_t direction)
{
    return (2 * static_cast<float>(direction) + 1) / kSilhouettes - 1;
}

template <class Covers>
Mask silhouette(uint32_t direction, const Covers& covers)
{
    const Frame frame(direction_at(height_of(direction), kGoldenRatio * static_cast<float>(direction)));
    Mask mask;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const auto place = [](int k) { return (2 * static_cast<float>(k) + 1) / kSide - 1; };
            mask.set(x, y, covers(Ray{frame.to_world({place(x), place(y), kRayStart}), -frame.normal}));
        }
    }
    return mask;
}

bool is_two_thick(const Mask& mask, int x, int y)
{
    return mask.count(x, y, 2, 2) == 4 || mask.count(x - 1, y, 2, 2) == 4 || mask.count(x, y - 1, 2, 2) == 4 ||
           mask.count(x - 1, y - 1, 2, 2) == 4;
}

Mask missing_of(const Mask& scene, const Mask& mesh)
{
    Mask result;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const bool inside = scene.count(x - 1, y - 1, 3, 3) == 9;
            const bool gone = mesh.count(x - 1, y - 1, 3, 3) == 0 && is_two_thick(scene, x, y);
            result.set(x, y, scene.at(x, y) && !mesh.at(x, y) && (inside || gone));
        }
    }
    return result;
}

bool covers(const SceneData& scene, const Ray& ray)
{
    return scene.has_transparency ? transmittance(scene, ray) < 0.5f : scene.accelerator.blocked(ray);
}

MissingPixels missing_from(uint32_t direction, const SceneData& scene, const MeshTracer& mesh)
{
    const Mask truth = silhouette(
        direction, [&](const Ray& ray) { return covers(scene, ray); });
    const Mask drawn = silhouette(direction, [&](const Ray& ray) { return mesh.closest(ray).has_value(); });
    Mask missing = missing_of(truth, drawn);
    MissingPixels result = {truth.count(), missing.count()};
    for (int k = 0; k < kSide * kSide; ++k) {
        const uint32_t region = missing.clear_region(k % kSide, k / kSide);
        result.largest = std::max(result.largest, region);
        result.regions += region > kMaxMissing ? 1u : 0u;
    }
    return result;
}

}  // namespace

MissingPixels missing_pixels(const SceneData& scene, const MeshTracer& mesh, Job& job, const ViewCap& cap)
{
    std::vector<MissingPixels> parts(kSilhouettes);
    job.run(kSilhouettes, [&](uint32_t d) {
        if (height_of(d) >= cap.lowest()) parts[d] = missing_from(d, scene, mesh);
    });
    MissingPixels sum;
    for (const MissingPixels& part : parts) {
        sum = {sum.scene + part.scene, sum.missing + part.missing, std::max(sum.largest, part.largest),
               sum.regions + part.regions};
    }
    return sum;
}

}  // namespace lumi::baker
