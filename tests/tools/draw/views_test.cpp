// SPDX-License-Identifier: MIT
#include "draw/views.h"

#include <catch2/catch.hpp>

#include "image/picture_file.h"
#include "support/temporary_folder.h"
#include "terminal/failure.h"

namespace lumi::tools
{

namespace
{

// Draws flat pictures whose grey is the number of the call.
struct CountingDrawer {
    uint8_t calls = 0;
    std::vector<Camera> cameras;

    Picture operator()(const Eye& eye, const Rgb8&)
    {
        cameras.push_back(eye.camera);
        ++calls;
        return Picture(eye.image.width_px, eye.image.height_px, {calls, calls, calls});
    }
};

ViewOptions small_views()
{
    ViewOptions options;
    options.width_px = 12;
    options.height_px = 8;
    return options;
}

}  // namespace

TEST_CASE("one view is written to the output itself")
{
    const test::TemporaryFolder folder;
    CountingDrawer drawer;
    const auto written = write_views(small_views(), folder / "a.png", std::ref(drawer));
    CHECK(written == std::vector<std::string>{folder / "a.png"});
    CHECK(read_png(folder / "a.png").pixel(0, 0)[0] == 1);
    CHECK(folder.entries() == 1);
}

TEST_CASE("a turntable in one file holds a frame for each view, and turns in four seconds")
{
    const test::TemporaryFolder folder;
    uint8_t grey = 0;
    const Drawer drawer = [&grey](const Eye& eye, const Rgb8&) {
        grey = static_cast<uint8_t>(grey + 60);  // frames that look alike become one
        return Picture(eye.image.width_px, eye.image.height_px, {grey, grey, grey});
    };
    ViewOptions options = small_views();
    CHECK_THROWS_AS(write_views(options, folder / "a.webp", drawer), UsageError);
    options.turntable = 4;
    CHECK(write_views(options, folder / "a.webp", drawer) == std::vector<std::string>{folder / "a.webp"});
    CHECK(folder.entries() == 1);
    const std::string bytes = test::content_of(folder / "a.webp");
    REQUIRE(bytes.substr(0, 4) == "RIFF");
    size_t frames = 0;
    for (size_t at = bytes.find("ANMF"); at != std::string::npos; at = bytes.find("ANMF", at + 1)) {
        constexpr size_t kDurationAt = 8 + 12;  // behind the chunk's head: place and size, then milliseconds in 24 bits
        const auto byte = [&](size_t k) { return static_cast<unsigned char>(bytes[at + kDurationAt + k]); };
        CHECK((byte(0) | byte(1) << 8 | byte(2) << 16) == 1000);
        ++frames;
    }
    CHECK(frames == 4);

    constexpr size_t kFlagsAt = 20;  // of the file's head, VP8X
    constexpr int kHasAlpha = 0x10;
    CHECK((bytes[kFlagsAt] & kHasAlpha) == 0);
    options.background.kind = Background::Kind::none;
    write_views(options, folder / "b.webp", [&](const Eye& eye, const Rgb8& background) {
        if (background.r == 0) grey = static_cast<uint8_t>(grey + 60);
        Picture picture(eye.image.width_px, eye.image.height_px, background);
        std::fill_n(picture.pixel(0, 0), 3 * 12 * 4, grey);
        return picture;
    });
    const std::string alone = test::content_of(folder / "b.webp");
    CHECK((alone[kFlagsAt] & kHasAlpha) != 0);
    CHECK(alone.find("ALPH") != std::string::npos);
}

TEST_CASE(
    "over the gradient an object keeps its colours, and beside it every pixel is a dark grey, lighter in the middle")
{
    const test::TemporaryFolder folder;
    ViewOptions options = small_views();
    options.background.kind = Background::Kind::gradient;
    for (const DisplayFormat display : {DisplayFormat::rgb888, DisplayFormat::rgb565}) {
        const auto drawer = [](const Eye& eye, const Rgb8& background) {
            Picture picture(eye.image.width_px, eye.image.height_px, background);
            picture.pixel(4, 4)[0] = picture.pixel(4, 4)[1] = picture.pixel(4, 4)[2] = 0;
            return picture;
        };
        write_views(options, folder / "a.png", drawer, display);
        const Picture picture = read_png(folder / "a.png");
        for (size_t i = 0; i < picture.rgb.size(); ++i) {
            const bool is_object = i / 3 == 4 * 12 + 4;
            CHECK((is_object ? picture.rgb[i] == 0 : picture.rgb[i] >= 33 && picture.rgb[i] <= 107));
        }
        CHECK(picture.pixel(6, 4)[1] > picture.pixel(0, 0)[1] + 50);
    }
}

TEST_CASE("a turntable writes numbered pictures and a contact sheet")
{
    const test::TemporaryFolder folder;
    CountingDrawer drawer;
    ViewOptions options = small_views();
    options.turntable = 4;
    const auto written = write_views(options, folder / "a.png", std::ref(drawer));
    CHECK(written == std::vector<std::string>{folder / "a-000.png", folder / "a-001.png", folder / "a-002.png",
                                              folder / "a-003.png", folder / "a-sheet.png"});
    CHECK(folder.entries() == 5);
    CHECK(read_png(folder / "a-002.png").pixel(0, 0)[0] == 3);
    CHECK(read_png(folder / "a-sheet.png").pixel(0, 0)[0] == 1);
}

TEST_CASE("a turntable that stops leaves every earlier picture as it was")
{
    const test::TemporaryFolder folder;
    for (const char* name : {"a-000.png", "a-003.png", "a-sheet.png"}) test::write_content(folder / name, "old");
    ViewOptions options = small_views();
    options.turntable = 4;
    CountingDrawer drawer;
    int views = 0;
    const auto stopping = [&](const Eye& eye, const Rgb8& background) {
        if (++views == 4) throw Interrupted();
        return drawer(eye, background);
    };
    CHECK_THROWS_AS(write_views(options, folder / "a.png", stopping), Interrupted);
    for (const char* name : {"a-000.png", "a-003.png", "a-sheet.png"}) CHECK(test::content_of(folder / name) == "old");
    CHECK(folder.entries() == 3);
}

TEST_CASE("a turntable's eyes stand evenly around the vertical axis")
{
    const test::TemporaryFolder folder;
    CountingDrawer drawer;
    ViewOptions options = small_views();
    options.orbit = {0, 0, 3};
    options.turntable = 4;
    write_views(options, folder / "a.png", std::ref(drawer));
    const double expected[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    for (size_t i = 0; i < 4; ++i) {
        CHECK(drawer.cameras[i].eye_direction().x / double(kOneQ30) == Approx(expected[i][0]).margin(1e-6));
        CHECK(drawer.cameras[i].eye_direction().y / double(kOneQ30) == Approx(expected[i][1]).margin(1e-6));
    }
}

TEST_CASE("a camera that cannot be is refused before anything is drawn")
{
    const test::TemporaryFolder folder;
    CountingDrawer drawer;
    ViewOptions inside = small_views(), wide = small_views();
    inside.orbit.distance = 1;
    wide.fov_deg = 150;
    CHECK_THROWS_AS(write_views(inside, folder / "a.png", std::ref(drawer)), UsageError);
    CHECK_THROWS_AS(write_views(wide, folder / "a.png", std::ref(drawer)), UsageError);
    CHECK_THROWS_AS(write_views(small_views(), folder / "none/a.png", std::ref(drawer)), Failure);
    CHECK(drawer.calls == 0);
    CHECK(folder.entries() == 0);
}

}  // namespace lumi::tools
