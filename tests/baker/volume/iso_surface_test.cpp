// SPDX-License-Identifier: MIT
// Iso-surfaces: where they lie, which way they face, that they are closed, and which pieces are kept.
#include "volume/iso_surface.h"

#include <catch2/catch.hpp>

#include <map>

#include "scene/model_reader.h"
#include "scene/scene_data.h"
#include "support/nifti_bytes.h"
#include "support/scratch_folder.h"

namespace lumi::baker
{
namespace
{

constexpr uint32_t kVoxels = 24;

// Value f(x, y, z) at voxels; worlds as voxels.
template <class Function>
Grid grid_of(const Function& f)
{
    Grid grid = {kVoxels, kVoxels, kVoxels, {}, {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}}};
    for (uint32_t z = 0; z < kVoxels; ++z) {
        for (uint32_t y = 0; y < kVoxels; ++y)
            for (uint32_t x = 0; x < kVoxels; ++x)
                grid.values.push_back(f(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)));
    }
    return grid;
}

constexpr Vec3 kCentre = {11.3f, 12.1f, 11.7f};

// Falls with the distance from the centre: the surface of -r is a sphere of radius r.
Grid ball_grid()
{
    return grid_of([](float x, float y, float z) { return -length(Vec3{x, y, z} - kCentre); });
}

double volume_of(const Mesh& mesh)
{
    double sum = 0;
    for (size_t t = 0; t < mesh.triangle_count(); ++t)
        sum += static_cast<double>(dot(mesh.position(t, 0), cross(mesh.position(t, 1), mesh.position(t, 2)))) / 6;
    return sum;
}

// Each edge belongs to two triangles that run along it in opposite directions.
bool is_closed(const Mesh& mesh)
{
    std::map<std::pair<uint32_t, uint32_t>, int> edges;
    for (const Mesh::Corners& c : mesh.corners) {
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t a = c[k], b = c[(k + 1) % 3];
            edges[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
        }
    }
    return std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; });
}

TEST_CASE("the iso-surface of a distance is a closed sphere that faces outwards", "[iso]")
{
    constexpr double kRadius = 8;
    Mesh mesh = iso_surface(ball_grid(), static_cast<float>(-kRadius));
    REQUIRE(mesh.triangle_count() > 1000);
    CHECK(is_closed(mesh));
    CHECK(volume_of(mesh) == Approx(4.0 / 3 * 3.14159265 * kRadius * kRadius * kRadius).epsilon(0.025));
    add_smooth_normals(mesh);
    double worst_distance = 0, worst_normal = 1;
    for (size_t k = 0; k < mesh.positions.size(); ++k) {
        const Vec3 r = mesh.positions[k] - kCentre;
        worst_distance = std::max(worst_distance, std::abs(static_cast<double>(length(r)) - kRadius));
        worst_normal = std::min(worst_normal, static_cast<double>(dot(mesh.normals[k], r) / length(r)));
    }
    CHECK(worst_distance < 0.1);  // voxels
    CHECK(worst_normal > 0.98);
}

TEST_CASE("a grid's matrix moves its surface, and mirrored grids face outwards too", "[iso]")
{
    Grid grid = ball_grid();
    const double before = volume_of(iso_surface(grid, -8));
    grid.voxel_to_world = {{{-2, 0, 0, 5}, {0, 0, 1, 0}, {0, 3, 0, 0}}};
    CHECK(volume_of(iso_surface(grid, -8)) == Approx(6 * before).epsilon(1e-3));
    grid.voxel_to_world[0][0] = 2;
    const Mesh mirrored = iso_surface(grid, -8);
    CHECK(volume_of(mirrored) == Approx(6 * before).epsilon(1e-3));
    Vec3 low = mirrored.positions[0];
    for (const Vec3& p : mirrored.positions) low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    CHECK(low.x == Approx(2 * (kCentre.x - 8) + 5).margin(0.2));
    CHECK(low.z == Approx(3 * (kCentre.y - 8)).margin(0.3));
}

TEST_CASE("a surface that leaves the grid is closed by a flat cut at its border", "[iso]")
{
    const Mesh mesh = iso_surface(grid_of([](float x, float y, float) {
                                      return -length(Vec3{x, y, 0} - kCentre);
                                  }),
                                  -13.7f);
    CHECK(is_closed(mesh));
    for (const Vec3& p : mesh.positions) CHECK((p.z > -0.01f && p.z < static_cast<float>(kVoxels) - 0.99f));
    // All of the grid, when everything lies above.
    const Mesh all = iso_surface(grid_of([](float, float, float) { return 1.0f; }), 0);
    CHECK(is_closed(all));
    constexpr double kEdge = kVoxels - 1;
    CHECK(volume_of(all) == Approx(kEdge * kEdge * kEdge).epsilon(0.02));
}

TEST_CASE("a surface without values on both sides is empty", "[iso]")
{
    CHECK(iso_surface(ball_grid(), 1).corners.empty());
}

Mesh two_balls()
{
    return iso_surface(grid_of([](float x, float y, float z) {
                           return std::max(6 - length(Vec3{x, y, z} - Vec3{8.2f, 8.1f, 7.9f}),
                                           2 - length(Vec3{x, y, z} - Vec3{19.9f, 20.1f, 20.2f}));
                       }),
                       0);
}

