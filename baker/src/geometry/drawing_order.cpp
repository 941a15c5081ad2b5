// SPDX-License-Identifier: MIT
#include "geometry/drawing_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "geometry/accelerator.h"
#include "math/sampler.h"
#include "math/warp.h"

namespace lumi::baker
{
namespace
{

constexpr int kMostPasses = 6;     // over all faces; later ones hardly gain
constexpr float kInPlane = 1e-4f;  // radii; nearer to a plane is neither before nor behind it
constexpr uint32_t kEyes = 64, kRaysAnEye = 512;
constexpr float kEyeDistance = 3;    // radii
constexpr float kNextLayer = 1e-5f;  // radii; nearer layers are one
constexpr uint64_t kFaultsSeed = 0x6F726465;

// A triangle as light sees it.
struct Emitter {
    std::array<Vec3, 3> places;  // one for each third of it
    Vec3 normal;
    float area;
};

Emitter emitter(const Mesh& mesh, uint32_t triangle)
{
    const Vec3 twice = mesh.area_vector(triangle);
    const float length_of_it = length(twice);
    Emitter e{{}, length_of_it > 0 ? twice * (1 / length_of_it) : Vec3{}, length_of_it / 2};
    for (size_t k = 0; k < 3; ++k)
        e.places[k] = mesh.position(triangle, k) * (2 / 3.0f) +
                      (mesh.position(triangle, (k + 1) % 3) + mesh.position(triangle, (k + 2) % 3)) * (1 / 6.0f);
    return e;
}

// How much light passes both triangles and comes to where both are seen: positive where a is the later one.
float light_through(const Emitter& a, const Emitter& b)
{
    const float least = 0.25f * (a.area + b.area);  // places stand for areas, which may meet
    float sum = 0;
    for (const Vec3& p : a.places) {
        for (const Vec3& q : b.places) {
            const Vec3 way = p - q;
            const float before_a = dot(way, a.normal), before_b = dot(way, b.normal);
            const bool is_a_later = before_a > kInPlane && before_b > kInPlane;
            if (!is_a_later && !(before_a < -kInPlane && before_b < -kInPlane)) continue;
            const float apart = dot(way, way) + least;
            sum += (is_a_later ? 1.0f : -1.0f) * before_a * before_b / (apart * apart);
        }
    }
    return sum * a.area * b.area;
}

// For each pair of faces how much light is right if the first is drawn later, less what is then wrong.
class Gains
{
public:
    Gains(const OneSidedFaces& faces, Job& job) : count_(faces.count()), gains_(size_t{count_} * count_, 0.0f)
    {
        std::vector<Emitter> emitters;
        std::vector<uint32_t> begins(count_ + 1, 0);
        for (uint32_t k = 0; k < faces.face_of.size(); ++k) {
            emitters.push_back(emitter(faces.triangles, k));
            begins[faces.face_of[k] + 1] = k + 1;
        }
        job.run(count_, [&](uint32_t face) {
            float* const row = gains_.data() + size_t{face} * count_;
            for (uint32_t a = begins[face]; a < begins[face + 1] && !job.stopping(); ++a)
                for (uint32_t b = 0; b < emitters.size(); ++b)
                    if (faces.face_of[b] != face) row[faces.face_of[b]] += light_through(emitters[a], emitters[b]);
        });
    }

    const float* of(uint32_t face) const { return gains_.data() + size_t{face} * count_; }
    uint32_t count() const { return count_; }

private:
    uint32_t count_;
    std::vector<float> gains_;
};

// Faces by how much of their light passes others before them.
std::vector<uint32_t> first_guess(const Gains& gains)
{
    std::vector<float> lateness;
    for (uint32_t face = 0; face < gains.count(); ++face) {
        const float* const row = gains.of(face);
        float sum = 0, all = 0;
        for (uint32_t k = 0; k < gains.count(); ++k) {
            sum += row[k];
            all += std::abs(row[k]);
        }
        lateness.push_back(all > 0 ? sum / all : 0);
    }
    std::vector<uint32_t> order(gains.count());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return lateness[a] < lateness[b]; });
    return order;
}

