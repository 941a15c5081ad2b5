// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "lumi/surface/format.h"
#include "surface/surface_scenes.h"

namespace lumi::baker::testing
{

TEST_CASE("A draft tells at most how many bytes a bake takes, and how many exactly with a table at every vertex",
          "[surface]")
{
    const Scene scene = tiny_scene();
    SurfaceSettings settings = tiny_surface();
    const SurfaceDraft draft(scene, settings);
    const SurfaceBake bake = surface_field(scene, settings, {}, &draft);
    const uint64_t most = draft.most_bytes(settings.texels_per_radius);
    CHECK(draft.triangles() == bake.triangles);
    CHECK(draft.loss().missed == bake.loss.missed);
    CHECK(bake.file.size() <= most);
    const uint64_t untabled = (bake.vertices - bake.viewed_vertices) * detail::format::kViewBytes;
    const uint64_t no_table =
        bake.viewed_vertices == 0 ? detail::format::kViewColoursBytes + detail::format::kEntryBytes : 0;
    CHECK(most - bake.file.size() <= untabled + no_table + 2 * detail::format::kSectionAlignment);
    CHECK(draft.most_bytes(2 * settings.texels_per_radius) > most);
}

TEST_CASE("A bake from a draft is the bake without it", "[surface][repeated]")
{
    const Scene scene = tiny_scene();
    const SurfaceDraft draft(scene, tiny_surface());
    CHECK((surface_field(scene, tiny_surface(), {}, &draft).file == surface_field(scene, tiny_surface()).file));
}

}  // namespace lumi::baker::testing
