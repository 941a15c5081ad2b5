// SPDX-License-Identifier: MIT
#include "bench/judge.h"

#include <catch2/catch.hpp>

#include "../../core/field_bytes.h"
#include "bench/host_renderer.h"

using namespace lumi;
using namespace lumi::bench;

namespace
{

// Every texel has a colour of its own, so that each wrong point shows.
test::Bytes speckled_file()
{
    test::TestLayout layout;
    layout.origins = layout.used_origins = 300;
    layout.directions = 500;
    const auto texel = [](uint32_t row, uint32_t k) {
        return static_cast<uint8_t>((row * 7919 + k) * 2654435761u >> 24);
    };
    return test::file_of({test::layout_section(layout), test::texel_section(layout, texel)});
}

}  // namespace

TEST_CASE("nearest by spans is judged by the points that are nearest, not by the cells of the spans", "[bench]")
{
    const test::Bytes file = speckled_file();
    Field field;
    REQUIRE(open_field(file.data(), static_cast<uint32_t>(file.size()), field) == FieldError::none);
    Judge judge(field);
    const View& view = kViews[0];
    Camera camera;
    REQUIRE(make_view_camera(view, camera) == CameraError::none);
    const tools::Picture drawn = draw_on_host("nearest", 4, field, file.data(), camera).picture;
    const Accuracy as_nearest = judge.judge("nearest", field, view, drawn);
    CHECK(as_nearest.psnr_db < 30);  // parallelograms hold other points also away from borders
    CHECK(judge.judge("nearest", field, view, draw_on_host("nearest", 0, field, file.data(), camera).picture).psnr_db >
          60);
}
