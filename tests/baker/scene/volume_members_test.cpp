// SPDX-License-Identifier: MIT
// The volume of a scene file: what its members do, and that every fault is named with its line and its mend.
#include <catch2/catch.hpp>

#include "scene/scene_file.h"
#include "support/nifti_bytes.h"
#include "support/scratch_folder.h"
#include "volume/affine.h"

namespace lumi::baker
{
namespace
{

using testing::ScratchFolder;

constexpr char kPoints[] = R"("transfer": [{"value": 0, "density": 0}, {"value": 20, "density": 3, "colour": 0.5}])";

SceneParts read_volume_scene(const std::string& json)
{
    const ScratchFolder folder;
    folder.write("v.nii", testing::nifti_int16({4, 5, 6}, [](int x, int, int z) { return 10 * x + z; }));
    std::vector<std::string> warnings;
    return read_scene_file(folder.write("s.json", json), std::nullopt, warnings);
}

void check_volume_refused(const std::string& volume, const std::string& what)
{
    const std::string json = "{\"up\": \"z\",\n\"volume\": " + volume + "}";
    INFO(json);
    CHECK_THROWS_WITH(read_volume_scene(json),
                      Catch::Contains("s.json:2: ") && Catch::Contains(what) && Catch::Contains("; "));
}

void check_points_refused(const std::string& points, const std::string& what)
{
    check_volume_refused(R"({"file": "v.nii", "transfer": )" + points + "}", what);
}

}  // namespace

TEST_CASE("volume of a scene file: it is read, scaled, turned and moved, and needs no objects")
{
    const SceneParts parts =
        read_volume_scene(std::string(R"({"volume": {"file": "v.nii", "anisotropy": 0.25, "scale": 0.5,
        "rotate": [0, 0, 90], "translate": [1, 2, 3], )") +
                          kPoints + "}}");
    REQUIRE(parts.volume);
    CHECK(parts.mesh.triangle_count() == 0);
    const Volume& volume = *parts.volume;
    CHECK(volume.anisotropy == 0.25f);
    CHECK(volume.transfer.points()[0].colour.g == 1);
    CHECK(volume.transfer.points()[1].colour.g == 0.5f);
    CHECK(volume.transfer.density(10) == 1.5f);
    CHECK(volume.grid.values[1] == 10);
    // Voxels of 2 mm: the step along x becomes one along y.
    const std::array<double, 3> from = point_of(volume.grid.voxel_to_world, 0, 0, 0);
    const std::array<double, 3> to = point_of(volume.grid.voxel_to_world, 1, 0, 0);
    CHECK(to[0] - from[0] == Approx(0).margin(1e-6));
    CHECK(to[1] - from[1] == Approx(1).margin(1e-6));
    CHECK(to[2] - from[2] == Approx(0).margin(1e-6));
}

TEST_CASE("volume of a scene file: what cannot be is refused with its line")
{
    const std::string points = kPoints;
    check_volume_refused("[]", "the volume must be an object");
    check_volume_refused("{" + points + "}", "no 'file'");
    check_volume_refused(R"({"file": "none.nii", )" + points + "}", "'none.nii' is missing");
    check_volume_refused(R"({"file": "v.nii"})", "no 'transfer'");
    check_volume_refused(R"({"file": "v.nii", "smoke": 1, )" + points + "}", "smoke");
    check_volume_refused(R"({"file": "v.nii", "anisotropy": 1, )" + points + "}", "-0.95 to 0.95");
    check_volume_refused(R"({"file": "v.nii", "scale": 0, )" + points + "}", "flattens");
    check_points_refused("[]", "must be a list of points");
    check_points_refused("{}", "must be a list of points");
    check_points_refused("[1]", "must be an object");
    check_points_refused(R"([{"value": 1}])", "no 'density'");
    check_points_refused(R"([{"density": 1}])", "no 'value'");
    check_points_refused(R"([{"value": 1, "density": -1}])", "0 to 1e+09");
    check_points_refused(R"([{"value": 1e39, "density": 1}])", "1e+30");
    check_points_refused(R"([{"value": 1, "density": 1, "colour": [1, 2, 0]}])", "0 to 1");
    check_points_refused(R"([{"value": 1, "density": 1}, {"value": 1, "density": 2}])", "must grow");
    check_points_refused(R"([{"value": 2, "density": 1}, {"value": 1, "density": 2}])", "must grow");
    check_points_refused(R"([{"value": 1, "density": 1}, {"value": 1.00000001, "density": 2}])", "must grow");
    check_points_refused(R"([{"value": 1, "density": 0}, {"value": 2, "density": 0}])", "0 to 35");
    check_points_refused(R"([{"value": 40, "density": 0}, {"value": 50, "density": 1}])", "give some of them more");
}

TEST_CASE("volume of a scene file: a ground lies under its lowest part that is not empty")
{
    const SceneParts parts =
        read_volume_scene(std::string(R"({"up": "z", "volume": {"file": "v.nii", "translate": [0, 0, -7], )") +
                          kPoints + R"(}, "ground": {"radius": 9}})");
    CHECK(static_cast<double>(parts.mesh.positions[0].z) ==
          Approx(point_of(parts.volume->grid.voxel_to_world, 0, 0, 0)[2]));
}

}  // namespace lumi::baker
