// SPDX-License-Identifier: MIT
#include "terminal/text.h"

#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>

namespace lumi::tools
{

TEST_CASE("sizes are two positive numbers around an x")
{
    REQUIRE(parse_size("320x200"));
    CHECK(parse_size("320x200")->width_px == 320);
    CHECK(parse_size("320x200")->height_px == 200);
    for (const char* wrong : {"", "x", "320", "320x", "x200", "0x5", "-1x5", "3x5x7", "3 x5", "3.5x5", "99999999999x5"})
        CHECK_FALSE(parse_size(wrong));
}

TEST_CASE("triples are three finite numbers between commas")
{
    REQUIRE(parse_triple("30,-20.5,3e0"));
    CHECK(*parse_triple("30,-20.5,3e0") == std::array<double, 3>{30, -20.5, 3});
    for (const char* wrong : {"", ",,", "1,2", "1,2,", "1,2,3,4", "1;2;3", "1,2,x", "1,2,inf", "nan,2,3", "1, 2,3"})
        CHECK_FALSE(parse_triple(wrong));
}

TEST_CASE("colours are six hexadecimal digits")
{
    REQUIRE(parse_colour("ff8001"));
    CHECK(parse_colour("ff8001")->r == 255);
    CHECK(parse_colour("#FF8001")->g == 128);
    CHECK(parse_colour("ff8001")->b == 1);
    for (const char* wrong : {"", "#", "fff", "ff80011", "ff800g", "##ff800", "-f8001", "0xff80"})
        CHECK_FALSE(parse_colour(wrong));
}

TEST_CASE("a cap is a number of origins, or a share with a point or a per cent sign")
{
    CHECK(parse_cap("512", 1024) == 512u);
    CHECK(parse_cap("1024", 1024) == 1024u);
    CHECK(parse_cap("50%", 1024) == 512u);
    CHECK(parse_cap("0.5", 1023) == 512u);  // rounded up
    CHECK(parse_cap("1.0", 7) == 7u);
    CHECK(parse_cap("100%", 7) == 7u);
    CHECK(parse_cap("0.0001", 7) == 1u);
    for (const char* wrong : {"", "0", "1", "1025", "-1", "0.0", "1.1", "101%", "%", ".", "half", "5 %"})
        CHECK_FALSE(parse_cap(wrong, 1024));
}

TEST_CASE("quantities read with three digits in the largest fitting unit")
{
    CHECK(byte_text(0) == "0 bytes");
    CHECK(byte_text(999) == "999 bytes");
    CHECK(byte_text(1000) == "1.00 kB");
    CHECK(byte_text(999499) == "999 kB");
    CHECK(byte_text(999999) == "1.00 MB");
    CHECK(byte_text(4202496) == "4.20 MB");
    CHECK(byte_text(33600000) == "33.6 MB");
    CHECK(byte_text(9996000) == "10.0 MB");
    CHECK(byte_text(4000000000) == "4.00 GB");
    CHECK(count_text(1240000) == "1.24 M");
    CHECK(count_text(12) == "12");
}

TEST_CASE("words of a command are quoted where a shell needs it")
{
    CHECK(shell_word("fields/clock-2.lumi") == "fields/clock-2.lumi");
    CHECK(shell_word("my clock.lumi") == "'my clock.lumi'");
    CHECK(shell_word("$HOME;rm") == "'$HOME;rm'");
    CHECK(shell_word("Tom's.lumi") == "'Tom'\\''s.lumi'");
    CHECK(shell_word("") == "''");
}

TEST_CASE("durations read as clocks do")
{
    CHECK(duration_text(0.4) == "0:00");
    CHECK(duration_text(59.6) == "1:00");
    CHECK(duration_text(102) == "1:42");
    CHECK(duration_text(7389) == "2:03:09");
}

TEST_CASE("a part of a count is two whole numbers, the first from 1 to the second")
{
    for (const char* wrong : {"", "3", "/", "3/", "/3", "0/3", "4/3", "-1/3", "1/3 ", "1/3/4", "a/b", "1/99999999999"})
        CHECK(!parse_part(wrong));
    REQUIRE(parse_part("3/16"));
    CHECK(parse_part("3/16")->part == 3);
    CHECK(parse_part("3/16")->count == 16);
    CHECK(parse_part("1/1"));
}

TEST_CASE("no control character of a name reaches a terminal, and all else does")
{
    CHECK(visible("a\x1b]0;b\x07\x7f\x9b\r\n") == "a?]0;b????\n");
    CHECK(visible("\xc2\x9bm \xc3\x9f \xc2\xb5") == "?m \xc3\x9f \xc2\xb5");
    CHECK(visible("\xc2") == "\xc2");
    CHECK(visible("\xe2\x82\x9b \xf0\x9f\x98\x80 \xe9\x9b") == "\xe2\x82\x9b \xf0\x9f\x98\x80 \xe9\x9b");
    CHECK(visible("\x80\xe2\x82\x9b\x9f \xff\x9b") == "?\xe2\x82\x9b? \xff?");
}

TEST_CASE("what is printed is visible, however long it is")
{
    for (const size_t size : {1022u, 1023u, 1024u, 5000u}) {
        const std::string name = std::string(size, 'n') + "\x1b\n";
        char* bytes = nullptr;
        size_t count = 0;
        std::FILE* const stream = open_memstream(&bytes, &count);
        print(stream, "%s%d", name.c_str(), 7);
        std::fclose(stream);
        CHECK((std::string(bytes, count) == std::string(size, 'n') + "?\n7"));
        std::free(bytes);
    }
}

}  // namespace lumi::tools
