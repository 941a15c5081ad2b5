// SPDX-License-Identifier: MIT
#include "terminal/progress_printer.h"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

namespace lumi::tools
{

namespace
{

baker::Progress report_at(uint64_t done, double elapsed_seconds, double eta_seconds = 9.5)
{
    return {done, 1000, 124, eta_seconds, elapsed_seconds, done / 4};
}

std::vector<nlohmann::json> printed(std::initializer_list<baker::Progress> reports)
{
    char* text = nullptr;
    size_t size = 0;
    std::FILE* stream = open_memstream(&text, &size);
    JsonProgress printer(stream);
    for (const baker::Progress& report : reports) printer.print(report);
    std::fclose(stream);
    std::istringstream lines(std::string(text, size));
    std::free(text);
    std::vector<nlohmann::json> result;
    for (std::string line; std::getline(lines, line);) result.push_back(nlohmann::json::parse(line));
    return result;
}

}  // namespace

TEST_CASE("a line of JSON says what is done, the pace and the time left, null while unknown")
{
    const auto line = nlohmann::json::parse(progress_json(report_at(437, 3)));
    CHECK(line == nlohmann::json{{"state", "baking"},
                                 {"stage", "light"},
                                 {"rays_done", 437},
                                 {"rays_total", 1000},
                                 {"rays_saved", 109},
                                 {"rays_per_second", 124.0},
                                 {"eta_seconds", 9.5},
                                 {"elapsed_seconds", 3.0}});
    CHECK(nlohmann::json::parse(progress_json(report_at(0, 0, -1))).at("eta_seconds").is_null());
}

TEST_CASE("JSON lines come at the beginning, once a second, and once at the end")
{
    const auto lines = printed({report_at(0, 0), report_at(10, 0.5), report_at(20, 0.99), report_at(30, 1),
                                report_at(40, 1.9), report_at(50, 2.1), report_at(1000, 2.2), report_at(1000, 9)});
    REQUIRE(lines.size() == 4);
    CHECK(lines[1].at("rays_done") == 30);
    CHECK(lines[2].at("rays_done") == 50);
    CHECK(lines[3].at("rays_done") == 1000);
}

}  // namespace lumi::tools
