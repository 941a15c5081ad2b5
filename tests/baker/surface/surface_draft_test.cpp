// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "lumi/surface/format.h"
#include "surface/surface_scenes.h"

namespace lumi::baker::testing
{

TEST_CASE("A draft tells at most how many bytes a bake takes", "[surface]")
{
    const Scene scene = tiny_scene();
    SurfaceSettings settings = tiny_surface();
    const SurfaceDraft draft(scene, settings);
    const SurfaceBake bake = surface_field(scene, settings, {}, &draft);
    const uint64_t most = draft.most_bytes(settings.texels_per_radius);
    CHECK(draft.triangles() == bake.triangles);
    CHECK(draft.loss().missed == bake.loss.missed);
    CHECK(bake.file.size() <= most);
    // Most that is left is less than what finer codes take, or planned for tables that pay nothing.
    const uint64_t tables = detail::format::view_colours_bytes(3) + bake.vertices * detail::format::view_bytes(3);
    CHECK(most - bake.file.size() <= tables + detail::format::kEntryBytes + 2 * detail::format::kSectionAlignment);
    CHECK(draft.most_bytes(2 * settings.texels_per_radius) > most);
}

TEST_CASE("A bake from a draft is the bake without it", "[surface][repeated]")
{
    const Scene scene = tiny_scene();
    const SurfaceDraft draft(scene, tiny_surface());
    CHECK((surface_field(scene, tiny_surface(), {}, &draft).file == surface_field(scene, tiny_surface()).file));
}

}  // namespace lumi::baker::testing
