// SPDX-License-Identifier: MIT
#include "scene/doubts.h"

#include <algorithm>
#include <cmath>

#include "geometry/components.h"
#include "geometry/open_edges.h"
#include "math/sampler.h"
#include "math/vec3.h"
#include "math/warp.h"
#include "util/fuzzed.h"
#include "util/text_lines.h"

namespace lumi::baker
{
namespace
{

// How far parts reach on each side: +x, +y, +z, -x, -y, -z.
using Reach = std::array<float, 6>;

Reach reach_of(const Vec3& p)
{
    return {p.x, p.y, p.z, -p.x, -p.y, -p.z};
}

float half_diagonal(const Reach& r)
{
    return length({r[0] + r[3], r[1] + r[4], r[2] + r[5]}) / 2;
}

// Triangles that hang together.
struct Part {
    Reach reach;
    size_t triangles = 0;
    uint32_t material = 0;
};

// The farthest on a side, and how far the others reach.
struct Farthest {
    size_t part = 0;
    float first = -std::numeric_limits<float>::infinity(), second = first;

    void add(size_t k, float value)
    {
        second = std::max(second, std::min(value, first));
        part = value > first ? k : part;
        first = std::max(first, value);
    }
    float without(size_t k) const { return k == part ? second : first; }
};

std::vector<Part> parts_of(const Mesh& mesh, const std::vector<Mesh::Corners>& places)
{
    DisjointSets sets(mesh.positions.size());
    for (const Mesh::Corners& c : places) {
        sets.join(c[1], c[0]);
        sets.join(c[2], c[0]);
    }
    std::vector<uint32_t> numbers(mesh.positions.size(), 0);  // parts have them, from 1 on, by root
    std::vector<Part> parts;
    for (size_t t = 0; t < places.size(); ++t) {
        uint32_t& number = numbers[sets.root(places[t][0])];
        if (number == 0) {
            parts.push_back({reach_of(mesh.position(t, 0)), 0, mesh.materials[t]});
            number = static_cast<uint32_t>(parts.size());
        }
        Part& part = parts[number - 1];
        ++part.triangles;
        for (size_t k = 0; k < 3; ++k) {
            const Reach reach = reach_of(mesh.position(t, k));
            for (size_t side = 0; side < reach.size(); ++side)
                part.reach[side] = std::max(part.reach[side], reach[side]);
        }
    }
    return parts;
}

class Doubts
{
public:
    Doubts(const SceneData& scene, const std::filesystem::path& file, std::vector<std::string>& warnings)
        : scene_(scene), places_(places_of(scene.mesh)), file_(file), warnings_(warnings)
    {
    }

    // Where nothing is lit at all, the choice of light has said so.
    void look_at_lamps()
    {
        if (!scene_.choice.warnings.empty()) return;
        const std::vector<Vec3> lamps = scene_.lights.positions();
        const auto enclosed =
            std::count_if(lamps.begin(), lamps.end(), [&](const Vec3& lamp) { return !light_leaves(lamp); });
        if (enclosed != 0) {
            warn(std::to_string(enclosed) +
                 " lamp(s) are inside closed bodies, and none of their light comes out; move them, or open the body");
        }
    }

    void look_for_something_opaque()
    {
        constexpr float kNothing = 1.0f / 255;
        const auto& m = scene_.mesh.materials;
        const bool nothing = std::all_of(m.begin(), m.end(), [&](uint32_t material) {
            const Material& of = scene_.materials[material];
            return of.opacity < kNothing && !of.glass && !of.maps.opacity.used();
        });
        if (nothing && !m.empty() && !scene_.medium)
            warn("all of it is transparent, and nothing will be seen; give a material an opacity above 0 ('d' in MTL)");
    }

    // Every eye sees the whole sphere. Only the farthest parts can make the others tiny.
    void look_for_tiny_rest()
    {
        const std::vector<Part> parts = parts_of(scene_.mesh, places_);
        if (parts.size() < 2) return;
        std::array<Farthest, 6> farthest;
        for (size_t k = 0; k < parts.size(); ++k)
            for (size_t side = 0; side < farthest.size(); ++side) farthest[side].add(k, parts[k].reach[side]);
        const auto size_without = [&](size_t part) {
            Reach reach;
            for (size_t side = 0; side < reach.size(); ++side) reach[side] = farthest[side].without(part);
            return half_diagonal(reach);
        };
        const float whole = size_without(parts.size());
        const Part* found = nullptr;
        float rest = 0;
        for (const Farthest& side : farthest) {
            constexpr float kTiny = 0.1f;
            const Part& part = parts[side.part];
            if (size_without(side.part) > kTiny * whole || (found && found->triangles <= part.triangles)) continue;
            found = &part;
            rest = size_without(side.part);
        }
        if (found) tell_tiny_rest(*found, rest / whole);
    }

