// SPDX-License-Identifier: MIT
#include "util/text_lines.h"

#include <catch2/catch.hpp>

#include "lumi/baker/scene.h"

namespace lumi::baker
{
namespace
{

std::vector<Line> split_lines(const std::string& text)
{
    std::vector<Line> result;
    Lines lines(text);
    for (Line line; lines.next(line);) result.push_back(line);
    return result;
}

}  // namespace

TEST_CASE("text lines: every line ending, comments, continuations and blanks")
{
    const std::vector<Line> lines =
        split_lines("\xEF\xBB\xBFv 1 2 3\r\n# note\r\n\n  f 1 2 \\\n 3 # end\rusemtl my # paint\nmap_Kd a#b.png");
    REQUIRE(lines.size() == 4);
    CHECK(lines[0].keyword == "v");
    CHECK(lines[0].argument == "1 2 3");
    CHECK(lines[0].number == 1);
    CHECK(words(lines[1].argument) == std::vector<std::string_view>{"1", "2", "3"});
    CHECK(lines[1].number == 4);
    CHECK(lines[2].argument == "my");
    CHECK(lines[2].number == 6);
    CHECK(lines[3].argument == "a#b.png");
    CHECK(lines[3].number == 7);
    CHECK(split_lines("").empty());
    CHECK(split_lines("\\").empty());
    CHECK(split_lines("\\\n").empty());
}

TEST_CASE("text lines: a line of a million pieces is read in a time that grows with its length alone")
{
    constexpr size_t kPieces = 1000000;
    std::string text = "f";
    for (size_t k = 0; k < kPieces; ++k) text += "\\\n1 ";
    const std::vector<Line> lines = split_lines(text + "\\\n\nv");
    REQUIRE(lines.size() == 2);
    CHECK(words(lines[0].argument).size() == kPieces);
    CHECK(lines[1].number == kPieces + 3);
}

TEST_CASE("text lines: numbers are finite or none")
{
    double v = 0;
    for (const char* good : {"1", "-1.5", "+2e3", ".5", "1e-300"}) CHECK(parse_finite(good, v));
    for (const char* bad : {"nan", "-nan", "inf", "-INF", "1e999", "1,5", "1.5x", "", "+", "0x10"}) {
        INFO(bad);
        CHECK_FALSE(parse_finite(bad, v));
    }
    int64_t i = 0;
    CHECK(parse_integer("-12", i));
    CHECK(i == -12);
    CHECK_FALSE(parse_integer("1.5", i));
    CHECK_FALSE(parse_integer("99999999999999999999", i));
}

TEST_CASE("text lines: a message that quotes a file holds nothing that terminals obey, and is told to its end")
{
    CHECK(at({"m.ply", 2}, {"the format a\0b\x1b[2Jc; write ascii", 32}) ==
          "m.ply:2: the format a?b?[2Jc; write ascii");
}

TEST_CASE("text lines: an unreadable file and a folder are named")
{
    CHECK_THROWS_WITH(read_text("no/such/file.obj"), Catch::Contains("no/such/file.obj: the file cannot be opened"));
    CHECK_THROWS_WITH(read_text("."), Catch::Contains("this is a folder"));
}

}  // namespace lumi::baker
