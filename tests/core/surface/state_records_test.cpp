// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <functional>

#include "lumi/surface/states.h"
#include "states_bytes.h"
#include "surface_drawing.h"
#include "truncation.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::test;

namespace
{

constexpr auto kWithoutStates = SurfaceFeatures::view_tables | SurfaceFeatures::see_through | SurfaceFeatures::parts;

FieldError opened(const Bytes& bytes)
{
    return OpenedGlass(bytes).error();
}

}  // namespace

TEST_CASE("light states open as they were written, and only a reader that names them reads them")
{
    const std::vector<TestState> states = four_states();
    for (const Bytes& file : {lit_ball_file(four_states()), lit_file(shaded_ball(9), four_states()),
                              lit_file(moving_ball(), four_states())}) {
        const OpenedGlass opened(file);
        REQUIRE(opened.error() == FieldError::none);
        CHECK(verify_field(file.data(), file.size()) == FieldError::none);
        REQUIRE(opened.field().state_count == states.size());
        for (uint32_t k = 0; k < states.size(); ++k) {
            const StateName name = state_name(opened.field(), k);
            CHECK(std::string(name.text, name.bytes) == states[k].name);
        }
        const Opened<kWithoutStates> without(file);
        REQUIRE(without.error() == FieldError::none);
        CHECK(without.field().states == nullptr);
        CHECK(feature_words(opened.field()) - feature_words(without.field()) ==
              state_words(4, opened.field().see_through_count));
    }
}

TEST_CASE("sections of light states that are wrong are refused by name, and no byte of them leads astray")
{
    const TestSurface s = ball_with_tables();
    const auto opened_with = [&](const std::function<void(Bytes&)>& change, uint32_t copies = 1) {
        std::vector<TestSection> sections = surface_sections(s);
        TestSection section = states_section(light_of(s, two_states()), false);
        change(section.bytes);
        sections.insert(sections.end(), copies, section);
        return opened(file_of(sections));
    };
    const size_t size = states_section(light_of(s, two_states()), false).bytes.size();
    for (size_t cut = 1; cut <= size; ++cut)
        if (opened_with([&](Bytes& b) { b.resize(size - cut); }) != FieldError::bad_states) FAIL_CHECK(cut);
    CHECK(opened_with([](Bytes& b) { b.push_back(0); }) == FieldError::bad_states);
    CHECK(opened_with([](Bytes&) {}) == FieldError::none);
    CHECK(opened_with([](Bytes&) {}, 2) == FieldError::duplicate_section);
    const auto with_byte = [&](size_t at, uint32_t value) {
        return opened_with([&](Bytes& b) { b[at] = static_cast<uint8_t>(value); });
    };
    for (const uint32_t count : {0u, 1u, 3u, 4u, 5u, 255u}) CHECK(with_byte(0, count) == FieldError::bad_states);
    for (size_t at = 2; at < 4; ++at) CHECK(with_byte(at, 1) == FieldError::bad_states);
    for (const uint32_t tints : {4u, 128u, 255u}) CHECK(with_byte(1, tints) == FieldError::bad_states);  // of no state
    CHECK(with_byte(1, 2) == FieldError::none);
    using namespace format;
    constexpr size_t kRecord = kStatesHeaderBytes;
    CHECK(with_byte(kRecord, 0) == FieldError::bad_states);      // no name
    CHECK(with_byte(kRecord + 2, 0) == FieldError::bad_states);  // "ba\0e"
    CHECK(with_byte(kRecord + state::kNameBytes - 1, 'x') == FieldError::bad_states);
    CHECK(with_byte(kRecord + state::kScaleAt, 15) == FieldError::bad_states);
    CHECK(with_byte(kRecord + state::kScaleAt, 255) == FieldError::none);
    for (size_t at = state::kDefaultAt; at < kStateBytes; ++at)
        CHECK(with_byte(kRecord + kStateBytes + at, 255) == FieldError::none);
    CHECK(opened(lit_ball_file({{"base"}, {std::string(state::kNameBytes, 'x')}})) == FieldError::none);
    CHECK(opened(lit_ball_file({5, {"x"}})) == FieldError::bad_states);
    check_other_sizes_are_refused(lit_ball_file(), opened);
}
