// SPDX-License-Identifier: MIT
#include "bench/surface_reads.h"

#include <catch2/catch.hpp>

#include "support/small_surface.h"
#include "support/temporary_folder.h"

using namespace lumi;
using namespace lumi::bench;

namespace
{

struct Range {
    uint32_t begin, end;
    bool holds(const Read& read) const { return read.address >= begin && read.address + read.bytes <= end; }
};

Range range_of(const tools::FieldFile& file, const uint8_t* at, uint32_t bytes)
{
    const auto begin = static_cast<uint32_t>(at - file.bytes());
    return {begin, begin + bytes};
}

size_t count_in(const std::vector<Read>& reads, const Range& range)
{
    return static_cast<size_t>(std::count_if(
        reads.begin(), reads.end(), [&](const Read& read) { return range.holds(read); }));
}

}  // namespace

TEST_CASE("what a frame reads are vertices, patches, view tables and a texel for each sample", "[bench]")
{
    const tools::test::TemporaryFolder folder;
    tools::test::write_content(folder / "cube.lumi", tools::test::small_surface_bytes());
    const tools::FieldFile file(folder / "cube.lumi");
    const SurfaceField& field = file.surface();
    const Range vertices = range_of(file, field.vertices, field.vertex_count * detail::format::kVertexBytes);
    const Range patches = range_of(file, field.patches, field.patch_count * detail::format::kPatchBytes);
    const Range views = range_of(file, field.views, field.viewed_count * detail::format::view_bytes(field.code_bits));
    const Range texels = range_of(file, field.texels, field.texel_bytes);

    const std::vector<Read> one = reads_of(file, kViews[0], SurfaceMode::one_sample);
    const std::vector<Read> four = reads_of(file, kViews[0], SurfaceMode::two_by_two);
    for (const auto& reads : {one, four}) {
        CHECK(count_in(reads, vertices) == field.vertex_count);
        CHECK(count_in(reads, views) <= field.viewed_count);
        CHECK(count_in(reads, patches) > field.patch_count);
        CHECK(count_in(reads, vertices) + count_in(reads, views) + count_in(reads, patches) + count_in(reads, texels) ==
              reads.size());
    }
    // The cube fills some part of the sphere's 42,272 pixels.
    CHECK(count_in(one, texels) > 10'000);
    CHECK(count_in(one, texels) < 42'272);
    CHECK(static_cast<double>(count_in(four, texels)) ==
          Approx(4 * static_cast<double>(count_in(one, texels))).epsilon(0.01));
}
