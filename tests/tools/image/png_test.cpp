// SPDX-License-Identifier: MIT
#include "image/png.h"

#include <catch2/catch.hpp>

#include "support/temporary_folder.h"
#include "support/test_pictures.h"
#include "terminal/failure.h"

namespace lumi::tools
{

TEST_CASE("a picture written as PNG reads back byte for byte, for any shape")
{
    const test::TemporaryFolder folder;
    for (const auto& [width, height] : {std::make_pair(1, 1), std::make_pair(3, 200), std::make_pair(257, 2)}) {
        const Picture picture = test::random_picture(width, height, 8);
        write_png(folder / "a.png", picture);
        const Picture read = read_png(folder / "a.png");
        CHECK(same_size(picture, read));
        CHECK((picture.rgb == read.rgb));
    }
}

TEST_CASE("what is not a whole PNG is refused by name")
{
    const test::TemporaryFolder folder;
    write_png(folder / "whole.png", test::random_picture(20, 20, 1));
    const std::string whole = test::content_of(folder / "whole.png");
    for (const std::string& bytes : {std::string(), std::string("hello"), whole.substr(0, whole.size() / 2)}) {
        test::write_content(folder / "bad.png", bytes);
        CHECK_THROWS_WITH(read_png(folder / "bad.png"), Catch::Contains("bad.png"));
    }
    CHECK_THROWS_AS(read_png(folder / "missing.png"), Failure);
    CHECK_THROWS_AS(read_png(folder.path()), Failure);
}

}  // namespace lumi::tools
