// SPDX-License-Identifier: MIT
#include "shadow/part_shadows.h"

#include <algorithm>
#include <cmath>

#include "fit/encoded_tone.h"
#include "scene/moving_parts.h"
#include "shadow/receiver.h"
#include "shadow/taken_light.h"
#include "trace/path_tracer.h"

namespace lumi::baker
{
namespace
{

constexpr float kLift = 0.008f;         // radii above the receiver, whose mesh may stray by as much
constexpr uint32_t kShadowPoses = 8;    // that the shadow is the mean of
constexpr uint32_t kShadowPaths = 48;   // to a texel in a pose, with the part and without
constexpr float kFaint = 0.02f;         // a share of the light that no one misses
constexpr double kExplained = 1.0 / 3;  // of the shadow, squared: a shadow that explains less is dropped
constexpr uint64_t kShadowSeed = 0x73686164;
static_assert(kFewestCells * kFewestCells <= kFewestShadowTexels);

std::vector<Vec3> corners_of(const SceneData& scene, uint32_t owner)
{
    std::vector<Vec3> corners;
    for (size_t t = 0; t < scene.mesh.triangle_count(); ++t)
        for (size_t k = 0; k < 3 && scene.moving.owners[t] == owner; ++k) corners.push_back(scene.mesh.position(t, k));
    return corners;
}

// A part takes away this in one pose: by point of the grid, which turns with it, the share of light; and the light.
struct Shade {
    float angle;  // of the pose, radians about the receiver's normal
    std::vector<float> taken, light;
};

class ShadowTracer
{
public:
    ShadowTracer(const SceneData& scene, const SceneData& body, uint32_t part, const Receiver& receiver,
                 const ShadowGrid& grid, uint64_t seed)
        : scene_(scene), body_(body), part_(part), receiver_(receiver), grid_(grid), seed_(seed)
    {
    }

    std::vector<Shade> traced(Job& job) const
    {
        const PartMovement& movement = scene_.moving.motions[part_];
        constexpr double kTurn = 360, kRadians = static_cast<double>(kPi) / 180;
        const double from = movement.is_limited ? movement.from : 0,
                     step = movement.is_limited ? (movement.to - movement.from) / (kShadowPoses - 1)
                                                : kTurn / kShadowPoses;
        const double side = dot(receiver_.normal, movement.axis) > 0 ? 1 : -1;
        std::vector<Shade> shades;
        for (uint32_t k = 0; k < kShadowPoses; ++k) {
            const double value = from + step * k;
            shades.push_back({static_cast<float>(side * value * kRadians), {}, {}});
            trace(value, shades.back(), job);
        }
        return shades;
    }

private:
    void trace(double value, Shade& shade, Job& job) const
    {
        const std::unique_ptr<SceneData> posed = lit_with(scene_, part_ + 1, value);
        const PathTracer with(*posed), without(body_);
        const Affine pose = scene_.moving.motions[part_].pose(value);
        shade.taken.assign(grid_.size(), 0);
        shade.light.assign(grid_.size(), 0);
        job.run(grid_.rows, [&](uint32_t row) {
            for (uint32_t k = row * grid_.columns; k < (row + 1) * grid_.columns; ++k)
                measure(moved(pose, receiver_.at(grid_.middle(k))), k, with, without, shade);
            job.add_rays(uint64_t{2} * kShadowPaths * grid_.columns);
        });
    }

    // Paths begin so near the receiver that nothing else is met.
    void measure(const Vec3& place, uint32_t k, const PathTracer& with, const PathTracer& without, Shade& shade) const
    {
        const float start = std::min(kFlatReceiver + 1e-3f, 0.5f * receiver_.gap);
        const Ray ray = {place + receiver_.normal * start, -receiver_.normal};
        const std::optional<Hit> hit = body_.accelerator.closest(ray);
        if (!hit || hit->distance > start + kFlatReceiver) return;
        const TakenLight light = taken_light(ray, with, without, {kShadowPaths, seed_ + kShadowSeed, k});
        shade.light[k] = light.without;
        shade.taken[k] = light.taken;
    }

