// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <functional>

#include "parts_bytes.h"
#include "surface/owners.h"
#include "surface_drawing.h"
#include "truncation.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::test;

namespace
{

FieldError opened(const Bytes& bytes)
{
    return OpenedGlass(bytes).error();
}

// The section whose number at a place of record 0 is another.
FieldError opened_with(uint32_t at, uint32_t bytes, uint32_t value)
{
    TestMover m = moving_ball();
    for (uint32_t k = 0; k < bytes; ++k)
        m.section[format::kPartsHeaderBytes + at + k] = static_cast<uint8_t>(value >> 8 * k);
    return opened(mover_file(m));
}

FieldError opened_part(const std::function<void(TestPart&)>& change)
{
    std::vector<TestPart> parts = three_parts();
    change(parts[2]);
    return opened(mover_file(mover(ball(2, 0), parts)));
}

}  // namespace

TEST_CASE("moving parts open as they were written, with glass and without")
{
    const std::vector<TestPart> parts = three_parts();
    for (const uint32_t glass : {0u, 7u}) {
        const OpenedGlass opened(mover_file(moving_ball(glass)));
        REQUIRE(opened.error() == FieldError::none);
        CHECK(verify_field(opened.bytes().data(), opened.bytes().size()) == FieldError::none);
        const SurfaceField& field = opened.field();
        REQUIRE(field.part_count == parts.size());
        CHECK(field.see_through_count == glass);
        for (uint32_t k = 0; k < parts.size(); ++k) {
            const PartMotion motion = part_motion(field, k);
            const PartName name = part_name(field, k);
            CHECK(std::string(name.text, name.bytes) == parts[k].name);
            CHECK(motion.slides == parts[k].slides);
            CHECK(motion.from == parts[k].from);
            CHECK(motion.span == parts[k].span);
            CHECK(motion.axis.z == rounded(parts[k].axis[2], 0x1p30));
            CHECK(motion.pivot.y == rounded(parts[k].pivot[1], 0x1p20));
            const OwnerRanges ranges = owner_ranges(field, k + 1);
            const TestSurface& mesh = parts[k].mesh;
            CHECK(ranges.viewed.end - ranges.viewed.begin == mesh.viewed);
            CHECK(ranges.plain.end - ranges.plain.begin == mesh.vertices.size() - mesh.viewed);
            CHECK(ranges.patches.end - ranges.patches.begin == mesh.patches.size());
        }
    }
}

TEST_CASE("moving parts and glass are refused by name where nothing draws them")
{
    SurfaceField field;
    const auto opened_as = [&](auto features, uint32_t glass) {
        const Bytes file = mover_file(moving_ball(glass));
        return open_surface<decltype(features)::value>(file.data(), file.size(), field);
    };
    using Plain = std::integral_constant<SurfaceFeatures, SurfaceFeatures::view_tables>;
    using Glass = std::integral_constant<SurfaceFeatures, SurfaceFeatures::view_tables | SurfaceFeatures::see_through>;
    using Parts = std::integral_constant<SurfaceFeatures, SurfaceFeatures::view_tables | SurfaceFeatures::parts>;
    CHECK(opened_as(Plain{}, 0) == FieldError::parts);
    CHECK(opened_as(Glass{}, 0) == FieldError::parts);
    CHECK(opened_as(Glass{}, 7) == FieldError::parts);
    CHECK(opened_as(Plain{}, 7) == FieldError::see_through);
    CHECK(opened_as(Parts{}, 7) == FieldError::see_through);
    CHECK(field.vertices == nullptr);
    CHECK(opened_as(Parts{}, 0) == FieldError::none);
    CHECK(std::string(describe(FieldError::parts)).find("SPRT") != std::string::npos);
}

TEST_CASE("sections of moving parts of the wrong length are refused")
{
    check_other_sizes_are_refused(mover_file(moving_ball()), opened);
    const auto resized = [](const std::function<void(Bytes&)>& change) {
        TestMover m = moving_ball();
        change(m.section);
        return opened(mover_file(m));
    };
    for (size_t size = 0; size < moving_ball().section.size(); ++size)
        if (resized([&](Bytes& b) { b.resize(size); }) != FieldError::bad_parts) FAIL_CHECK(size << " bytes");
    CHECK(resized([](Bytes& b) { b.push_back(0); }) == FieldError::bad_parts);
    CHECK(resized([](Bytes& b) { b.assign(4, 0); }) == FieldError::bad_parts);
    CHECK(resized([](Bytes& b) { b[2] = 1; }) == FieldError::bad_parts);
    const TestPart one = {ball(1, 0)};
    CHECK(opened(mover_file(mover(ball(1, 0), std::vector<TestPart>(16, one)))) == FieldError::none);
    CHECK(opened(mover_file(mover(ball(1, 0), std::vector<TestPart>(17, one)))) == FieldError::bad_parts);
}

