// SPDX-License-Identifier: MIT
// A scene to bake: triangles, materials and lights inside a bounding sphere.
//
// The scene keeps its own copy of everything; files may vanish after loading. A Scene is immutable and may be traced
// from any number of threads.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace lumi::baker
{

// What a file says cannot be baked. what() reads "file:line: what is wrong; how to mend it"; the line is left out where
// the fault has none.
struct SceneError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The axis of the scene that becomes the sphere's z, its north pole. y: sphere(x,y,z) = scene(z,x,y); z: identity.
enum class UpAxis : uint8_t { y, z };

// Linear radiance (Rec. 709 primaries) that arrives from far away: linear in the height of the direction from nadir
// over horizon to zenith. It lights the scene; rays of the field and of the reference never see it directly.
struct Environment {
    std::array<float, 3> zenith, horizon, nadir;
};

Environment constant_environment(float radiance);
// A bright, slightly cool sky over a dimmer, warm floor.
Environment studio_environment();

struct LoadOptions {
    UpAxis up = UpAxis::y;
    // The sphere's radius is the smallest one around all triangles times (1 + margin), so that nothing touches it. >=
    // 0.
    double margin = 0.01;
    // The studio by default, also for scenes with emissive materials: a lamp on a product rarely lights it all. A room
    // with lamps of its own wants constant_environment(0).
    Environment environment = studio_environment();
};

struct SceneData;  // baker's own view, see baker/src

class Scene
{
public:
    explicit Scene(std::unique_ptr<const SceneData> data);
    Scene(Scene&&) noexcept;
    Scene& operator=(Scene&&) noexcept;
    ~Scene();

    // The bounding sphere in scene units and scene axes, margin included.
    std::array<float, 3> centre() const;
    float radius() const;
    UpAxis up() const;

    size_t triangle_count() const;
    size_t material_count() const;
    size_t light_count() const;  // emissive triangles

    const SceneData& data() const { return *data_; }

private:
    std::unique_ptr<const SceneData> data_;
};

// Reads an OBJ file with its MTL files and textures. Throws SceneError. Appends one line per doubtful thing that could
// still be drawn, each in the form of SceneError's text, to `warnings`.
Scene load_scene(const std::filesystem::path& obj, const LoadOptions& options, std::vector<std::string>& warnings);

}  // namespace lumi::baker
