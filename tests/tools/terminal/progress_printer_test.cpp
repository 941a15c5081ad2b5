// SPDX-License-Identifier: MIT
#include "terminal/progress_printer.h"

#include <catch2/catch.hpp>
#include <cstdlib>

namespace lumi::tools
{

namespace
{

baker::Progress at(uint64_t done, double elapsed_seconds)
{
    baker::Progress progress;
    progress.rays_done = done;
    progress.rays_total = 1000;
    progress.rays_per_second = 1240000;
    progress.eta_seconds = 72;
    progress.elapsed_seconds = elapsed_seconds;
    return progress;
}

// Returns what a printer writes for these reports.
std::string printed(bool is_terminal, std::initializer_list<baker::Progress> reports, const char* step = "")
{
    char* text = nullptr;
    size_t size = 0;
    std::FILE* stream = open_memstream(&text, &size);
    {
        ProgressPrinter printer(stream, is_terminal, step);
        for (const baker::Progress& report : reports) printer.print(report);
    }
    std::fclose(stream);
    const std::string result(text, size);
    std::free(text);
    return result;
}

}  // namespace

TEST_CASE("progress says the share done, the pace and the time left")
{
    CHECK(progress_text(at(437, 3)) == "43 %  1.24 M rays/s  1:12 left");
    baker::Progress unknown;
    unknown.rays_total = 10;
    CHECK(progress_text(unknown) == "0 %");
}

TEST_CASE("works that follow each other have one share of the time, which never goes back, and one time left")
{
    const auto own = [](uint64_t done, double eta) {
        baker::Progress progress = at(done, 0);
        progress.eta_seconds = eta;
        return progress;
    };
    WholeTime time({2, 10, 1});
    baker::Progress whole = time.of(own(500, -1), 1);
    CHECK(whole.share == Approx(1 / (1.0 + 1 + 10 + 1)));
    CHECK(whole.eta_seconds < 0);
    time.begin(1);
    whole = time.of(own(100, 20), 5);
    CHECK(whole.share == Approx(5 / 26.0));
    CHECK(whole.eta_seconds == Approx(21));
    CHECK(progress_text(whole) == "19 %  light  1.24 M rays/s  0:21 left");
    CHECK(time.of(own(110, 30), 6).share == Approx(5 / 26.0));
    time.begin(2);
    CHECK(time.of(own(0, -1), 19).eta_seconds == Approx(1));
    CHECK(time.of(own(1000, 0), 20).share == 1);
}

TEST_CASE("a bar that is taken away leaves nothing on its line")
{
    char* text = nullptr;
    size_t size = 0;
    std::FILE* stream = open_memstream(&text, &size);
    {
        ProgressPrinter printer(stream, true);
        printer.print(at(0, 0));
        printer.clear();
    }
    std::fclose(stream);
    CHECK(std::string(text, size) == "\r[..............................] 0 %  1.24 M rays/s  1:12 left\x1b[K\r\x1b[K");
    std::free(text);
}

TEST_CASE("without a terminal a plain line comes at the beginning and every five seconds")
{
    CHECK(printed(false, {at(0, 0), at(100, 1), at(200, 4.9), at(300, 5), at(400, 6), at(1000, 7)}) ==
          "0 %  1.24 M rays/s  1:12 left\n30 %  1.24 M rays/s  1:12 left\n");
}

TEST_CASE("short jobs after the first one print no plain lines, long ones do")
{
    CHECK(printed(false, {at(0, 0), at(500, 12), at(1000, 13), at(0, 0), at(1000, 1), at(0, 0), at(700, 6)}) ==
          "0 %  1.24 M rays/s  1:12 left\n50 %  1.24 M rays/s  1:12 left\n70 %  1.24 M rays/s  1:12 left\n");
}

TEST_CASE("on a terminal one line redraws itself and ends with a line break")
{
    const std::string text = printed(true, {at(0, 0), at(500, 1)});
    CHECK(text ==
          "\r[..............................] 0 %  1.24 M rays/s  1:12 left\x1b[K"
          "\r[###############...............] 50 %  1.24 M rays/s  1:12 left\x1b[K\n");
}

TEST_CASE("a step of a longer job says which it is, and lines stay narrower than the terminal")
{
    CHECK(printed(false, {at(0, 0)}, "2 of 3 baking: ") == "2 of 3 baking: 0 %  1.24 M rays/s  1:12 left\n");
    const std::string text = printed(true, {at(500, 1)}, "2 of 3 baking, of a very long name: ");
    CHECK(text == "\r[#####.....] 2 of 3 baking, of a very long name: 50 %  1.24 M rays/s  1:12 left\x1b[K\n");
    const std::string much = std::string(100, 'x');
    CHECK(printed(true, {at(500, 1)}, much.c_str()) == "\r" + much.substr(0, 79) + "\x1b[K\n");
}

}  // namespace lumi::tools