TEST_CASE("numbers of moving parts that are out of range are refused")
{
    using namespace format;
    for (const uint32_t at : {part::kFirstViewedAt, part::kFirstPlainAt, part::kFirstPatchAt})
        for (const uint32_t first : {0u, 1u, 0x7FFFu, 0xFFFFu}) CHECK(opened_with(at, 2, first) != FieldError::none);
    CHECK(opened_with(part::kMotionAt, 1, 3) == FieldError::bad_parts);
    CHECK(opened_with(part::kFollowsAt, 1, 1) == FieldError::bad_parts);
    CHECK(opened_with(part::kAxisAt, 4, 1u << 24) == FieldError::none);  // it becomes longer by 2^-13
    CHECK(opened_with(part::kAxisAt, 4, 1u << 26) == FieldError::bad_parts);
    CHECK(opened_with(part::kAxisAt + 8, 4, 0x80000000) == FieldError::bad_parts);
    CHECK(opened_with(part::kAxisAt + 8, 4, 0) == FieldError::bad_parts);
    CHECK(opened_with(part::kPivotAt, 4, 2u << 20) == FieldError::none);
    CHECK(opened_with(part::kPivotAt, 4, (2u << 20) + 1) == FieldError::bad_parts);
    CHECK(opened_with(part::kPivotAt + 8, 4, static_cast<uint32_t>(-(2 << 20) - 1)) == FieldError::bad_parts);
    CHECK(opened_with(part::kNameAt, 1, 0) == FieldError::bad_parts);
    CHECK(opened_with(part::kNameAt + 2, 1, 0) == FieldError::bad_parts);  // "mo\0n"
    CHECK(opened_part([](TestPart& p) { p.name = std::string(40, 'x'); }) == FieldError::none);
    CHECK(opened_part([](TestPart& p) { p.from = -(2 << 20); }) == FieldError::none);
    CHECK(opened_part([](TestPart& p) { p.from = -(2 << 20) - 1; }) == FieldError::bad_parts);
    CHECK(opened_part([](TestPart& p) { p.span = (2 << 20) + (1 << 16); }) == FieldError::none);
    CHECK(opened_part([](TestPart& p) { p.span = (2 << 20) + (1 << 16) + 1; }) == FieldError::bad_parts);
    CHECK(opened_part([](TestPart& p) { p.mesh.patches.clear(); }) == FieldError::bad_parts);
    CHECK(opened(mover_file(mover({}, three_parts()))) == FieldError::none);  // no body
}

TEST_CASE("patches of moving parts that have others' vertices or neighbours are refused")
{
    const TestMover plain = moving_ball(7);
    const auto first_of_parts = static_cast<uint32_t>(BumpyBall(4).take().patches.size()) - 7;
    const auto with_corner = [&](uint32_t patch, uint32_t vertex) {
        TestMover m = plain;
        m.all.patches[patch].c = vertex;
        m.all.has_neighbours = false;
        return opened(mover_file(m));
    };
    const uint32_t of_body = plain.all.patches[0].a, of_part = plain.all.patches[first_of_parts].a;
    CHECK(with_corner(1, of_body) == FieldError::none);
    CHECK(with_corner(1, of_part) == FieldError::bad_parts);
    CHECK(with_corner(first_of_parts, of_part) == FieldError::none);
    CHECK(with_corner(first_of_parts, of_body) == FieldError::bad_parts);
    CHECK(with_corner(plain.opaque, of_body) == FieldError::none);
    CHECK(with_corner(plain.opaque, of_part) == FieldError::bad_parts);
    const auto with_neighbour = [&](uint32_t patch, uint32_t triangle) {
        std::vector<TestSection> sections = mover_sections(plain);
        for (TestSection& s : sections)
            if (s.type == format::kNeighbourSection)
                for (uint32_t k = 0; k < 2; ++k)
                    s.bytes[patch * format::kNeighbourBytes + k] = static_cast<uint8_t>(triangle >> 8 * k);
        return opened(file_of(sections));
    };
    CHECK(with_neighbour(0, 2 * first_of_parts - 1) == FieldError::none);
    CHECK(with_neighbour(0, 2 * first_of_parts) == FieldError::bad_neighbours);
    CHECK(with_neighbour(first_of_parts, 2 * first_of_parts + 1) == FieldError::none);
    CHECK(with_neighbour(first_of_parts, 2 * first_of_parts - 1) == FieldError::bad_neighbours);
}

TEST_CASE("shadows follow parts that move by themselves, and stand last")
{
    const auto opened_shaded = [](const std::function<void(std::vector<TestPart>&)>& change) {
        std::vector<TestPart> parts = parts_with_shadows();
        change(parts);
        return opened(mover_file(mover(ball(2, 0), parts)));
    };
    CHECK(opened_shaded([](auto&) {}) == FieldError::none);
    CHECK(opened_shaded([](auto& parts) { parts[4].follows = 4; }) == FieldError::bad_parts);
    CHECK(opened_shaded([](auto& parts) { parts[4].follows = 6; }) == FieldError::bad_parts);
    CHECK(opened_shaded([](auto& parts) { parts[4].follows = 1; }) == FieldError::bad_parts);  // it slides
    CHECK(opened_shaded([](auto& parts) { parts[3].name = "x"; }) == FieldError::bad_parts);
    CHECK(opened_shaded([](auto& parts) { parts[2].name = ""; }) == FieldError::bad_parts);
    CHECK(opened_shaded([](auto& parts) { std::swap(parts[2], parts[3]); }) == FieldError::bad_parts);
    CHECK(opened_shaded([](auto& parts) { parts[3].mesh.viewed = 1; }) == FieldError::bad_parts);
    CHECK(opened_shaded([](auto& parts) { parts.erase(parts.begin(), parts.begin() + 3); }) == FieldError::bad_parts);
}
