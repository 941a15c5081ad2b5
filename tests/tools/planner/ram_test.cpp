// SPDX-License-Identifier: MIT
// RAM and stack of fields.
#include "planner/speed.h"

#include <catch2/catch.hpp>

#include "support/small_surface.h"
#include "support/temporary_folder.h"
#include "support/test_field.h"

namespace lumi::planner
{

namespace
{

bool is_proven(const std::string& limit, uint32_t bytes)
{
    static const std::string tests = tools::test::content_of(LUMI_CROSS_TESTS_FILE);
    return tests.find("set(" + limit + " " + std::to_string(bytes) + ")") != std::string::npos;
}

}  // namespace

TEST_CASE("the stack that is told is the one that tests of boards prove")
{
    CHECK(is_proven("LUMI_SURFACE_STACK_LIMIT", kSurfaceStackBytes));
    CHECK(is_proven("LUMI_SPAN_STACK_LIMIT", kSpanStackBytes));
    CHECK(is_proven("LUMI_STACK_LIMIT", kExactStackBytes));
}

TEST_CASE("RAM grows with mode and screen, and for chord fields with the stripe alone")
{
    const tools::test::TemporaryFolder folder;
    tools::test::write_content(folder / "s.lumi", tools::test::small_surface_bytes());
    tools::test::write_content(folder / "c.lumi", tools::test::field_bytes({100, 120, 100}));
    const tools::FieldFile surface(folder / "s.lumi"), chord(folder / "c.lumi");
    const host::ScreenSize large = {466, 466, 16}, low = {466, 466, 4};
    const Ram fast = ram_of(surface, SurfaceMode::one_sample, large),
              fine = ram_of(surface, SurfaceMode::two_by_two, large);
    CHECK(fast.view < fine.view);
    CHECK(fast.stripe == fine.stripe);
    CHECK(ram_of(surface, SurfaceMode::two_by_two, low).view < fine.view);
    CHECK(ram_of(surface, SurfaceMode::two_by_two, {240, 240, 16}).all() < fine.all());
    CHECK(ram_of(chord, {}, large).view == ram_of(chord, {}, low).view);
    CHECK(ram_of(chord, {}, large).stripe == 466 * 16 * 2);
    CHECK(stack_of(surface) == kSurfaceStackBytes);
    CHECK(stack_of(chord) == kSpanStackBytes);
}

}  // namespace lumi::planner