// Moves the face at a place of the order to where most light is right; tells whether it moved.
bool settle(const Gains& gains, std::vector<uint32_t>& order, uint32_t at)
{
    const float* const row = gains.of(order[at]);
    float best = 0, gain = 0;
    uint32_t to = at;
    const auto keep_best = [&](uint32_t k) {
        if (gain > best) {
            best = gain;
            to = k;
        }
    };
    for (uint32_t k = at + 1; k < order.size(); ++k) {
        gain += row[order[k]];
        keep_best(k);
    }
    gain = 0;
    for (uint32_t k = at; k-- > 0;) {
        gain -= row[order[k]];
        keep_best(k);
    }
    const auto place = [&](uint32_t k) { return order.begin() + static_cast<std::ptrdiff_t>(k); };
    if (to > at) std::rotate(place(at), place(at) + 1, place(to) + 1);
    if (to < at) std::rotate(place(to), place(at), place(at) + 1);
    return to != at;
}

// A triangle's nearest corner, along the axis of a camera that looks at the centre.
float depth_of(const Mesh& mesh, uint32_t triangle, const Vec3& eye)
{
    const auto depth = [&](size_t corner) { return kEyeDistance - dot(mesh.position(triangle, corner), eye); };
    return std::min({depth(0), depth(1), depth(2)});
}

struct Pairs {
    uint32_t all = 0, in_order = 0, by_depth = 0;  // the last two: wrong ones
};

// The pairs along a ray that comes from an eye in this direction.
void count_pairs(const OneSidedFaces& faces, const Accelerator& accelerator, const std::vector<uint32_t>& places,
                 const Vec3& eye, Ray ray, Pairs& pairs)
{
    const auto is_wrong = [&](uint32_t front, uint32_t behind) {
        const uint32_t a = faces.face_of[front], b = faces.face_of[behind];
        return a == b ? front < behind : places[a] < places[b];
    };
    std::optional<uint32_t> front;
    while (const std::optional<Hit> hit = accelerator.closest(ray)) {
        if (front) {
            ++pairs.all;
            pairs.in_order += is_wrong(*front, hit->triangle) ? 1u : 0u;
            const Mesh& mesh = faces.triangles;
            pairs.by_depth += depth_of(mesh, *front, eye) > depth_of(mesh, hit->triangle, eye) ? 1u : 0u;
        }
        front = hit->triangle;
        ray.origin = ray.origin + ray.direction * (hit->distance + kNextLayer);
    }
}

}  // namespace

std::vector<uint32_t> drawing_order(const OneSidedFaces& faces, Job& job)
{
    const Gains gains(faces, job);
    std::vector<uint32_t> order = first_guess(gains);
    for (int pass = 0; pass < kMostPasses; ++pass) {
        const std::vector<uint32_t> before = order;
        bool has_moved = false;
        for (const uint32_t face : before) {
            const auto at = std::find(order.begin(), order.end(), face) - order.begin();
            has_moved = settle(gains, order, static_cast<uint32_t>(at)) || has_moved;
        }
        if (!has_moved) break;
    }
    return order;
}

OrderFaults order_faults(const OneSidedFaces& faces, const std::vector<uint32_t>& order, Job& job)
{
    if (order.empty()) return {};
    const Accelerator accelerator(faces.triangles, Faces::front);
    std::vector<uint32_t> places(order.size());
    for (uint32_t k = 0; k < order.size(); ++k) places[order[k]] = k;
    std::vector<Pairs> found(kEyes);
    job.run(kEyes, [&](uint32_t i) {
        Sampler sampler(kFaultsSeed, i, 0);
        sampler.start(0);
        const Vec2 square = sampler.next_2d();
        const Vec3 eye = square_to_sphere(square);
        for (uint32_t k = 0; k < kRaysAnEye && !job.stopping(); ++k) {
            sampler.start(k + 1);
            const Vec2 on_sphere = sampler.next_2d();
            const Vec3 target = square_to_sphere(on_sphere) * std::cbrt(sampler.next_1d());
            const Vec3 from = eye * kEyeDistance;
            count_pairs(faces, accelerator, places, eye, {from, normalized(target - from)}, found[i]);
        }
    });
    Pairs sum;
    for (const Pairs& p : found) sum = {sum.all + p.all, sum.in_order + p.in_order, sum.by_depth + p.by_depth};
    const double all = std::max(1u, sum.all);
    return {sum.all, sum.in_order / all, sum.by_depth / all};
}

}  // namespace lumi::baker