    void look_for_coinciding_faces()
    {
        std::vector<std::pair<Mesh::Corners, uint32_t>> faces;  // with its material
        for (size_t t = 0; t < places_.size(); ++t) {
            faces.emplace_back(places_[t], scene_.mesh.materials[t]);
            std::sort(faces.back().first.begin(), faces.back().first.end());
        }
        std::sort(faces.begin(), faces.end());
        size_t count = 0;
        for (size_t k = 1; k < faces.size(); ++k)
            count += faces[k].first == faces[k - 1].first && faces[k].second != faces[k - 1].second ? 1u : 0u;
        if (count != 0) {
            warn(std::to_string(count) +
                 " face(s) coincide with one of another material, and chance decides what is seen; delete one of them");
        }
    }

    void look_for_open_glass()
    {
        const auto& materials = scene_.materials;
        if (std::none_of(materials.begin(), materials.end(), [](const Material& m) { return m.glass; })) return;
        const std::vector<size_t> edges = open_edges(scene_.mesh, places_, materials.size());
        size_t open = 0;
        for (size_t k = 0; k < materials.size(); ++k) open += materials[k].glass ? edges[k] : 0;
        if (open != 0) {
            warn("glass is open at " + std::to_string(open) +
                 " edge(s), and light is lost there; close its body: give panes a thickness (in Blender: Solidify)");
        }
    }

    void look_at_digits(const std::array<double, 3>& origin)
    {
        double farthest = 0;
        for (size_t k = 0; k < 3; ++k) farthest = std::max(farthest, std::abs(scene_.centre[k] - origin[k]));
        const double step = std::ldexp(farthest, -24);
        constexpr double kCoarse = 1.0 / 4096;
        if (step > kCoarse * scene_.radius) {
            warn("it lies so far from its origin that coordinates have steps of " +
                 number_text(100 * step / scene_.radius) + " % of its radius; move it to the origin before the export");
        }
    }

private:
    void tell_tiny_rest(const Part& part, float share)
    {
        const std::string& name = scene_.materials[part.material].name;
        const double percent = std::ceil(static_cast<double>(share) * 1000) / 10;
        warn(
            "one part of " + std::to_string(part.triangles) + " triangle(s)" +
            (name.empty() ? "" : " of the material '" + name + "'") + " makes the rest tiny: it fills " +
            number_text(percent) +
            " % of the picture's width; leave the part out, let it end near the rest, or name what matters by --frame");
    }

    void warn(const std::string& text) { warnings_.push_back(at({file_.string()}, text)); }

    // Whether some path of diffuse reflections gets out, or through something.
    bool light_leaves(const Vec3& lamp) const
    {
        constexpr uint32_t kPaths = kIsFuzzed ? 4 : 256, kBounces = 64;
        constexpr uint64_t kSeed = 0x6c616d70;
        Sampler sampler(kSeed, 0, 0);
        for (uint32_t path = 0; path < kPaths; ++path) {
            sampler.start(path);
            Ray ray = {lamp, square_to_sphere(sampler.next_2d())};
            for (uint32_t bounce = 0; bounce < kBounces; ++bounce) {
                const std::optional<Hit> hit = scene_.accelerator.closest(ray);
                if (!hit) return true;
                const Material& m = scene_.materials[scene_.mesh.materials[hit->triangle]];
                if (m.glass || m.may_pass()) return true;
                ray = reflected(ray, *hit, sampler);
            }
        }
        return false;
    }

    // Away from the side that was met.
    Ray reflected(const Ray& ray, const Hit& hit, Sampler& sampler) const
    {
        Vec3 n = normalized(scene_.mesh.area_vector(hit.triangle));
        if (dot(n, ray.direction) > 0) n = -n;
        constexpr float kOff = 1e-5f;
        return {ray.origin + ray.direction * hit.distance + n * kOff,
                Frame(n).to_world(square_to_cosine_hemisphere(sampler.next_2d()))};
    }

    const SceneData& scene_;
    std::vector<Mesh::Corners> places_;
    const std::filesystem::path& file_;
    std::vector<std::string>& warnings_;
};

}  // namespace

void report_doubts(const SceneData& scene, const std::array<double, 3>& origin, const std::filesystem::path& file,
                   std::vector<std::string>& warnings)
{
    if (scene.mesh_is_shell) return;
    Doubts doubts(scene, file, warnings);
    doubts.look_at_lamps();
    doubts.look_for_something_opaque();
    doubts.look_for_tiny_rest();
    doubts.look_for_coinciding_faces();
    doubts.look_for_open_glass();
    doubts.look_at_digits(origin);
}

}  // namespace lumi::baker
