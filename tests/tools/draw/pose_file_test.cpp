// SPDX-License-Identifier: MIT
#include "draw/pose_file.h"

#include <catch2/catch.hpp>
#include <cstdio>

#include "image/picture_file.h"
#include "lumi/host/camera.h"
#include "support/program.h"
#include "support/temporary_folder.h"
#include "support/test_field.h"
#include "terminal/failure.h"

namespace lumi::tools
{

namespace
{

// The matrix of an orbit, as text with that many digits.
std::string matrix_of(const Pose& p, int digits)
{
    const auto axis = [](int32_t v) { return static_cast<double>(v) / kOneQ30; };
    const auto place = [](int32_t v) { return static_cast<double>(v) / kOneQ20; };
    char text[400];
    std::snprintf(text, sizeof text,
                  "[[%.*f, %.*f, %.*f, %.*f],\n[%.*f %.*f %.*f %.*f]\r\n%.*f;%.*f;%.*f;%.*f\n0 0 0 1\n", digits,
                  axis(p.right.x), digits, axis(p.up.x), digits, -axis(p.forward.x), digits, place(p.eye.x), digits,
                  axis(p.right.y), digits, axis(p.up.y), digits, -axis(p.forward.y), digits, place(p.eye.y), digits,
                  axis(p.right.z), digits, axis(p.up.z), digits, -axis(p.forward.z), digits, place(p.eye.z));
    return text;
}

int32_t furthest(const Vec3q30& a, const Vec3q30& b)
{
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

const std::string kRigid = "1 0 0 0\n0 1 0 0\n0 0 1 3\n0 0 0 1\n";

}  // namespace

TEST_CASE("a pose file: the matrix of an orbit is that orbit, and few digits are made rigid")
{
    const test::TemporaryFolder folder;
    const std::string file = folder / "pose.txt";
    for (const host::Orbit& orbit : {host::Orbit{30, 20, 3}, {-140, -75, 2.5}, {0, 0, 1.5}}) {
        const Pose pose = host::make_pose(orbit);
        test::write_content(file, matrix_of(pose, 9));
        const Pose read = pose_of(read_matrix(file), file);
        CHECK(furthest(read.right, pose.right) < 8);
        CHECK(furthest(read.up, pose.up) < 8);
        CHECK(furthest(read.forward, pose.forward) < 8);
        CHECK(std::abs(read.eye.x - pose.eye.x) <= 1);
        test::write_content(file, matrix_of(pose, 4));
        Camera camera;
        const Pose coarse = pose_of(read_matrix(file), file);
        CHECK(make_camera(coarse, host::make_image(24, 24, 40), camera) == CameraError::none);
    }
}

TEST_CASE("a pose file that is no rigid matrix is refused with the line or the mend")
{
    const test::TemporaryFolder folder;
    const std::string file = folder / "pose.txt";
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"1 0 0 0\n0 one 0 0\n", "line 2: \"one\" is no number"},
        {"1 0 0 nan\n", "line 1: \"nan\" is no number"},
        {"1 0 0 1e999\n", "is no number"},
        {"", "holds 0 numbers"},
        {"1 0 0 0\n0 1 0 0\n0 0 1 3\n", "holds 12 numbers"},
        {kRigid + "5", "holds more than 16 numbers"},
        {"1 0 0 0 0 1 0 0 0 0 1 0 0 0 3 1", "transpose it"},
        {"2 0 0 0 0 2 0 0 0 0 2 3 0 0 0 1", "take its scale out"},
        {"0 0 0 0 0 0 0 0 0 0 0 3 0 0 0 1", "take its scale out"},
        {"1 0.6 0 0 0 0.8 0 0 0 0 1 3 0 0 0 1", "take its shear out"},
        {"-1 0 0 0 0 1 0 0 0 0 1 3 0 0 0 1", "mirrors"},
        {"1 0 0 0 0 1 0 0 0 0 1 1e6 0 0 0 1", "radii of the sphere"},
    };
    for (const auto& [text, hint] : cases) {
        INFO(text);
        test::write_content(file, text);
        CHECK_THROWS_WITH(pose_of(read_matrix(file), file), Catch::Contains("pose.txt: ") && Catch::Contains(hint));
    }
    CHECK_THROWS_WITH(read_matrix(folder / "none"), Catch::Contains("cannot be read"));
}

TEST_CASE("a pose from a device that has no end is refused")
{
    CHECK_THROWS_WITH(read_matrix("/dev/zero"), Catch::Contains("/dev/zero: is longer than any 16 numbers; give"));
}

TEST_CASE("a pose draws what its orbit draws, and --over shows the photograph where nothing covers")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "f.lumi", test::field_bytes({}));
    test::write_content(folder / "pose.txt", matrix_of(host::make_pose({30, 20, 3}), 9));
    const auto render = [&](const std::string& name, test::Arguments more) {
        more.insert(more.begin(), {"render", folder / "f.lumi", "-o", folder / name});
        done(test::lumi(more));
        return read_png(folder / name);
    };
    CHECK(render("a.png", {"--pose", folder / "pose.txt", "--size", "48x32"}).rgb ==
          render("b.png", {"--orbit", "30,20,3", "--size", "48x32"}).rgb);

    Picture photo(48, 32);
    for (size_t i = 0; i < photo.rgb.size(); ++i) photo.rgb[i] = static_cast<uint8_t>(i * 7);
    write_png(folder / "photo.png", photo);
    const Picture over = render("c.png", {"--over", folder / "photo.png", "--fov", "60"});
    const Picture black = render("d.png", {"--size", "48x32", "--fov", "60", "--background", "black"});
    REQUIRE(same_size(over, photo));
    CHECK(std::equal(over.pixel(0, 0), over.pixel(0, 0) + 3, photo.pixel(0, 0)));
    CHECK(over.rgb != photo.rgb);
    for (size_t i = 0; i < over.rgb.size(); ++i) CHECK(int{over.rgb[i]} + 1 >= int{black.rgb[i]});

    test::write_content(folder / "pose.txt", "1 0 0 0 0 1 0 0 0 0 1 0.5 0 0 0 1");
    check_refused(test::lumi({"render", folder / "f.lumi", "-o", folder / "e.png", "--pose", folder / "pose.txt"}), 1,
                  "lies in the sphere");
    CHECK_FALSE(std::filesystem::exists(folder / "e.png"));
}

}  // namespace lumi::tools