    const SceneData &scene_, &body_;
    const uint32_t part_;
    const Receiver& receiver_;
    const ShadowGrid& grid_;
    const uint64_t seed_;
};

// The mean over poses of what is taken, each pose's picture moved back by the shift, which does not turn.
std::vector<float> aligned_mean(const std::vector<Shade>& shades, const ShadowGrid& grid, const Vec2& shift)
{
    std::vector<float> mean(grid.size(), 0);
    for (const Shade& shade : shades) {
        const float c = std::cos(shade.angle), s = std::sin(shade.angle);
        const Vec2 turned = {c * shift.x + s * shift.y, c * shift.y - s * shift.x};
        for (uint32_t k = 0; k < grid.size(); ++k) {
            const Vec2 p = grid.middle(k);
            mean[k] += value_at(shade.taken, grid, {p.x + turned.x, p.y + turned.y}) / kShadowPoses;
        }
    }
    return mean;
}

double energy(const std::vector<float>& values)
{
    double sum = 0;
    for (const float v : values) sum += static_cast<double>(v) * static_cast<double>(v);
    return sum;
}

// The shift for which the mean of the poses holds most of them.
Vec2 best_shift(const std::vector<Shade>& shades, const ShadowGrid& grid, float gap)
{
    constexpr int kSteps = 8;  // to either side, up to two gaps
    Vec2 best;
    double most = -1;
    for (int y = -kSteps; y <= kSteps; ++y) {
        for (int x = -kSteps; x <= kSteps; ++x) {
            const Vec2 shift = {2 * gap * static_cast<float>(x) / kSteps, 2 * gap * static_cast<float>(y) / kSteps};
            const double held = energy(aligned_mean(shades, grid, shift));
            if (held <= most) continue;
            most = held;
            best = shift;
        }
    }
    return best;
}

struct Cells {
    uint32_t left, top, right, bottom;
};

ShadowGrid part_of(const ShadowGrid& grid, const Cells& cells, std::vector<float>& values)
{
    std::vector<float> kept;
    for (uint32_t y = cells.top; y < cells.bottom; ++y)
        for (uint32_t x = cells.left; x < cells.right; ++x) kept.push_back(values[y * grid.columns + x]);
    values = std::move(kept);
    const Vec2 low = {grid.low.x + grid.cell.x * static_cast<float>(cells.left),
                      grid.low.y + grid.cell.y * static_cast<float>(cells.top)};
    return {low, grid.cell, cells.right - cells.left, cells.bottom - cells.top};
}

// Returns the cells of a grid whose corners are inside, since a field holds nothing outside of the sphere; nothing if
// they are too few.
template <class IsInside>
std::optional<ShadowGrid> within(const ShadowGrid& grid, const IsInside& is_inside, std::vector<float>& values)
{
    constexpr uint32_t kFewest = 4;
    uint32_t left = 0, right = grid.columns, top = 0, bottom = grid.rows;
    const auto corner = [&](uint32_t x, uint32_t y) {
        return Vec2{grid.low.x + grid.cell.x * static_cast<float>(x), grid.low.y + grid.cell.y * static_cast<float>(y)};
    };
    const auto cut = [&](uint32_t& x, uint32_t& y, uint32_t across, uint32_t down) {
        if (is_inside(corner(x, y))) return false;
        (static_cast<float>(right - left) * grid.cell.x > static_cast<float>(bottom - top) * grid.cell.y) ? x += across
                                                                                                          : y += down;
        return true;
    };
    constexpr uint32_t kBack = UINT32_MAX;  // one less
    while (right - left >= kFewest && bottom - top >= kFewest &&
           (cut(left, top, 1, 1) || cut(right, top, kBack, 1) || cut(left, bottom, 1, kBack) ||
            cut(right, bottom, kBack, kBack))) {
    }
    if (right - left < kFewest || bottom - top < kFewest) return std::nullopt;
    return part_of(grid, {left, top, right, bottom}, values);
}

// Returns the cells of a grid that have a shadow, and a border without: a pixel costs its time also where nothing is
// to be seen.
ShadowGrid shown(const ShadowGrid& grid, std::vector<float>& values)
{
    Cells cells = {grid.columns, grid.rows, 0, 0};
    for (uint32_t k = 0; k < grid.size(); ++k) {
        if (values[k] < kFaint) continue;
        const uint32_t x = k % grid.columns, y = k / grid.columns;
        cells = {std::min(cells.left, x), std::min(cells.top, y), std::max(cells.right, x + 1),
                 std::max(cells.bottom, y + 1)};
    }
    const auto before = [](uint32_t at) { return at == 0 ? 0 : at - 1; };
    return part_of(grid,
                   {before(cells.left), before(cells.top), std::min(cells.right + 1, grid.columns),
                    std::min(cells.bottom + 1, grid.rows)},
                   values);
}

float mean_light(const std::vector<Shade>& shades)
{
    double sum = 0, count = 0;
    for (const Shade& shade : shades) {
        for (const float light : shade.light) {
            sum += static_cast<double>(light);
            count += light > 0 ? 1 : 0;
        }
    }
    return static_cast<float>(sum / std::max(count, 1.0));
}

class ShadowMaker
{
public:
    ShadowMaker(const SceneData& scene, const SurfaceSettings& settings, uint32_t most_texels, Job& job)
        : scene_(scene), body_(only_of(scene, 0)), settings_(settings), most_texels_(most_texels), job_(job)
    {
    }