TEST_CASE("pieces smaller than the share are left out", "[iso]")
{
    const double whole = volume_of(two_balls());
    Mesh mesh = two_balls();
    keep_large_pieces(mesh, 0.05);  // the small one has a ninth of the area
    CHECK(volume_of(mesh) == Approx(whole));
    keep_large_pieces(mesh, 0.2);
    CHECK(volume_of(mesh) == Approx(whole * 27 / 28).epsilon(0.01));
    CHECK(is_closed(mesh));
    for (const Vec3& p : mesh.positions) CHECK(p.x < 15);
    Mesh none;
    keep_large_pieces(none, 0.5);
    CHECK(none.corners.empty());
}

std::string ball_file()
{
    return testing::nifti_int16(
        {20, 20, 20},
        [](int x, int y, int z) {
            const int dx = x - 10, dy = y - 10, dz = z - 10;
            return 1000 - 10 * (dx * dx + dy * dy + dz * dz);
        });
}

TEST_CASE("a volume's file is a scene by its iso-surface, upright along z", "[iso]")
{
    const testing::ScratchFolder folder;
    const std::filesystem::path file = folder.write("ball.nii", ball_file());
    std::vector<std::string> warnings;
    LoadOptions options;
    options.iso = {600, 0.05};  // 40 voxels² of 2 mm each
    const Scene scene = load_scene(file, options, warnings);
    CHECK(warnings.empty());
    CHECK(scene.up() == UpAxis::z);
    CHECK(scene.radius() == Approx(2 * 6.32 * 1.01).epsilon(0.01));
    CHECK(scene.centre()[2] == Approx(20).margin(0.05));
    CHECK(scene.fingerprint() == load_scene(file, options, warnings).fingerprint());
    options.up = UpAxis::y;
    CHECK(load_scene(file, options, warnings).up() == UpAxis::y);
}

TEST_CASE("an iso-surface that cannot be is refused with the range of values", "[iso]")
{
    const testing::ScratchFolder folder;
    const std::filesystem::path file = folder.write("ball.nii", ball_file());
    std::vector<std::string> warnings;
    LoadOptions options;
    CHECK_THROWS_WITH(load_scene(file, options, warnings),
                      Catch::Contains("ball.nii: ") && Catch::Contains("--iso, from -2000 to 1000"));
    options.iso = {5000, 0.05};
    CHECK_THROWS_WITH(load_scene(file, options, warnings),
                      Catch::Contains("5000") && Catch::Contains("-2000 to 1000; choose one between"));
    const std::filesystem::path obj = folder.write("o.obj", "v 0 0 0\nv 1 0 0\nv 1 0 1\nf 1 2 3\n");
    CHECK_THROWS_WITH(load_scene(obj, options, warnings),
                      Catch::Contains("no volume") && Catch::Contains("; leave out"));
}

TEST_CASE("volumes of other formats are refused with the command that converts them", "[iso]")
{
    const testing::ScratchFolder folder;
    std::vector<std::string> warnings;
    LoadOptions options;
    for (const std::optional<IsoSurface> iso : {std::optional<IsoSurface>(), std::optional<IsoSurface>({300, 0.05})}) {
        options.iso = iso;
        const std::filesystem::path nrrd = folder.write("a.nrrd", "NRRD0004");
        CHECK_THROWS_WITH(load_scene(nrrd, options, warnings),
                          Catch::Contains("a.nrrd: volumes are read from .nii") &&
                              Catch::Contains("--input " + nrrd.string() + " --output-img"));
        CHECK_THROWS_WITH(load_scene(folder.write("a.dcm", ""), options, warnings),
                          Catch::Contains("this series: plastimatch convert --input FOLDER "));
    }
    folder.write("b.nrrd", "NRRD0004");
    const std::filesystem::path scene = folder.write("s.json", R"({"objects": [{"volume": "b.nrrd", "iso": 1}]})");
    CHECK_THROWS_WITH(load_scene(scene, {}, warnings), Catch::Contains("b.nrrd --output-img volume.nii.gz"));
}

TEST_CASE("a scene file takes iso-surfaces as objects", "[iso]")
{
    const testing::ScratchFolder folder;
    folder.write("ball.nii", ball_file());
    const auto read = [&](const std::string& object) {
        std::vector<std::string> warnings;
        return load_scene(folder.write("s.json", "{\"objects\": [\n" + object + "]}"), {}, warnings);
    };
    const Scene scene = read(R"({"volume": "ball.nii", "iso": 600},
        {"volume": "ball.nii", "iso": 900, "scale": 2, "pieces": 0.5, "material": {"metal": "gold"}})");
    const std::vector<Material>& materials = scene.data().materials;
    REQUIRE(materials.size() == 2);
    CHECK((materials[0].metalness == 0 && materials[1].metalness == 1));
    CHECK(scene.up() == UpAxis::y);
    const auto check_refused = [&](const std::string& object, const std::string& what) {
        INFO(object);
        CHECK_THROWS_WITH(read(object), Catch::Contains(what) && Catch::Contains("; "));
    };
    check_refused(R"({"volume": "ball.nii"})", "s.json:2: ");
    check_refused(R"({"volume": "none.nii", "iso": 1})", "s.json:2: the volume 'none.nii' is missing");
    check_refused(R"({"volume": "ball.nii", "iso": 1, "pieces": 2})", "s.json:2: 'pieces'");
    check_refused(R"({"volume": "ball.nii", "iso": 1, "obj": "o.obj"})", "s.json:2: ");
    check_refused(R"({"volume": "ball.nii", "iso": 7000})", "-2000 to 1000");
}

}  // namespace
}  // namespace lumi::baker