    // Sets `why` where there is none.
    std::optional<PartShadow> made(uint32_t part, std::string& why)
    {
        const PartMovement& movement = scene_.moving.motions[part];
        if (movement.slides) {
            why = "it slides";
            return std::nullopt;
        }
        const std::vector<Vec3> corners = corners_of(scene_, part + 1);
        const std::optional<Receiver> receiver = receiver_of(*body_, movement, corners);
        why = "nothing flat lies across its axis near it";
        if (!receiver) return std::nullopt;
        const ShadowGrid grid = grid_around(corners, *receiver, most_texels_);
        const std::vector<Shade> shades =
            ShadowTracer(scene_, *body_, part, *receiver, grid, settings_.seed).traced(job_);
        const Vec2 shift = best_shift(shades, grid, receiver->gap);
        std::vector<float> mean = aligned_mean(shades, grid, shift);
        double all = 0;
        for (const Shade& shade : shades) all += energy(shade.taken) / kShadowPoses;
        why = "it looks different in each pose";
        if (energy(mean) < kExplained * all) return std::nullopt;
        why = "it reaches out of the sphere";
        const Vec3 moved = receiver->u * shift.x + receiver->v * shift.y;
        constexpr float kInside = 0.999f;
        const std::optional<ShadowGrid> inside = within(
            grid, [&](const Vec2& p) { return length(receiver->at(p) + moved + lift(*receiver)) < kInside; }, mean);
        if (!inside) return std::nullopt;
        why = "it is too faint to be seen";
        if (*std::max_element(mean.begin(), mean.end()) < kFaint) return std::nullopt;
        return shadow_of(part, *receiver, shown(*inside, mean), moved, mean, mean_light(shades));
    }

private:
    static Vec3 lift(const Receiver& receiver) { return receiver.normal * std::min(kLift, 0.4f * receiver.gap); }

    PartShadow shadow_of(uint32_t part, const Receiver& receiver, const ShadowGrid& grid, const Vec3& moved,
                         const std::vector<float>& taken, float light) const
    {
        const EncodedTone tone(scene_.tone);
        PartShadow shadow;
        shadow.part = part;
        shadow.pivot = scene_.moving.motions[part].pivot + moved;
        shadow.corner = receiver.at(grid.low) + moved + lift(receiver);
        shadow.across = receiver.u * (grid.cell.x * static_cast<float>(grid.columns));
        shadow.down = receiver.v * (grid.cell.y * static_cast<float>(grid.rows));
        shadow.columns = grid.columns;
        shadow.rows = grid.rows;
        for (uint32_t k = 0; k < grid.size(); ++k) {
            const float rest = grid.is_border(k) || taken[k] < kFaint ? 1 : 1 - taken[k];
            shadow.passed.push_back(passed_share(tone, light, rest));
        }
        return shadow;
    }

    const SceneData& scene_;
    const std::unique_ptr<SceneData> body_;
    const SurfaceSettings& settings_;
    const uint32_t most_texels_;
    Job& job_;
};

}  // namespace

PartShadows part_shadows(const SceneData& scene, const PatchMesh& mesh, const SurfaceSettings& settings,
                         const ProgressCallback& progress)
{
    constexpr uint64_t kUsualTexels = 1000;
    PartShadows result;
    const auto parts = static_cast<uint32_t>(mesh.parts.size());
    if (parts == 0) return result;
    if (mesh.see_through_patches != 0) {
        result.notes.emplace_back("moving parts cast no shadows beside see-through parts");
        return result;
    }
    Job job(parts * kUsualTexels * 2 * kShadowPoses * kShadowPaths, settings.threads, progress);
    const JobStage stage(job, Stage::mesh, job.part_of_rest(1), parts * kShadowPoses);
    ShadowMaker maker(scene, settings, most_shadow_texels(layout_of(mesh, settings.texels_per_radius).texels), job);
    for (uint32_t part = 0; part < parts; ++part) {
        std::string why;
        if (std::optional<PartShadow> shadow = maker.made(part, why))
            result.shadows.push_back(std::move(*shadow));
        else
            result.notes.push_back("the part '" + mesh.parts[part].name + "' casts no shadow: " + why);
    }
    return result;
}

}  // namespace lumi::baker
